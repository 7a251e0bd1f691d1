#include "cli/terminal/length_text.h"

#include <gtest/gtest.h>

#include "cli/options/length_rule.h"

namespace gouge::length_text_test {
namespace {

TEST(LengthText, ALengthMayCarryItsUnit) {
  EXPECT_EQ(parse_length_mm("0.5"), 0.5);
  EXPECT_EQ(parse_length_mm("0.5mm"), 0.5);
  EXPECT_EQ(parse_length_mm("2in"), 50.8);
  EXPECT_EQ(parse_length_mm("2inch"), 50.8);
  EXPECT_DOUBLE_EQ(*parse_length_mm("20um"), 0.02);
  EXPECT_DOUBLE_EQ(*parse_length_mm("20 \xc2\xb5m"), 0.02);
  EXPECT_EQ(parse_length_mm("2 cm"), 20);
  EXPECT_EQ(parse_length_mm(" 0.02 mm "), 0.02);
  EXPECT_EQ(parse_length_mm("2 in"), 50.8);
  EXPECT_EQ(parse_place("1 in, 2, -3 mm")->shift, Vec3(25.4, 2, -3));
  for (const char* text : {"", "in", "inch", "2inches", "2m m", "2inin", "2inchin", "mm2", "2 m", "2 3", "1.mm.", " "})
    EXPECT_FALSE(parse_length_mm(text)) << text;
}

TEST(LengthText, ADecimalCommaIsNamed) {
  EXPECT_EQ(
      understand_length("--tolerance", "0,02 mm", Minimum::zero).error().message,
      "--tolerance '0,02 mm': expected a length of 0 or more in mm, or with a unit (0.0005in), and at most 100 m; "
      "write a decimal point in place of the comma: 0.02 mm");
  CheckOptions options;
  EXPECT_EQ(parse_clearance("shank=0,5", options),
            "'shank=0,5' has a number behind a comma; expected a decimal point: shank=0.5");
  EXPECT_EQ(decimal_comma_hint("1,2,3"), "");
  EXPECT_EQ(decimal_comma_hint("a,5"), "");
  EXPECT_EQ(decimal_comma_hint("5"), "");
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

TEST(LengthText, EachLengthOfAListMayCarryItsUnit) {
  EXPECT_EQ(parse_place("1in,2,-3mm,0,0,90")->shift, Vec3(25.4, 2, -3));
  EXPECT_FALSE(parse_place("1in,2,3,0,0,90in")) << "an angle is no length";
  CheckOptions options;
  EXPECT_FALSE(parse_clearance("shank=0.1in,holder=0.5", options));
  EXPECT_DOUBLE_EQ(options.shank_clearance_mm, 2.54);
  EXPECT_EQ(options.holder_clearance_mm, 0.5);
}

TEST(LengthText, WithUnitsMeansTheSame) {
  EXPECT_EQ(with_units("0.5"), "0.5mm");
  EXPECT_EQ(with_units("0.5in"), "0.5in");
  EXPECT_EQ(with_units("1,2in,-3"), "1mm,2in,-3mm");
  EXPECT_EQ(with_units("1,2,3,0,45,90"), "1mm,2mm,3mm,0,45,90");
  for (const char* typed : {"1,2in,-3", "1,2,3,0,45,90"})
    EXPECT_EQ(parse_place(with_units(typed))->shift, parse_place(typed)->shift);
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
}  // namespace gouge::length_text_test
