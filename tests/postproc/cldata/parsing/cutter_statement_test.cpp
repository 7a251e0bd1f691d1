#include "postproc/cldata/parsing/cutter_statement.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace gouge::cutter_statement_test {
namespace {

std::vector<Argument> numbers(std::initializer_list<double> values) {
  std::vector<Argument> result;
  for (const double value : values) result.push_back({"", value});
  return result;
}

TEST(Cutter, ShortFormsAreAFlatAndABullNose) {
  const auto flat = make_cutter(numbers({16}), 1).cutter;
  ASSERT_TRUE(flat);
  EXPECT_DOUBLE_EQ(flat->e_mm, 8);
  EXPECT_DOUBLE_EQ(flat->f_mm, 0);
  EXPECT_EQ(flat->given, 1);
  const auto bull = make_cutter(numbers({0.5, 0.125}), 25.4).cutter;
  ASSERT_TRUE(bull);
  EXPECT_DOUBLE_EQ(bull->d_mm, 12.7);
  EXPECT_DOUBLE_EQ(bull->e_mm, 3.175);
  EXPECT_DOUBLE_EQ(bull->f_mm, 3.175);
}

// Only in a dialect that writes it; in any other the corner circle may reach beyond the diameter.
TEST(Cutter, TipDiameterWrittenAsEIsNotBelieved) {
  EXPECT_FALSE(make_cutter(numbers({10, 2, 6, 0, 0, 0, 40}), 1).cutter);
  const auto cutter = make_cutter(numbers({10, 2, 6, 0, 0, 0, 40}), 1, true).cutter;
  ASSERT_TRUE(cutter);
  EXPECT_DOUBLE_EQ(cutter->e_mm, 3);
  EXPECT_DOUBLE_EQ(cutter->f_mm, 2);
  EXPECT_DOUBLE_EQ(cutter->h_mm, 40);
}

TEST(Cutter, ADrillKeepsItsNumbers) {
  const auto cutter = make_cutter(numbers({10, 0, 5, 3.004303, 31, 0, 130}), 1).cutter;
  ASSERT_TRUE(cutter);
  EXPECT_DOUBLE_EQ(cutter->f_mm, 3.004303);
  EXPECT_DOUBLE_EQ(cutter->alpha_deg, 31);
}

TEST(Cutter, ARadiusRoundedUpIsHalfTheDiameter) {
  const auto cutter = make_cutter(numbers({0.3125, 0.1563}), 25.4).cutter;
  ASSERT_TRUE(cutter);
  EXPECT_DOUBLE_EQ(cutter->r_mm, cutter->d_mm / 2);
  EXPECT_DOUBLE_EQ(cutter->e_mm, 0);
}

TEST(Cutter, WrongNumbersAreNamed) {
  EXPECT_EQ(make_cutter(numbers({10, 6}), 1).error, "corner radius 6 is larger than half the diameter 10");
  EXPECT_EQ(make_cutter(numbers({-10}), 1).error, "diameter -10 is negative");
  EXPECT_EQ(make_cutter(numbers({10, -1}), 1).error, "corner radius -1 is negative");
  EXPECT_EQ(make_cutter(numbers({10, 0, 5, 0, 0, 0, -1}), 1).error, "length -1 is negative");
  EXPECT_EQ(make_cutter(numbers({10, 0, 5, 0, 90, 0, 1}), 1).error, "tip angle 90 is not within 0 to 90 degrees");
  EXPECT_EQ(make_cutter(numbers({10, 0, 5, 0, 0, 95, 1}), 1).error, "flank angle 95 is not within -90 to 90 degrees");
  EXPECT_EQ(make_cutter(numbers({10, 1, 4}), 1).error, "found 3 numbers");
  EXPECT_EQ(make_cutter({}, 1).error, "found 0 numbers");
}

TEST(Tldata, TheCornerCircleTouchesBottomAndFlank) {
  const auto cutter = make_tldata_cutter(numbers({20, 3, 60, 10, 5}), false, 1).cutter;
  ASSERT_TRUE(cutter);
  const double a = 5 * 3.14159265358979323846 / 180;
  const double b = 10 * 3.14159265358979323846 / 180;
  // Distance of the centre to the bottom line z = x tan a, and to the flank through (d/2, d/2 tan a).
  EXPECT_NEAR(cutter->f_mm * std::cos(a) - cutter->e_mm * std::sin(a), 3, 1e-12);
  EXPECT_NEAR((10 - cutter->e_mm) * std::cos(b) + (cutter->f_mm - 10 * std::tan(a)) * std::sin(b), 3, 1e-12);
}

TEST(Tldata, BallDrillAndCountersink) {
  const auto ball = make_tldata_cutter(numbers({30, 15, 75, 0, 0}), false, 1).cutter;
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->e_mm, 0, 1e-12);
  EXPECT_NEAR(ball->f_mm, 15, 1e-12);
  const auto drill = make_tldata_cutter(numbers({63, 0, 239, 178, 35}), true, 1);
  ASSERT_TRUE(drill.cutter);
  EXPECT_DOUBLE_EQ(drill.cutter->alpha_deg, 1);
  EXPECT_DOUBLE_EQ(drill.flute_length_mm, 35);
  EXPECT_DOUBLE_EQ(make_tldata_cutter(numbers({30, 0, 30, 0, 45}), false, 1).cutter->f_mm, 15);
}

TEST(Tldata, ACornerCircleElsewhereDefinesNoTool) {
  EXPECT_TRUE(make_tldata_cutter(numbers({20, 5, 50, 0, 0, 5, 5}), false, 1).cutter);
  EXPECT_TRUE(make_tldata_cutter(numbers({20, 5, 50, 0, 0, 0, 0}), false, 1).cutter) << "not given";
  EXPECT_TRUE(make_tldata_cutter(numbers({0.3125, 0.1563, 2, 0, 0, 0, 0.1562}), false, 25.4).cutter) << "rounded";
  for (const double r : {8.0, 5.001}) {
    const CutterOutcome outcome = make_tldata_cutter(numbers({20, 5, 50, 0, 0, r, 5}), false, 1);
    EXPECT_FALSE(outcome.cutter);
    EXPECT_TRUE(outcome.error.empty());
    EXPECT_NE(outcome.note.find("tool library"), std::string::npos);
  }
  EXPECT_FALSE(make_tldata_cutter(numbers({20, 5, 50, 0, 0, 8, 5, 0, 0, 0}), false, 1).cutter);
}

TEST(Tldata, WhatCannotBeExpressedDefinesNoTool) {
  const auto barrel = make_tldata_cutter(numbers({20, 2, 60, 0, 0, 8, 2, 50, -40, 20}), false, 1);
  EXPECT_FALSE(barrel.cutter);
  EXPECT_TRUE(barrel.error.empty());
  EXPECT_FALSE(barrel.note.empty());
  EXPECT_EQ(make_tldata_cutter(numbers({20, 2, 60}), false, 1).error, "found 3 numbers");
  EXPECT_EQ(make_tldata_cutter(numbers({20, 12, 60, 0, 0}), false, 1).error,
            "corner radius 12 is larger than half the diameter 20");
}

}  // namespace
}  // namespace gouge::cutter_statement_test
