#include "lib/correct/plan_trims.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/correct/laws.h"
#include "lib/correct/tilt_path.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A ball cutter of 10 mm in a holder of 32 mm that reaches 50 mm above the tip, on a floor at z = 0 along y, and a wall
// 12 mm beside it from y = -30 to 30, as high as a test states. The holder, 16 mm of radius, is in the wall from y = -30
// - sqrt(16^2 - 12^2) = -40.583 on.

namespace gouge::plan_trims_test {
namespace {

using paths::upright;

constexpr double kMeets_mm = 40.5830;

struct Beside {
  ToolVariants tool = tools::ball(10);
  Scene scene;
  Toolpath path;
  CorrectOptions correct;
  RewritableMoves rewritable;

  explicit Beside(double wall_mm, double step_mm = 4) {
    scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)),
                   shapes::box(Vec3(12, -30, -5), Vec3(60, 30, wall_mm))};
    std::vector<Pose> poses{upright(0, -80, 120)};
    for (double y = -80; y <= 80; y += step_mm) poses.push_back(upright(0, y, 0));
    poses.push_back(upright(0, 80, 120));
    set(poses);
    correct.strategies.of[static_cast<std::size_t>(Body::holder)] = Strategy::trim;
    correct.max_shift_mm = 30;
  }

  void set(const std::vector<Pose>& poses) {
    path = paths::through(poses);
    rewritable.arc = rewritable.split = rewritable.hole = std::vector<bool>(path.moves.size(), false);
    rewritable.has_rapids = true;
    correct.rewritable = &rewritable;
  }

  /// Applies the changes to the path, without a file.
  [[nodiscard]] Toolpath changed(const std::vector<PathChange>& changes) const {
    Toolpath after = path;
    after.moves.clear();
    std::vector<const PathChange*> of(path.moves.size(), nullptr);
    for (const PathChange& change : changes) of[change.move] = &change;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      Move move = path.moves[i];
      const MoveKind own = move.kind;
      for (std::size_t k = 0; of[i] != nullptr && k < of[i]->inserted_before.size(); ++k) {
        move.end = of[i]->inserted_before[k];
        move.kind = of[i]->is_at_rapid(k) ? MoveKind::rapid : own;
        after.moves.push_back(move);
      }
      move.end = of[i] != nullptr && of[i]->new_end ? *of[i]->new_end : path.moves[i].end;
      move.kind = of[i] != nullptr && of[i]->is_end_at_rapid() ? MoveKind::rapid : own;
      after.moves.push_back(move);
    }
    return after;
  }

  [[nodiscard]] LawfulCorrection run(const CheckOptions& options = {}) const {
    const OwnSetup own(&tool, scene, options);
    const auto rewrite = [&](const std::vector<PathChange>& changes) -> Result<Toolpath> { return changed(changes); };
    Result<LawfulCorrection> done = correct_lawfully(path, check(path, own.setup), own.setup, correct, rewrite);
    EXPECT_TRUE(done);
    return std::move(*done);
  }
};

std::size_t bad_moves(const CheckResult& result) { return result.counts.gouge + result.counts.buried; }

TEST(PlanTrims, LeaveOutWhereTheHolderIsInTheWallAndNothingElse) {
  const Beside beside(60);
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  EXPECT_TRUE(done.correction.uncorrected.empty());
  ASSERT_EQ(done.correction.uncut.size(), 1U);
  const Uncut& uncut = done.correction.uncut.front();
  EXPECT_NEAR(uncut.length_mm, 2 * kMeets_mm, 0.1);
  EXPECT_EQ(uncut.positions, 21U);  // y = -40 to 40
  for (const Move& move : done.after.path.moves) {
    const Vec3& tip = move.end.tip;
    if (std::abs(tip.y()) < kMeets_mm - 0.05) {
      EXPECT_GE(tip.z(), 10 + 1) << "the holder is 50 mm above the tip, the wall 60";
    }
    if (std::abs(tip.y()) > kMeets_mm + 0.05) {
      EXPECT_LT(std::min(std::abs(tip.z()), std::abs(tip.z() - 120)), 1e-12) << "nothing else moves";
    }
    EXPECT_EQ(move.end.axis, Vec3::UnitZ());
  }
}

/// The pass begins with a rapid to `level` above the floor.
Beside entered_at(double level) {
  Beside beside(60);
  std::vector<Pose> poses{upright(0, -80, 120), upright(0, -80, level)};
  for (double y = -80; y <= 80; y += 4) poses.push_back(upright(0, y, 0));
  poses.push_back(upright(0, 80, 120));
  beside.set(poses);
  beside.path.moves[1].kind = MoveKind::rapid;
  return beside;
}

