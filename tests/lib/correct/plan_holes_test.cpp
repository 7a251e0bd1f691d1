#include "lib/correct/plan_holes.h"

#include <gtest/gtest.h>

#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::plan_holes_test {
namespace {

using paths::upright;

/// A hole of three steps at (0, 0), its bottom at `bottom`, in a part whose top is z = 0 and that has no hole.
struct Hole {
  ToolVariants tool = tools::variants(tools::assembly(DrillCutter{10, 118, 30}));
  Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  CheckOptions options;
  RewritableMoves rewritable;
  Toolpath path;

  explicit Hole(double bottom) {
    path = paths::through(
        {upright(30, 0, 20), upright(0, 0, 3), upright(0, 0, bottom), upright(0, 0, 3), upright(30, 0, 20)});
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const bool is_step = i > 0 && i < 4;
      path.moves[i].statement = is_step ? 1 : i;
      if (is_step) path.moves[i].kind = MoveKind::cycle;
    }
    rewritable.arc.assign(path.moves.size(), false);
    rewritable.hole = {false, true, false, false, false};
  }

  [[nodiscard]] CheckResult check() const { return whole_check(path, &tool, scene, options); }
  [[nodiscard]] Correction correct(const BodyStrategies& strategies = {}) const {
    CorrectOptions how;
    how.strategies = strategies;
    how.rewritable = &rewritable;
    return correct_path(path, check(), OwnSetup(&tool, scene, options).setup, how);
  }
};

// The hole of the part is 10 mm deep and a little wider than the drill, of which the tip alone is at its bottom.
TEST(PlanHoles, AHoleALittleTooDeepIsLiftedByWhatItIsTooDeep) {
  Hole hole(-10.021);
  hole.scene.parts = {shapes::bored_block(5.3, 10)};
  ASSERT_EQ(hole.check().counts.gouge, 2U);
  const Correction correction = hole.correct();
  EXPECT_TRUE(correction.uncorrected.empty());
  ASSERT_EQ(correction.changes.size(), 1U);
  EXPECT_EQ(correction.changes[0].move, 1U);
  ASSERT_TRUE(correction.changes[0].hole_shift_mm.has_value());
  const Vec3 shift = *correction.changes[0].hole_shift_mm;
  EXPECT_GT(shift.z(), 0.01);
  EXPECT_LT(shift.z(), 0.025);
  EXPECT_EQ(shift.head<2>().norm(), 0);
  ASSERT_EQ(correction.records.size(), 1U);
  EXPECT_GT(correction.records[0].depth_before_mm, hole.options.tolerance_mm);
  EXPECT_LE(correction.records[0].depth_after_mm, hole.options.tolerance_mm);
  ASSERT_EQ(correction.uncut.size(), 1U) << "what is missing of its depth is counted";
  EXPECT_EQ(correction.uncut[0].kind, Uncut::Kind::hole);
  EXPECT_EQ(correction.uncut[0].length_mm, shift.z());
}

TEST(PlanHoles, NoHoleIsLiftedOutOfAPartThatDoesNotHaveIt) {
  for (const double depth : {0.02, 0.3, 2.0, 8.0, 12.0, 19.0, 25.0}) {
    for (const Strategy strategy : {Strategy::normal, Strategy::axis, Strategy::trim}) {
      const Correction correction = Hole(-depth).correct(BodyStrategies::all(strategy));
      EXPECT_TRUE(correction.changes.empty()) << depth;
      ASSERT_FALSE(correction.uncorrected.empty()) << depth;
      const std::string& reason = correction.uncorrected.front().reason;
      EXPECT_TRUE(reason.starts_with("hole ")) << reason;
      EXPECT_TRUE(reason.ends_with(" mm deep where the part has none")) << reason;
      EXPECT_NEAR(std::stod(reason.substr(5)), depth, 0.006) << reason;
    }
  }
}

TEST(PlanHoles, AHoleMuchDeeperThanThatOfThePartStays) {
  Hole hole(-12);
  hole.scene.parts = {shapes::bored_block(5.3, 4)};
  const Correction correction = hole.correct();
  EXPECT_TRUE(correction.changes.empty());
  ASSERT_FALSE(correction.uncorrected.empty());
  EXPECT_EQ(correction.uncorrected.front().reason, "hole 12 mm deep where the part has one of 4.01 mm");
}

// The drill meets the bottom of a wide bore: beside it there is no material that would make a hole.
TEST(PlanHoles, WhatIsNoHoleAboutTheDrillIsNotLifted) {
  Hole hole(-10.021);
  hole.scene.parts = {shapes::bored_block(20, 10)};
  ASSERT_GT(hole.check().counts.gouge, 0U);
  EXPECT_TRUE(hole.correct().changes.empty());
}

TEST(PlanHoles, AHoleThatTheFileCannotWriteElsewhereIsListed) {
  Hole hole(-10.021);
  hole.scene.parts = {shapes::bored_block(5.3, 10)};
  hole.rewritable.hole.assign(5, false);
  const Correction correction = hole.correct();
  EXPECT_TRUE(correction.changes.empty());
  ASSERT_EQ(correction.uncorrected.size(), 2U);
  EXPECT_NE(correction.uncorrected[0].reason.find("a step of a drilling cycle"), std::string::npos);
}

TEST(PlanHoles, AHoleDeeperThanTheLargestShiftStays) {
  const Hole hole(-25);
  EXPECT_TRUE(hole.correct().changes.empty());
}

TEST(PlanHoles, ACrossingThroughAWallBetweenTwoHolesIsListedWithItsReason) {
  Hole hole(0.5);
  hole.scene.parts.push_back(shapes::box(Vec3(12, -20, -1), Vec3(14, 20, 15)));
  hole.path.moves[4].kind = MoveKind::cycle;
  hole.path.moves[4].end = upright(30, 0, 3);
  const Correction correction = hole.correct();
  std::size_t listed = 0;
  for (const Uncorrected& left : correction.uncorrected) listed += left.move == 4 && !left.reason.empty() ? 1U : 0U;
  EXPECT_EQ(listed, 1U);
}

}  // namespace
}  // namespace gouge::plan_holes_test
