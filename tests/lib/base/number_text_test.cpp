#include "lib/base/number_text.h"

#include <gtest/gtest.h>

#include <random>

namespace gouge {
namespace {

TEST(ParseNumber, TakesWhatCamSystemsWrite) {
  EXPECT_EQ(parse_number("25."), 25.0);
  EXPECT_EQ(parse_number(".647402"), .647402);
  EXPECT_EQ(parse_number("-0.142874"), -0.142874);
  EXPECT_EQ(parse_number("+1e-7"), 1e-7);
  EXPECT_EQ(parse_number("1E3"), 1000.0);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
}

TEST(ParseNumber, RefusesWhatIsNotWhollyAFiniteNumber) {
  for (const char* text :
       {"", "-", ".", "1.2.3", "nan", "inf", "-inf", "1e400", "0x10", "1 ", " 1", "1,5", "+-1", "e5", "1e"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
}

TEST(ExactText, ReadsBackAsTheSameNumber) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1e4, 1e4);
  for (int i = 0; i < 10000; ++i) {
    const double x = any(random);
    EXPECT_EQ(parse_number(exact_text(x)), x);
  }
  EXPECT_EQ(exact_text(-0.0), "0");
}

TEST(FixedText, NeverWritesANegativeZero) {
  EXPECT_EQ(fixed_text(-0.00001, 3), "0.000");
  EXPECT_EQ(fixed_text(-1.5, 1), "-1.5");
  EXPECT_EQ(fixed_text(2, 4), "2.0000");
}

}  // namespace
}  // namespace gouge
