#include "cli/length_text.h"

#include <gtest/gtest.h>

namespace gouge {
namespace {

TEST(LengthText, ALengthMayCarryItsUnit) {
  EXPECT_EQ(parse_length_mm("0.5"), 0.5);
  EXPECT_EQ(parse_length_mm("0.5mm"), 0.5);
  EXPECT_EQ(parse_length_mm("2in"), 50.8);
  EXPECT_EQ(parse_length_mm("2inch"), 50.8);
  for (const char* text : {"", "in", "inch", "2inches", "2 cm", "2inin", "2inchin", "mm2"})
    EXPECT_FALSE(parse_length_mm(text)) << text;
}

TEST(LengthText, NothingReachesFartherThanACheck) {
  EXPECT_EQ(parse_length_mm("100000"), 100000);
  EXPECT_EQ(parse_length_mm("-1e5mm"), -100000);
  EXPECT_EQ(parse_place("1e5,0,-1e5")->shift, Vec3(1e5, 0, -1e5));
  CheckOptions options;
  EXPECT_FALSE(parse_clearance("shank=100000", options));
  EXPECT_EQ(options.shank_clearance_mm, 100000);
  for (const std::string text : {"100001", "3938in", "1e300", "-1e6", "inf", "nan", "1e400"}) {
    EXPECT_FALSE(parse_length_mm(text)) << text;
    EXPECT_FALSE(parse_place("0," + text + ",0")) << text;
    EXPECT_TRUE(parse_clearance("holder=" + text, options)) << text;
  }
  EXPECT_EQ(options.holder_clearance_mm, CheckOptions{}.holder_clearance_mm);
}

TEST(LengthText, ABodyHasOneClearance) {
  CheckOptions options;
  EXPECT_EQ(parse_clearance("holder=1,shank=2,holder=0", options),
            "'holder' is given twice; expected one clearance for each body");
}

TEST(LengthText, AnAngleIsANumber) {
  for (const std::string text : {"inf", "nan", "1e400", "", "45deg"})
    EXPECT_FALSE(parse_place("0,0,0,0,0," + text)) << text;
}

TEST(LengthText, ATurnByAHugeAngleIsARotation) {
  const auto place = parse_place("0,0,0,45,4500000000000000000000000000000000000000000000000000000000,450");
  ASSERT_TRUE(place.has_value());
  EXPECT_TRUE((place->rotation * place->rotation.transpose()).isIdentity(1e-12));
  EXPECT_NEAR(place->rotation.determinant(), 1, 1e-12);
}

}  // namespace
}  // namespace gouge
