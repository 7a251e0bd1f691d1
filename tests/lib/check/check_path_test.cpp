
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "lib/check/closest_approach.h"
#include "lib/check/reach.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::check_path_test {
namespace {

using paths::through;
using paths::upright;

CheckResult check(const Toolpath& path, const ToolVariants& tool, const Scene& scene, CheckOptions options = {}) {
  return whole_check(path, &tool, scene, options);
}

TEST(CheckPath, EveryMoveHasOneStateAndTheCountsAddUp) {
  Toolpath path = through({upright(0, 0, 5), upright(5, 0, 5), upright(5, 0, -1), upright(5, 0, 5)});
  path.moves[1].not_checked_reason = "an arc";
  const CheckResult r = check(path, tools::ball(), {{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}});
  EXPECT_EQ(r.verdicts[0].state, MoveState::clean);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_checked);
  EXPECT_EQ(r.verdicts[2].state, MoveState::gouge);
  EXPECT_EQ(r.verdicts[3].state, MoveState::gouge);
  EXPECT_NEAR(r.verdicts[3].witness->t, 0, 1e-6);
  EXPECT_EQ(r.counts.clean + r.counts.gouge + r.counts.not_checked, 4U);
  ASSERT_EQ(r.events.size(), 1U);
  EXPECT_EQ(r.events[0].first_move, 2U);
  EXPECT_EQ(r.events[0].last_move, 3U);
}

TEST(CheckPath, ABuriedToolIsNeverClean) {
  const Scene scene{{shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 500))}, {}};
  const CheckResult r = check(through({upright(0, 0, 0), upright(20, 0, 0)}), tools::ball(), scene);
  EXPECT_EQ(r.counts.buried, 2U);
  EXPECT_EQ(r.events.size(), 1U);
}

TEST(CheckPath, ABuriedToolIsSeenInAnInsideOutSolidAndInAFixture) {
  const IndexedMesh block = shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 500));
  const Toolpath path = through({upright(0, 0, 0), upright(20, 0, 0)});
  EXPECT_EQ(check(path, tools::ball(), {{shapes::inside_out(block)}, {}}).counts.buried, 2U);
  EXPECT_EQ(check(path, tools::ball(), {{shapes::moved(shapes::cube(1), Vec3(-400, 0, 0))}, {block}}).counts.buried,
            2U);
}

TEST(CheckPath, AToleranceAsLargeAsTheCutterNeverMakesAPlungeClean) {
  const Scene scene{{shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 0))}, {}};
  const ToolVariants needle = make_tool_variants({1, "needle", BallCutter{0.1, 50}, {}, {}}, 0, 0, 0).value();
  const Toolpath path = through({upright(0, 0, 5), upright(0, 0, -60), upright(3, 0, -60)});
  CheckOptions options;
  options.tolerance_mm = 0.06;
  const CheckResult r = check(path, needle, scene, options);
  EXPECT_EQ(r.verdicts[0].state, MoveState::clean);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_certified);
  EXPECT_EQ(reason_text(r.verdicts[1].reason),
            "the tolerance lets the surface reach the middle of the cutter, so the tool may be buried; give a smaller "
            "tolerance");
  EXPECT_EQ(r.verdicts[2].state, MoveState::buried);
}

TEST(CheckPath, AnOpenMeshShowsABuriedToolOrSaysThatItCannot) {
  IndexedMesh open = shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 500));
  open.triangles.pop_back();
  open.file_triangle.pop_back();
  const Toolpath path = through({upright(0, 0, -400)});
  EXPECT_EQ(check(path, tools::ball(), {{open}, {}}).counts.buried, 1U);
  IndexedMesh half = open;
  half.triangles.resize(6);
  half.file_triangle.resize(6);
  const CheckResult r = check(path, tools::ball(), {{half}, {}});
  EXPECT_EQ(r.counts.clean, 0U);
}

TEST(CheckPath, AToolInACavityOrBesideTheSolidIsNotBuried) {
  const IndexedMesh hollow = shapes::joined(shapes::box(Vec3(-500, -500, -500), Vec3(500, 500, 500)),
                                            shapes::inside_out(shapes::box(Vec3(-90, -90, -190), Vec3(90, 90, 190))));
  EXPECT_EQ(check(through({upright(0, 0, 0)}), tools::ball(), {{hollow}, {}}).counts.clean, 1U);
  EXPECT_EQ(check(through({upright(700, 0, 0)}), tools::ball(), {{hollow}, {}}).counts.clean, 1U);
}

