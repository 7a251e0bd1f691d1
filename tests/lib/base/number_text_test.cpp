#include "lib/base/number_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/support/scatter.h"

namespace gouge::number_text_test {
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

// Short decimals take a path of their own, which must round as every other.
TEST(ParseNumber, GivesTheNearestDoubleForAnyCountOfDigits) {
  test::Scatter random(11);
  for (int i = 0; i < 200000; ++i) {
    const std::size_t digits = 1 + random.next() % 20;
    std::string text = random.next() % 2 == 0 ? "-" : "";
    for (std::size_t k = 0; k < digits; ++k) text += static_cast<char>('0' + random.next() % 10);
    if (random.next() % 8 != 0) text.insert(text.size() - random.next() % (digits + 1), 1, '.');
    EXPECT_EQ(parse_number(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ExactText, ReadsBackAsTheSameNumber) {
  test::Scatter random(7);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.in(-1e4, 1e4);
    EXPECT_EQ(parse_number(exact_text(x)), x);
  }
  EXPECT_EQ(exact_text(-0.0), "0");
}

TEST(FixedText, NeverWritesANegativeZero) {
  EXPECT_EQ(fixed_text(-0.00001, 3), "0.000");
  EXPECT_EQ(fixed_text(-1.5, 1), "-1.5");
  EXPECT_EQ(fixed_text(2, 4), "2.0000");
}

TEST(PeopleText, IsShortHoweverLargeTheNumber) {
  EXPECT_EQ(display_text(1e300, 3), "1e+300") << "its zeros are not dropped";
  EXPECT_EQ(display_text(-1.5e20, 3, Zeros::kept), "-1.5e+20");
  EXPECT_EQ(display_text(999999999999999.0, 0), "999999999999999");
  EXPECT_EQ(display_text(12.5, 3), "12.5");
  EXPECT_EQ(display_text(100, 3), "100");
  EXPECT_EQ(display_text(100, 0), "100");
  EXPECT_EQ(display_text(12.5, 3, Zeros::kept), "12.500");
  EXPECT_EQ(display_text(-0.0001, 3), "0");
}

}  // namespace
}  // namespace gouge::number_text_test
