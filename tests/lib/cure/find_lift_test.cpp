#include "lib/cure/find_lift.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// A holder D32 that begins 50 mm above the tip of a ball cutter D10.

namespace gouge::find_lift_test {
namespace {

using paths::upright;

constexpr double kStep_mm = 0.01;

struct Problem {
  ToolVariants tool = tools::ball(10);
  Scene scene;
  Toolpath path;
  CheckOptions options;
  std::vector<HeadBody> heads;

  [[nodiscard]] std::vector<std::size_t> bad_moves() const {
    const CheckResult result = whole_check(path, &tool, scene, options, heads);
    std::vector<std::size_t> bad;
    for (std::size_t i = 0; i < result.verdicts.size(); ++i) {
      const MoveState state = result.verdicts[i].state;
      if (state == MoveState::gouge || state == MoveState::buried) bad.push_back(i);
    }
    return bad;
  }

  [[nodiscard]] LiftCure solve(double max_mm = 100) const {
    const OwnSetup own(&tool, scene, options, {});
    const CheckSetup setup{{&tool}, heads, own.scene, own.options};
    return find_lift(path, bad_moves(), setup, kStep_mm, max_mm);
  }

  /// By means of its own: every bad move by itself, lifted by hand.
  [[nodiscard]] bool is_free(double lift_mm) const {
    for (const std::size_t i : bad_moves()) {
      std::vector<Pose> ends;
      if (path.moves[i].has_start) ends.push_back(path.start_of(i));
      ends.push_back(path.moves[i].end);
      for (Pose& pose : ends) pose.tip += lift_mm * pose.axis;
      const CheckResult result = whole_check(paths::through(ends), &tool, scene, options, heads);
      if (result.counts.clean != result.verdicts.size()) return false;
    }
    return true;
  }
};

/// Along a wall `wall_mm` high, 12 mm beside the tip.
Problem along_wall(double wall_mm) {
  Problem problem;
  problem.scene.parts = {shapes::box(Vec3(12, -50, -10), Vec3(60, 50, wall_mm))};
  problem.path = paths::through({upright(0, -90, 0), upright(0, -30, 0), upright(0, 30, 0), upright(0, 90, 0)});
  return problem;
}

TEST(FindLift, TheHolderClearsAWallWhenItsFaceIsAsHighAsTheWall) {
  for (const double wall_mm : {50.5, 53.0, 61.237}) {
    const Problem problem = along_wall(wall_mm);
    const LiftCure cure = problem.solve();
    ASSERT_TRUE(cure.lift_mm) << wall_mm;
    // Up to tolerance + resolution the holder may be in it.
    EXPECT_LE(*cure.lift_mm, wall_mm - 50 + kStep_mm);
    EXPECT_GE(*cure.lift_mm, wall_mm - 50 - 0.011 - kStep_mm);
    EXPECT_NEAR(*cure.lift_mm / kStep_mm, std::round(*cure.lift_mm / kStep_mm), 1e-6) << "a multiple of the step";
    EXPECT_TRUE(problem.is_free(*cure.lift_mm));
    EXPECT_FALSE(problem.is_free(*cure.lift_mm - kStep_mm));
    EXPECT_EQ(cure.body, Body::holder);
    EXPECT_GE(cure.move, 1U);
    EXPECT_LE(cure.move, 3U);
  }
}

TEST(FindLift, NoneWithinTheMostSaysWhatIsInTheWayThere) {
  const LiftCure cure = along_wall(80).solve(20);
  EXPECT_FALSE(cure.lift_mm);
  EXPECT_EQ(cure.body, Body::holder);
  EXPECT_EQ(cure.state, MoveState::gouge);
  EXPECT_TRUE(along_wall(80).solve(30.5).lift_mm);
}

TEST(FindLift, AClearanceCounts) {
  Problem problem = along_wall(53);
  problem.tool = tools::variants(tools::assembly(BallCutter{10, 30}, 10), 0, 0, 2);
  problem.options.holder_clearance_mm = 2;
  EXPECT_NEAR(*problem.solve().lift_mm, 5, 2 * kStep_mm);
}

TEST(FindLift, HeadsAreLifted) {
  Problem problem = along_wall(53);
  ToolAssembly bare = tools::assembly(BallCutter{10, 30}, 10);
  bare.holder.clear();
  problem.tool = tools::variants(bare);
  problem.heads.push_back(*build_head_body(shapes::box(Vec3(-30, -30, 51), Vec3(30, 30, 90))));
  const LiftCure cure = problem.solve();
  ASSERT_TRUE(cure.lift_mm);
  EXPECT_NEAR(*cure.lift_mm, 2, 0.011 + kStep_mm);
  EXPECT_EQ(cure.body, Body::head);
  EXPECT_TRUE(problem.is_free(*cure.lift_mm));
}

// Upright arcs keep their form; where the axis turns they become chords.
TEST(FindLift, CurvesAreLiftedWithTheirForm) {
  for (const double lean : {0.0, 0.05}) {
    Problem problem = along_wall(52);
    problem.path = paths::through({upright(0, -20, 0), {Vec3(0, 20, 0), Vec3(lean, 0, 1).normalized()}});
    Move& arc = problem.path.moves.back();
    arc.kind = MoveKind::arc;
    arc.curve_kind = CurveKind::arc;
    arc.curve = 0;
    // Half a circle away from the wall.
    problem.path.arcs = {{Vec3::Zero(), -Vec3::UnitZ(), std::numbers::pi}};
    const LiftedMoves lifted = lift_moves(problem.path, {1}, 3, 0.001);
    ASSERT_GE(lifted.path.moves.size(), 2U);
    EXPECT_EQ(lifted.path.moves.size() == 2, !(lean > 0));
    EXPECT_EQ(lifted.path.moves.front().end.tip, Vec3(0, -20, 3));
    EXPECT_LT(
        (lifted.path.moves.back().end.tip - problem.path.moves[1].end.tip - 3 * problem.path.moves[1].end.axis).norm(),
        1e-12);
    if (!(lean > 0)) {
      EXPECT_EQ(lifted.path.arcs.front().center, Vec3(0, 0, 3));
    }
    EXPECT_TRUE(problem.solve().lift_mm);
  }
}

// A tool inside a solid, with no surface within it, is free where it has come out.
TEST(FindLift, OutOfASolid) {
  Problem problem;
  problem.scene.parts = {shapes::box(Vec3(-100, -100, -300), Vec3(100, 100, 60))};
  problem.path = paths::through({upright(0, 0, -110), upright(10, 0, -110)});
  const LiftCure cure = problem.solve(200);
  ASSERT_TRUE(cure.lift_mm);
  EXPECT_NEAR(*cure.lift_mm, 170, 0.011 + kStep_mm);
}

// Random posts and leaning tools against every lift in turn.
TEST(FindLift, IsTheLeastOfAllLiftsOneAfterTheOther) {
  constexpr double kCoarse_mm = 0.5, kMost_mm = 24;
  std::size_t found = 0, none = 0;
  for (unsigned seed = 0; seed < 24; ++seed) {
    test::Scatter scatter(seed);
    Problem problem;
    problem.options.threads = 1;
    const double x = scatter.in(6, 18), y = scatter.in(-10, 10), top = scatter.in(45, 78);
    problem.scene.parts = {shapes::box(Vec3(x, y, -10), Vec3(x + 20, y + scatter.in(1, 30), top))};
    if (seed % 3 == 0) problem.scene.parts.push_back(shapes::box(Vec3(-60, -40, 66), Vec3(-12, 40, 69)));
    const auto axis = [&] { return scatter.axis(0.15); };
    const Vec3 lean = axis();
    problem.path = paths::through({{Vec3(0, -25, 0), lean}, {Vec3(0, 25, 0), seed % 2 == 0 ? lean : axis()}});
    if (problem.bad_moves().empty()) continue;
    const OwnSetup own(&problem.tool, problem.scene, problem.options);
    const LiftCure cure = find_lift(problem.path, problem.bad_moves(), own.setup, kCoarse_mm, kMost_mm);
    std::optional<double> least;
    for (int k = 1; k * kCoarse_mm <= kMost_mm + 1e-9 && !least; ++k) {
      if (problem.is_free(k * kCoarse_mm)) least = k * kCoarse_mm;
    }
    ASSERT_EQ(cure.lift_mm.has_value(), least.has_value()) << seed;
    ++(least ? found : none);
    if (least) {
      EXPECT_NEAR(*cure.lift_mm, *least, 1e-9) << seed;
    }
  }
  EXPECT_GT(found, 8U);
  EXPECT_GT(none, 0U);
}

}  // namespace
}  // namespace gouge::find_lift_test