TEST(CheckPath, RapidsAreCheckedAndCanBeSkippedButNeverCalledClean) {
  const Scene scene{{shapes::box(Vec3(-1, -50, 0), Vec3(1, 50, 20))}, {}};
  const Toolpath path = through({upright(-20, 0, 10), upright(20, 0, 10)}, MoveKind::rapid);
  EXPECT_EQ(check(path, tools::ball(), scene).counts.gouge, 1U);
  CheckOptions skip;
  skip.law = RapidMode::skip;
  const CheckResult r = check(path, tools::ball(), scene, skip);
  EXPECT_EQ(r.counts.not_checked, 2U);
  EXPECT_EQ(r.counts.skipped, 2U);
}

TEST(CheckPath, ADoglegRapidMeetsWhatTheStraightLineMisses) {
  // From (0,0) to (40,10): the straight line passes below the post at (10, 9.5), the dogleg through it.
  const Scene scene{{shapes::box(Vec3(9.9, 9.9, 0), Vec3(10.1, 10.1, 20))}, {}};
  const Toolpath path = through({upright(0, 0, 10), upright(40, 10, 10)}, MoveKind::rapid);
  CheckOptions options;
  EXPECT_EQ(check(path, tools::ball(4), scene, options).counts.gouge, 0U);
  options.law = RapidMode::dogleg;
  EXPECT_EQ(check(path, tools::ball(4), scene, options).counts.gouge, 1U);
}

// A further position behind RAPID is a feed that runs as a rapid.
TEST(CheckPath, AMoveThatMayBeARapidIsCheckedOnlyWhereRapidsRunAsFeeds) {
  Toolpath path = through({upright(0, 0, 0), upright(40, 10, 0), upright(40, 10, 30)});
  for (Move& move : path.moves) move.feed_unit = FeedUnit::rapid;
  const Scene scene{{shapes::moved(shapes::cube(1), Vec3(0, 0, -100))}, {}};
  CheckOptions options;
  EXPECT_EQ(check(path, tools::ball(), scene, options).counts.clean, 3U);
  options.law = RapidMode::dogleg;
  const CheckResult r = check(path, tools::ball(), scene, options);
  EXPECT_EQ(r.verdicts[1].state, MoveState::not_checked);
  EXPECT_TRUE(r.verdicts[1].reason.is(Reason::Kind::rapid_unsure));
  EXPECT_EQ(r.verdicts[2].state, MoveState::clean) << "along one axis a dogleg is straight";
}

TEST(CheckPath, FixturesAreCheckedAndNamed) {
  const Scene scene{{shapes::cube(1)}, {shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}};
  const CheckResult r = check(through({upright(20, 0, -0.5)}), tools::flat(), scene);
  ASSERT_EQ(r.counts.gouge, 1U);
  EXPECT_EQ(r.verdicts[0].witness->against, Against::fixture);
}

TEST(CheckPath, StockToLeaveCountsAgainstThePartAloneNotTheFixture) {
  const IndexedMesh block = shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0));
  const ToolVariants grown = tools::variants(tools::assembly(FlatCutter{10, 30}), 0.3, 0, 0);
  const Toolpath path = through({upright(0, 0, 0.1)});
  const CheckResult part = check(path, grown, {{block}, {}});
  ASSERT_EQ(part.counts.gouge, 1U);
  EXPECT_NEAR(part.verdicts[0].depth_mm, 0.2, 0.001);
  EXPECT_EQ(check(path, grown, {{shapes::moved(shapes::cube(1), Vec3(0, 0, -200))}, {block}}).counts.clean, 1U);
}

TEST(CheckPath, WithoutAToolNothingIsClean) {
  Toolpath path = through({upright(0, 0, 50)});
  const Scene scene{{shapes::cube()}, {}};
  EXPECT_EQ(whole_check(path, nullptr, scene, {}).counts.not_checked, 1U);
  path.moves[0].tool = kNone;
  EXPECT_EQ(whole_check(path, nullptr, scene, {}).counts.not_checked, 1U);
}

