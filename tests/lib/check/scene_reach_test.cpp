#include "lib/check/scene_reach.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::scene_reach_test {
namespace {

TEST(SceneReach, NothingOfTheSceneIsFartherFromATip) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{30, 0, 0}, {0, 0, 1}}});
  const Scene scene{{shapes::cube(10)}, {}};
  EXPECT_GE(reach_mm(path, scene), (Vec3(30, 0, 0) - Vec3(0, 10, 10)).norm());
  EXPECT_EQ(reach_mm({}, {}), 0);
}

// A full circle ends where it begins; the tip is far from both in between.
TEST(SceneReach, AnArcReachesBeyondItsEnds) {
  Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, 1}}});
  path.arcs.push_back({Vec3(50, 0, 0), Vec3::UnitZ(), 2 * std::numbers::pi});
  path.moves[1].curve_kind = CurveKind::arc;
  const Scene scene{{shapes::cube(1)}, {}};
  EXPECT_GE(reach_mm(path, scene), 99);
}

TEST(PartsBesidePath, AreComparedWithTheCutsAndTheWayOfTheTip) {
  Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{40, 30, 0}, {0, 0, 1}}, {{0, 0, 900}, {0, 0, 1}}});
  path.moves[2].kind = MoveKind::rapid;
  const auto beside = compare_parts(path, {{shapes::box({0, 0, -7}, {3, 4, -5})}, {}});
  ASSERT_TRUE(beside.has_value());
  EXPECT_DOUBLE_EQ(beside->gap_mm, 5);
  EXPECT_NEAR(beside->times_smaller, 50 / std::sqrt(29.0), 1e-12);
  EXPECT_TRUE(beside->is_far_smaller());
  EXPECT_FALSE(beside->is_far_larger());
  EXPECT_FALSE(compare_parts({}, {{shapes::cube(1)}, {}}));
  EXPECT_FALSE(compare_parts(path, {}));
}

TEST(UnitsThatFit, AreTheBestFirst) {
  const auto units = units_that_fit(24, LengthUnit::mm);
  ASSERT_EQ(units.size(), 2u);
  EXPECT_EQ(units[0]->unit, LengthUnit::inch);
  EXPECT_EQ(units[1]->unit, LengthUnit::cm);
  EXPECT_TRUE(units_that_fit(1, LengthUnit::mm).empty());
}

TEST(ExtendUp, WhatIsAboveTheToolNoLongerHides) {
  const Toolpath path = paths::through({{{0, 0, 0}, {0, 0, 1}}, {{5, 0, 0}, {0, 0, 1}}});
  Scene scene;
  scene.parts.push_back(shapes::sheet(40, 40, 80));
  for (Vec3& v : scene.parts[0].vertices) v -= Vec3(20, 20, 0);
  ToolAssembly tool;
  tool.cutter = FlatCutter{10, 30};
  const ToolVariants as_given = tools::variants(tool);
  const ToolVariants endless = tools::variants(extended_up(tool, reach_mm(path, scene) + 5));
  EXPECT_EQ(whole_check(path, &as_given, scene).counts.gouge, 0u);
  EXPECT_EQ(whole_check(path, &endless, scene).counts.gouge, 2u);
}

}  // namespace
}  // namespace gouge::scene_reach_test