// How high the stock stands above what is left uncut is not known: the program went to feed 15 mm above the floor.
TEST(PlanTrims, CrossAtFeedBelowWherePathsGoToFeed) {
  const Beside beside = entered_at(15);
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  ASSERT_EQ(done.correction.uncut.size(), 1U);
  for (std::size_t i = 2; i < done.after.path.moves.size(); ++i)
    EXPECT_EQ(done.after.path.moves[i].kind, MoveKind::feed) << i;
  for (const Move& move : Beside(60).run().after.path.moves) EXPECT_EQ(move.kind, MoveKind::feed) << "no rapid at all";
}

TEST(PlanTrims, CrossAtRapidWithTheClearanceAndFeedUpAndDown) {
  const Beside beside = entered_at(5);
  const LawfulCorrection done = beside.run();
  const Moves& moves = done.after.path.moves;
  std::size_t rapids = 0, feeds_off_the_floor = 0;
  CheckOptions near;
  near.near_miss_mm = beside.correct.rapid_clearance_mm;
  const OwnSetup own(&beside.tool, beside.scene, near);
  const CheckResult result = check(done.after.path, own.setup);
  for (std::size_t i = 1; i < moves.size(); ++i) {
    if (moves[i].kind == MoveKind::rapid) {
      ++rapids;
      EXPECT_EQ(result.verdicts[i].state, MoveState::clean);
      if (i > 1) {
        EXPECT_DOUBLE_EQ(moves[i].end.tip.z(), moves[i - 1].end.tip.z());
      }
    }
    feeds_off_the_floor += moves[i].kind == MoveKind::feed && moves[i].end.tip.z() > 0 ? 1U : 0U;
  }
  EXPECT_EQ(rapids, 22U + 1) << "the crossing, and the programmed one";
  EXPECT_EQ(feeds_off_the_floor, 2U) << "up from the floor, and the end of the path";
}

TEST(PlanTrims, AFileThatCannotSayRapidGetsFeeds) {
  Beside beside(60);
  beside.rewritable.has_rapids = false;
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  EXPECT_EQ(done.correction.uncut.size(), 1U);
  for (const Move& move : done.after.path.moves) EXPECT_EQ(move.kind, MoveKind::feed);
}

TEST(PlanTrims, OneLongMoveKeepsBothItsEndsAndLosesItsMiddle) {
  Beside beside(60);
  beside.set({upright(0, -80, 120), upright(0, -80, 0), upright(0, 80, 0)});
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  ASSERT_EQ(done.correction.uncut.size(), 1U);
  EXPECT_EQ(done.correction.uncut.front().positions, 0U);
  EXPECT_NEAR(done.correction.uncut.front().length_mm, 2 * kMeets_mm, 0.1);
  ASSERT_EQ(done.correction.changes.size(), 1U);
  EXPECT_FALSE(done.correction.changes.front().new_end);
  EXPECT_EQ(done.correction.changes.front().inserted_before.size(), 4U);
}

TEST(PlanTrims, WhatIsHigherThanAllLiftsIsListedWithTheReasonAndLeft) {
  const Beside beside(100);
  const LawfulCorrection done = beside.run();
  EXPECT_TRUE(done.correction.changes.empty());
  EXPECT_TRUE(done.correction.uncut.empty());
  ASSERT_FALSE(done.correction.uncorrected.empty());
  for (const Uncorrected& left : done.correction.uncorrected)
    EXPECT_EQ(left.reason,
              "not left out: no way over it was found with lifts up to --max-shift 30 mm, with --rapid-clearance where "
              "rapids are on the way");
}

TEST(PlanTrims, APathThatEndsInACollisionHasNowhereToComeDown) {
  Beside beside(60);
  beside.set({upright(0, -80, 120), upright(0, -80, 0), upright(0, 0, 0)});
  const LawfulCorrection end = beside.run();
  ASSERT_EQ(end.correction.uncorrected.size(), 1U);
  EXPECT_EQ(end.correction.uncorrected.front().reason,
            "not left out: the path has no free place after it to come down to");
  beside.set({upright(0, 0, 0), upright(0, 80, 0), upright(0, 80, 120)});
  const LawfulCorrection begin = beside.run();
  ASSERT_FALSE(begin.correction.uncorrected.empty());
  EXPECT_EQ(begin.correction.uncorrected.back().reason,
            "not left out: the path has no free place before it to retract from");
}

// The pass ends beside the wall, and a rapid leads up out of it: the tool never comes down again.
TEST(PlanTrims, WhereARapidLeadsOutOfTheCollisionItIsJoined) {
  Beside beside(60);
  beside.set({upright(0, -80, 120), upright(0, -80, 0), upright(0, 0, 0), upright(0, 0, 120)});
  beside.path.moves.back().kind = MoveKind::rapid;
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  ASSERT_EQ(done.correction.uncut.size(), 1U);
  EXPECT_EQ(done.correction.uncut.front().positions, 1U);
  EXPECT_NEAR(done.correction.uncut.front().length_mm, kMeets_mm, 0.1);
}