// A move knows no start of its own: what stood before it is part of the path.
TEST(CheckPath, AMoveCutOutOfItsPathIsNotCheckedNorReadFromElsewhere) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  const Toolpath whole = through({upright(0, 0, 5), upright(5, 0, 5), upright(5, 0, -1)});
  Toolpath rest = whole;
  rest.moves.erase(rest.moves.begin());
  const CheckResult r = check(rest, tools::ball(), scene);
  EXPECT_EQ(r.verdicts[0].state, MoveState::not_checked);
  EXPECT_EQ(r.verdicts[1].state, MoveState::gouge);
  Toolpath without_curves = whole;
  for (Move& move : without_curves.moves) move.curve_kind = CurveKind::arc;
  EXPECT_EQ(check(without_curves, tools::ball(), scene).counts.not_checked, 3U);
  for (Move& move : without_curves.moves) move.curve_kind = CurveKind::spline;
  EXPECT_EQ(check(without_curves, tools::ball(), scene).counts.not_checked, 3U);
  EXPECT_EQ(gouge::check(whole, CheckSetup{{}, {}, prepare_scene(scene), {}}).counts.not_checked, 3U);
}

// Beyond the coordinates that the bounds are proven for, a float overflows and compares as free.
TEST(CheckPath, WhatIsTooFarAwayForTheBoundsIsNotCheckedAndDoesNotDisturbItsNeighbours) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  const std::vector<Pose> near = {upright(0, 0, 5), upright(5, 0, 5), upright(5, 0, -1)};
  const CheckResult alone = check(through(near), tools::ball(), scene);
  for (const double far : {1.1e5, 1e20, 1e200, std::numeric_limits<double>::quiet_NaN()}) {
    Toolpath path = through({near[0], near[1], near[2], upright(far, 0, -1)});
    path.moves[3].has_start = false;
    CheckResult r = check(path, tools::ball(), scene);
    EXPECT_EQ(r.verdicts[3].state, MoveState::not_checked) << far;
    for (std::size_t i = 0; i < near.size(); ++i) {
      EXPECT_EQ(r.verdicts[i].state, alone.verdicts[i].state);
      EXPECT_EQ(r.verdicts[i].depth_mm, alone.verdicts[i].depth_mm);
      EXPECT_EQ(r.verdicts[i].depth_upper_mm, alone.verdicts[i].depth_upper_mm);
    }
    const Scene shifted{{shapes::moved(scene.parts[0], Vec3(far, 0, 0))}, {}};
    EXPECT_EQ(check(through({upright(far, 0, -1)}), tools::ball(), shifted).counts.not_checked, 1U) << far;
    EXPECT_EQ(check(through(near), tools::ball(), {{scene.parts[0], shifted.parts[0]}, {}}).counts.not_checked, 3U);
  }
}

// A library caller may break what a reader of files never lets through.
TEST(CheckPath, WhatIsNoNumberOrNoUnitVectorIsRefusedWithTheReason) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const auto reason_of = [&](const Pose& pose, bool has_start) {
    Toolpath path = through({upright(0, 0, 5), pose});
    path.moves[1].has_start = has_start;
    const CheckResult r = check(path, tools::ball(), scene);
    EXPECT_EQ(r.verdicts[0].state, MoveState::clean);
    EXPECT_EQ(r.verdicts[1].state, MoveState::not_checked);
    const ToolVariants tool = tools::ball();
    const auto closest_approach = measure_closest_approach(path, {&tool}, prepare_scene(scene), r.verdicts, 1);
    EXPECT_TRUE(closest_approach && closest_approach->cuts == 1 && closest_approach->nearest_mm);
    return reason_text(r.verdicts[1].reason);
  };
  for (const bool has_start : {true, false}) {
    for (const double far : {nan, infinite, -infinite, 1e300, -1.1e5}) {
      for (const Vec3& tip : {Vec3(far, 0, 5), Vec3(0, far, 5), Vec3(0, 0, far)})
        EXPECT_EQ(reason_of({tip, Vec3::UnitZ()}, has_start), reason_text({Reason::Kind::out_of_reach})) << far;
      EXPECT_EQ(reason_of({Vec3(0, 0, 5), Vec3(0, far, 1)}, has_start), "the tool axis is no unit vector") << far;
    }
    for (const Vec3& axis : {Vec3(0, 0, 0), Vec3(0, 0, 2), Vec3(0, 0, 0.99), Vec3(1e-200, 0, 0)})
      EXPECT_EQ(reason_of({Vec3(0, 0, 5), axis}, has_start), "the tool axis is no unit vector");
  }
}

