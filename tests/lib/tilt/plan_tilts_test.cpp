#include "lib/tilt/plan_tilts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lib/path/axis_quality.h"
#include "lib/path/path_info.h"
#include "tests/lib/tilt/tilt_bench.h"
#include "tests/support/motions.h"

namespace gouge::plan_tilts_test {
namespace {

using namespace tilt_bench;

TEST(PlanTilts, BesideAWallIsTheLeastTiltThatFreesTheHolder) {
  for (const double wall : {6.0, 9.0, 12.0}) {
    const Bench bench(row(-40, 40, 5), {floor_plate(), shapes::box(Vec3(wall, -100, -5), Vec3(wall + 50, 100, 90))});
    const TiltPlan plan = bench.plan();
    expect_clean(bench, plan);
    const double least = min_tilt(wall);
    for (const TiltedPosition& p : positions_of(plan)) {
      if (p.programmed.tip.z() > 0 || std::abs(p.programmed.tip.y()) > 35) continue;
      EXPECT_GT(p.tilt_rad, least - 0.1 * kDegree) << wall;
      EXPECT_LT(p.tilt_rad, least + 0.1 * kDegree) << wall;
      // The ball stays where it was: it cuts the same surface.
      EXPECT_NEAR((p.pose.tip + 5 * p.pose.axis - p.programmed.tip - 5 * p.programmed.axis).norm(), 0, 1e-9);
    }
  }
}

TEST(PlanTilts, FadesInAndOutAndLeavesTheEndsAsProgrammed) {
  // The wall stands beside the middle of the row.
  const Bench bench(row(-150, 150, 5), {floor_plate(), shapes::box(Vec3(8, -20, -5), Vec3(40, 20, 90))});
  TiltOptions options;
  options.blend_mm = 25;
  const TiltPlan plan = bench.plan(options);
  expect_clean(bench, plan);
  ASSERT_EQ(plan.runs.size(), 1U);
  double first = 1e9, last = -1e9;
  for (const TiltedPosition& p : plan.runs[0].positions) {
    if (!(p.tilt_rad > 0)) continue;
    first = std::min(first, p.programmed.tip.y());
    last = std::max(last, p.programmed.tip.y());
  }
  // The holder collides from about -35 to 35.
  EXPECT_LT(first, -45);
  EXPECT_GT(first, -80);
  EXPECT_GT(last, 45);
  EXPECT_LT(last, 80);
}

TEST(PlanTilts, TurnsSmootherThanTheLeastTiltOfEachPosition) {
  const Bench bench(row(-100, 100, 2), {floor_plate(), shapes::box(Vec3(8, -20, -5), Vec3(40, 20, 90))});
  TiltOptions options;
  options.blend_mm = 40;
  const TiltPlan plan = bench.plan(options);
  expect_clean(bench, plan);
  // Method of open-source tools: at every position the least tilt that frees it there.
  std::vector<Pose> least;
  double most = 0;
  for (const Move& move : bench.path.moves) {
    Pose pose = move.end;
    for (double tilt = 0; tilt < 30 * kDegree; tilt += 0.05 * kDegree) {
      const Vec3 axis(-std::sin(tilt), 0, std::cos(tilt));
      pose = {move.end.tip + 5 * move.end.axis - 5 * axis, axis};
      most = std::max(most, tilt);
      if (bench.checker.is_clean(MotionLaw::tool_at(pose), MoveKind::feed, bench.tool, bench.own.options)) break;
    }
    least.push_back(pose);
  }
  const double smooth = measure_axis_quality(bench.tilted(plan)).bending;
  EXPECT_LT(20 * smooth, measure_axis_quality(paths::through(least)).bending);
  EXPECT_LT(largest_tilt(plan), most + 2 * kDegree);
}

TEST(PlanTilts, LeansOneWayAndThenTheOtherWhereWallsStandOnBothSides) {
  const Bench bench(row(-150, 150, 5), {floor_plate(), shapes::box(Vec3(8, -80, -5), Vec3(40, -40, 90)),
                                        shapes::box(Vec3(-40, 40, -5), Vec3(-8, 80, 90))});
  const TiltPlan plan = bench.plan();
  expect_clean(bench, plan);
  double to_left = 0, to_right = 0;
  for (const TiltedPosition& p : positions_of(plan)) {
    to_left = std::max(to_left, -p.pose.axis.x());
    to_right = std::max(to_right, p.pose.axis.x());
  }
  EXPECT_GT(to_left, std::sin(min_tilt(8)) - 0.01);
  EXPECT_GT(to_right, std::sin(min_tilt(8)) - 0.01);
}

TEST(PlanTilts, IsNoneInAWellAndSaysWhatIsInTheWay) {
  // Narrower than the holder on all sides.
  const std::vector<IndexedMesh> well{floor_plate(), shapes::box(Vec3(10, -60, -5), Vec3(60, 60, 90)),
                                      shapes::box(Vec3(-60, -60, -5), Vec3(-10, 60, 90)),
                                      shapes::box(Vec3(-10, 10, -5), Vec3(10, 60, 90)),
                                      shapes::box(Vec3(-10, -60, -5), Vec3(10, -10, 90))};
  const Bench bench({upright(0, 0, 120), upright(0, 0, 0), upright(0, 0, 120)}, well);
  const TiltPlan plan = bench.plan();
  EXPECT_TRUE(plan.runs.empty());
  ASSERT_EQ(plan.failed.size(), 1U);
  EXPECT_NE(plan.failed[0].reason.find("no tilt within --max-tilt 30 degrees frees line"), std::string::npos)
      << plan.failed[0].reason;
  EXPECT_NE(plan.failed[0].reason.find("the holder is "), std::string::npos) << plan.failed[0].reason;
}

TEST(PlanTilts, KeepsItsLimitsAtEveryInstant) {
  const Bench bench(row(-60, 60, 5), {floor_plate(), shapes::box(Vec3(9, -30, -5), Vec3(40, 30, 90))});
  struct Case {
    TiltOptions options;
    bool is_solvable;
  };
  TiltOptions usual, tight, lead, side, cone, slow;
  tight.max_tilt_rad = min_tilt(9) - 0.2 * kDegree;
  usual.max_tilt_rad = min_tilt(9) + 0.5 * kDegree;
  lead.freedom = TiltFreedom::lead;
  side.freedom = TiltFreedom::side;
  cone.cone = AxisCone{Vec3(0.1, 0, 1).normalized(), 16 * kDegree};
  slow.max_turn_rad_per_mm = 1.5 * kDegree;
  for (const auto& [options, is_solvable] : {Case{usual, true}, Case{tight, false}, Case{lead, false}, Case{side, true},
                                             Case{cone, true}, Case{slow, true}}) {
    const TiltPlan plan = bench.plan(options);
    EXPECT_EQ(plan.failed.empty(), is_solvable);
    if (!plan.failed.empty()) continue;
    expect_clean(bench, plan);
    const Toolpath path = bench.tilted(plan);
    for (std::size_t i = 1; i < path.moves.size(); ++i) {
      const Motion motion = test::straight(path.start_of(i), path.moves[i].end);
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec3 axis = motion.at(t).axis;
        EXPECT_LE(angle_between_rad(axis, Vec3::UnitZ()), options.max_tilt_rad + 1e-6);
        if (options.cone) {
          EXPECT_LE(angle_between_rad(axis, options.cone->axis), options.cone->half_angle_rad + 1e-6);
        }
        // Along the row a tilt to the side leaves the direction of the feed alone.
        if (options.freedom == TiltFreedom::side && path.moves[i].end.tip.z() < 1) {
          EXPECT_NEAR(axis.y(), 0, 1e-9);
        }
      }
      const double way = std::max(motion.path_length_mm(0, 1, 0), 1e-6);
      EXPECT_LE(motion.turn_rad(), options.max_turn_rad_per_mm * way + 1e-9) << i;
    }
  }
}

TEST(PlanTilts, RaisesTheTipWhereTheTiltedCutterWouldGouge) {
  ToolAssembly tool = long_ball();
  tool.cutter = FlatCutter{10, 20};
  // A flat end in a narrow channel between two low ridges: tilted, its edge would cut into one of them.
  const Bench bench(
      row(-40, 40, 5),
      {floor_plate(), shapes::box(Vec3(9, -100, -5), Vec3(60, 100, 90)),
       shapes::box(Vec3(5.1, -100, -5), Vec3(6, 100, 0.5)), shapes::box(Vec3(-6, -100, -5), Vec3(-5.1, 100, 0.5))},
      tool);
  TiltOptions options;
  options.max_stock_mm = std::numeric_limits<double>::infinity();
  const TiltPlan plan = bench.plan(options);
  expect_clean(bench, plan);
  double highest = 0;
  for (const TiltedPosition& p : positions_of(plan)) highest = std::max(highest, p.pose.tip.z() - p.programmed.tip.z());
  EXPECT_GT(highest, 0.1);
}

TEST(PlanTilts, OfAFlatEndIsNotMadeWhereItWouldLeaveMoreThanAllowed) {
  ToolAssembly tool = long_ball();
  tool.cutter = FlatCutter{10, 20};
  const Bench bench(row(-60, 60, 5), {floor_plate(), shapes::box(Vec3(9, -30, -5), Vec3(40, 30, 90))}, tool);
  const TiltPlan none = bench.plan();
  EXPECT_TRUE(none.runs.empty());
  ASSERT_EQ(none.failed.size(), 1U);
  const std::string& reason = none.failed[0].reason;
  EXPECT_EQ(reason.rfind("the holder collides; the tilt that frees it and leaves least (", 0), 0U) << reason;
  EXPECT_NE(reason.find(" mm or more of stock at ("), std::string::npos) << reason;
  // Above the floor, where nothing was finished, nothing is left.
  std::vector<Pose> above = row(-60, 60, 5);
  for (Pose& pose : above) pose.tip.z() += 0.3;
  const Bench rough(above, {floor_plate(), shapes::box(Vec3(9, -30, -5), Vec3(40, 30, 90))}, tool);
  expect_clean(rough, rough.plan());
  TiltOptions allowed;
  allowed.max_stock_mm = 5;
  expect_clean(bench, bench.plan(allowed));
}

TEST(PlanTilts, KeepsAClosedContourClosed) {
  // Around in a pocket with walls of two heights, down and up at the place where it begins and ends.
  std::vector<Pose> poses{upright(0, -40, 120)};
  const int count = 90;
  for (int k = 0; k <= count; ++k) {
    const double angle = 2 * std::numbers::pi * (k % count) / count;
    poses.push_back(upright(40 * std::sin(angle), -40 * std::cos(angle), 0));
  }
  poses.push_back(upright(0, -40, 120));
  enum Walls { beside, at_seam, around };
  for (const Walls walls : {beside, at_seam, around}) {
    const bool is_begin_walled = walls != beside;
    std::vector<IndexedMesh> parts{floor_plate(), shapes::box(Vec3(47, -100, -5), Vec3(90, 100, 60))};
    if (is_begin_walled) parts.push_back(shapes::box(Vec3(-12, -90, -5), Vec3(100, -47, 90)));
    if (walls == around) {
      parts.push_back(shapes::box(Vec3(-90, -100, -5), Vec3(-48, 100, 60)));
      parts.push_back(shapes::box(Vec3(-100, 49, -5), Vec3(100, 90, 90)));
    }
    const Bench bench(poses, parts);
    const TiltPlan plan = bench.plan();
    expect_clean(bench, plan);
    EXPECT_EQ(plan.runs.size(), walls == at_seam ? 2U : 1U);
    const Toolpath path = bench.tilted(plan);
    std::vector<Pose> seam;
    for (const Move& move : path.moves)
      if ((move.end.tip + 5 * move.end.axis - Vec3(0, -40, 5)).norm() < 1e-6) seam.push_back(move.end);
    ASSERT_EQ(seam.size(), 2U);
    EXPECT_NEAR((seam[0].tip - seam[1].tip).norm(), 0, 1e-7);
    EXPECT_NEAR((seam[0].axis - seam[1].axis).norm(), 0, 1e-9);
    EXPECT_EQ(angle_between_rad(seam[0].axis, Vec3::UnitZ()) > 1 * kDegree, is_begin_walled);
  }
}

TEST(PlanTilts, IsTheSameAtAnyNumberOfThreads) {
  const std::vector<IndexedMesh> parts{floor_plate(), shapes::box(Vec3(8, -20, -5), Vec3(40, 20, 90)),
                                       shapes::box(Vec3(-40, 60, -5), Vec3(-7, 90, 90))};
  const Bench one(row(-120, 120, 3), parts, long_ball(), 1), many(row(-120, 120, 3), parts, long_ball(), 5);
  const Toolpath a = one.tilted(one.plan()), b = many.tilted(many.plan());
  ASSERT_EQ(a.moves.size(), b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    EXPECT_EQ(a.moves[i].end.tip, b.moves[i].end.tip);
    EXPECT_EQ(a.moves[i].end.axis, b.moves[i].end.axis);
  }
}

}  // namespace
}  // namespace gouge::plan_tilts_test