/// A pass 0.3 mm below the floor, and a rapid up out of it.
Beside too_deep() {
  Beside beside(1);
  beside.scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0))};
  std::vector<Pose> poses{upright(0, -20, 50)};
  for (double y = -20; y <= 20; y += 5) poses.push_back(upright(0, y, -0.3));
  poses.push_back(upright(0, 20, 50));
  beside.set(poses);
  beside.path.moves.back().kind = MoveKind::rapid;
  beside.correct.strategies = BodyStrategies::all(Strategy::trim);
  return beside;
}

TEST(PlanTrims, NoRapidRunsTowardsThePartIntoWhatIsLeftUncut) {
  for (const bool can_write_rapids : {true, false}) {
    Beside beside = too_deep();
    beside.rewritable.has_rapids = can_write_rapids;
    const LawfulCorrection done = beside.run();
    EXPECT_EQ(bad_moves(done.after.result), 0U);
    ASSERT_EQ(done.correction.uncut.size(), 1U);
    const Moves& moves = done.after.path.moves;
    std::size_t rapids = 0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
      if (moves[i].kind != MoveKind::rapid) continue;
      ++rapids;
      EXPECT_GE(moves[i].end.tip.z(), moves[i - 1].end.tip.z());
      EXPECT_GE(std::min(moves[i].end.tip.z(), moves[i - 1].end.tip.z()), beside.correct.rapid_clearance_mm);
    }
    EXPECT_GT(rapids, 0U);
    EXPECT_TRUE(done.correction.low_rapids.empty());
  }
}

TEST(PlanTrims, ARapidThatRunsIntoTheGougeIsLeftWhereItKeepsTheClearance) {
  Beside beside = too_deep();
  beside.path.moves[1].kind = MoveKind::rapid;
  beside.path.moves.back().kind = MoveKind::feed;
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  for (const Move& move : done.after.path.moves) {
    if (move.kind == MoveKind::rapid) {
      EXPECT_GE(move.end.tip.z(), beside.correct.rapid_clearance_mm);
    }
  }
}

// Two posts with a free stretch between them, in one move: that stretch is cut.
TEST(PlanTrims, WhatIsFreeBetweenTwoCollisionsIsCut) {
  for (const double between_mm : {60.0, 33.0}) {
    Beside beside(60);
    const double half = between_mm / 2;
    beside.scene.parts = {shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)),
                          shapes::box(Vec3(12, -half - 10, -5), Vec3(60, -half, 60)),
                          shapes::box(Vec3(12, half, -5), Vec3(60, half + 10, 60))};
    beside.set({upright(0, -90, 120), upright(0, -90, 0), upright(0, 90, 0)});
    const LawfulCorrection done = beside.run();
    EXPECT_EQ(bad_moves(done.after.result), 0U);
    // The holder's half chord is 10.583 mm: of 60 mm between the posts 38.8 are free.
    ASSERT_EQ(done.correction.uncut.size(), 2U) << between_mm;
    EXPECT_NEAR(done.correction.uncut.front().length_mm, 10 + 2 * 10.583, 0.1);
  }
}

// Along an inclined axis the tool retracts along that.
TEST(PlanTrims, LiftsAreAlongTheToolAxis) {
  Beside beside(60);
  const Vec3 axis = Vec3(0, 0.1, 1).normalized();
  std::vector<Pose> poses;
  for (double y = -80; y <= 80; y += 8) poses.push_back({Vec3(0, y, 0.1), axis});
  beside.set(poses);
  const LawfulCorrection done = beside.run();
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  ASSERT_EQ(done.correction.uncut.size(), 1U);
  for (const Move& move : done.after.path.moves) EXPECT_LT((move.end.axis - axis).norm(), 1e-9);
  const PathChange& first = done.correction.changes.front();
  ASSERT_EQ(first.inserted_before.size(), 2U);
  const Vec3 up = first.inserted_before[1].tip - first.inserted_before[0].tip;
  EXPECT_LT(up.cross(axis).norm(), 1e-9);
  EXPECT_GT(up.dot(axis), 9);
}

TEST(PlanTrims, RapidsLeftOutOnRequestAreNotMade) {
  CheckOptions options;
  options.law = RapidMode::skip;
  const LawfulCorrection done = Beside(60).run(options);
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  EXPECT_EQ(done.after.result.counts.not_checked, 0U);
  EXPECT_EQ(done.correction.uncut.size(), 1U);
}

TEST(PlanTrims, DoglegsAreCrossedAsDoglegs) {
  CheckOptions options;
  options.law = RapidMode::dogleg;
  const LawfulCorrection done = Beside(60).run(options);
  EXPECT_EQ(bad_moves(done.after.result), 0U);
  EXPECT_EQ(done.correction.uncut.size(), 1U);
}

}  // namespace
}  // namespace gouge::plan_trims_test