TEST(CheckPath, AToolThatIsNoSolidOfFiniteSizeIsRefusedWithTheReason) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double far : {nan, infinite, 1e300, 1.1e5}) {
    for (CompiledTool ToolVariants::*variant :
         {&ToolVariants::bare, &ToolVariants::against_part, &ToolVariants::against_fixture}) {
      ToolVariants tool = tools::ball();
      (tool.*variant).elements[1].a.x() = far;
      const CheckResult r = check(through({upright(0, 0, 5), upright(0, 0, -5)}), tool, scene);
      EXPECT_EQ(r.counts.not_checked, 2U) << far;
      EXPECT_EQ(reason_text(r.verdicts[1].reason), reason_text({Reason::Kind::out_of_reach})) << far;
    }
  }
  ToolVariants tool = tools::ball();
  tool.against_part.elements[0].radius_mm = nan;
  EXPECT_EQ(check(through({upright(0, 0, 5), upright(0, 0, -5)}), tool, scene).counts.not_checked, 2U);
}

TEST(CheckPath, OptionsThatAreNoLengthsAreRefusedWithTheReason) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const ToolVariants tool = tools::ball();
  std::vector<CheckOptions> wrong(7);
  wrong[0].tolerance_mm = nan;  // compared with it, every depth is small enough
  wrong[1].tolerance_mm = infinite;
  wrong[2].resolution_mm = nan;
  wrong[3].resolution_mm = 0;
  wrong[4].resolution_mm = -1;
  wrong[5].gouge_gap_mm = nan;
  wrong[6].near_miss_mm = infinite;
  for (const CheckOptions& options : wrong) {
    const CheckResult r = whole_check(through({upright(0, 0, 5), upright(0, 0, -1)}), &tool, scene, options);
    EXPECT_EQ(r.counts.not_checked, 2U);
    EXPECT_EQ(reason_text(r.verdicts[1].reason),
              "an option of the check is no finite length, or the resolution is not above 0");
  }
}

TEST(CheckPath, AnArcAboutACentreTooFarAwayIsNotChecked) {
  const Scene scene{{shapes::box(Vec3(-50, -50, -30), Vec3(50, 50, 0))}, {}};
  Toolpath path = through({upright(0, 0, 5), upright(0, 1, 5)});
  path.moves[1].kind = MoveKind::arc;
  path.moves[1].curve_kind = CurveKind::arc;
  for (const double radius : {1e4, 1e6}) {
    path.arcs = {{Vec3(-radius, 0.5, 5), Vec3::UnitZ(), 2 * std::asin(0.5 / radius)}};
    const MoveState expected = radius > 1e5 ? MoveState::not_checked : MoveState::clean;
    EXPECT_EQ(check(path, tools::ball(), scene).verdicts[1].state, expected) << radius;
  }
}

TEST(CheckPath, ThreadsDoNotChangeABit) {
  std::vector<Pose> poses;
  for (int i = 0; i < 600; ++i) {
    poses.push_back({Vec3(0.1 * i - 30, std::sin(0.05 * i) * 10, 9.9 + 0.3 * std::sin(0.3 * i)),
                     Vec3(0.2 * std::sin(0.02 * i), 0.1, 1).normalized()});
  }
  const Toolpath path = through(poses);
  const Scene scene{{shapes::sphere(12, 40, 80)}, {}};
  CheckOptions one, two;
  one.threads = 1;
  two.threads = 2;
  const CheckResult a = check(path, tools::bull(), scene, one);
  const CheckResult b = check(path, tools::bull(), scene, two);
  EXPECT_GT(a.counts.gouge, 10U);
  EXPECT_GT(a.counts.clean, 10U);
  EXPECT_EQ(a.evaluations, b.evaluations);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(a.verdicts[i].state, b.verdicts[i].state);
    EXPECT_EQ(std::memcmp(&a.verdicts[i].depth_mm, &b.verdicts[i].depth_mm, sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(&a.verdicts[i].depth_upper_mm, &b.verdicts[i].depth_upper_mm, sizeof(double)), 0);
  }
}

TEST(CheckPath, TheReversedPathHasTheSameGouges) {
  std::vector<Pose> poses;
  for (int i = 0; i < 200; ++i) poses.push_back(upright(0.3 * i - 30, 2, 11.8 + 0.4 * std::sin(0.3 * i)));
  std::vector<Pose> back(poses.rbegin(), poses.rend());
  const Scene scene{{shapes::sphere(12, 40, 80)}, {}};
  const CheckResult a = check(through(poses), tools::flat(), scene);
  const CheckResult b = check(through(back), tools::flat(), scene);
  EXPECT_GT(a.counts.gouge, 0U);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_NEAR(a.verdicts[i].depth_mm, b.verdicts[poses.size() - i].depth_mm, 0.0011) << i;
  }
}

}  // namespace
}  // namespace gouge::check_path_test
