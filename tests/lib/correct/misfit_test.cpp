#include "lib/correct/misfit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge {
namespace {

struct Case {
  ToolForms tool = tools::ball();
  Scene scene;
  std::vector<Pose> poses;

  [[nodiscard]] std::optional<Misfit> find() const {
    const Toolpath path = paths::through(poses);
    return find_misfit(path, {&tool}, prepare_scene(scene), {});
  }
};

/// A ball that touches a box all over: its top, and its sides with the tool leaning outward. The box lies off the origin, so
/// that no turn about an axis maps it onto itself.
Case around_a_box() {
  Case c;
  c.scene.parts = {shapes::box(Vec3(5, 15, 2), Vec3(65, 55, 32))};
  for (int i = 0; i < 12; ++i) {
    const double x = 8 + 4.5 * i;
    const Vec3 out = Vec3(0, -1, 0.3).normalized();
    const Vec3 center(x, 15 - 5.0, 12 + 0.5 * i);
    c.poses.push_back({center - 5 * out, out});
  }
  for (int i = 0; i < 12; ++i) {
    const Vec3 lean = Vec3(0.1, -0.2, 1).normalized();
    c.poses.push_back({Vec3(8 + 4.5 * i, 30, 37) - 5 * lean, lean});
  }
  return c;
}

TEST(Misfit, APathThatFitsIsNone) {
  EXPECT_FALSE(around_a_box().find().has_value());
}

TEST(Misfit, AUniformShallowUndercutIsNone) {
  Case c = around_a_box();
  for (Pose& pose : c.poses) pose.tip -= 0.8 * pose.axis;
  EXPECT_FALSE(c.find().has_value());
}

TEST(Misfit, TellsTheSignOfAnAxis) {
  Case c = around_a_box();
  c.poses.resize(12);
  for (Pose& pose : c.poses) pose.axis.y() = -pose.axis.y();
  const auto misfit = c.find();
  ASSERT_TRUE(misfit.has_value());
  EXPECT_GT(2 * misfit->deep, misfit->positions);
  ASSERT_TRUE(misfit->explanation.has_value());
  EXPECT_EQ(misfit->explanation->without, "with J negated");
  EXPECT_GE(misfit->explanation->share, 0.9);
  EXPECT_LE(misfit->share_touching, 0.5);
}

TEST(Misfit, TellsAPartThatLiesTurned) {
  Case c = around_a_box();
  // About X by 90 degrees: y to z, z to -y. The path runs through what then is solid.
  for (Vec3& v : c.scene.parts[0].vertices) v = Vec3(v.x(), -v.z(), v.y());
  for (Pose& pose : c.poses) {
    pose.tip = Vec3(pose.tip.x(), -pose.tip.z(), pose.tip.y());
    pose.axis = Vec3(pose.axis.x(), -pose.axis.z(), pose.axis.y());
  }
  ASSERT_FALSE(c.find().has_value()) << "turned together they fit";
  Case d;
  d.scene.parts = {shapes::box(Vec3(-40, -20, -30), Vec3(40, 20, 0))};
  for (int i = 0; i < 10; ++i) d.poses.push_back({Vec3(-30 + 6 * i, 10, 0), Vec3::UnitZ()});
  for (Vec3& v : d.scene.parts[0].vertices) v = Vec3(v.x(), -v.z(), v.y());
  const auto misfit = d.find();
  ASSERT_TRUE(misfit.has_value());
  ASSERT_TRUE(misfit->explanation.has_value());
  EXPECT_EQ(misfit->explanation->without, "with the part rotated by 270 degrees about X");
}

TEST(Misfit, TellsAPartInOtherUnits) {
  Case c;
  c.scene.parts = {shapes::box(Vec3(-2, -2, -1), Vec3(2, 2, 1))};  // meant in inches
  for (Vec3& v : c.scene.parts[0].vertices) v *= 25.4 * 25.4;
  for (int i = 0; i < 10; ++i) c.poses.push_back({Vec3(-40 + 8 * i, 10, 25.4), Vec3::UnitZ()});
  const auto misfit = c.find();
  ASSERT_TRUE(misfit.has_value());
  EXPECT_EQ(misfit->deep, misfit->positions) << "wholly inside";
  ASSERT_TRUE(misfit->explanation.has_value());
  EXPECT_EQ(misfit->explanation->without, "with the part 25.4 times as small, as if one of both were in inches");
}

TEST(Misfit, TellsTheTipAgainstTheCentreOfTheCutter) {
  Case c;
  c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
  for (int i = 0; i < 10; ++i) c.poses.push_back({Vec3(-40 + 8 * i, 10, -5), Vec3(0.1, 0, 1).normalized()});
  const auto misfit = c.find();
  ASSERT_TRUE(misfit.has_value());
  ASSERT_TRUE(misfit->explanation.has_value());
  EXPECT_EQ(misfit->explanation->without, "with the positions a cutter's radius higher along the tool axis");
}

TEST(Misfit, WhatNoUsualMistakeExplainsIsToldWithoutOne) {
  Case c;
  c.scene.parts = {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))};
  for (int i = 0; i < 10; ++i) c.poses.push_back({Vec3(-40 + 8 * i, 10, -13), Vec3::UnitZ()});
  const auto misfit = c.find();
  ASSERT_TRUE(misfit.has_value());
  EXPECT_FALSE(misfit->explanation.has_value());
}

}  // namespace
}  // namespace gouge
