// Holders beside walls: a ball cutter of 10 mm, stick-out 40 mm, holder of 30 mm. Its centre is 5 mm above the tip, so
// the lower edge of the holder is 35 mm above the centre and 15 mm beside the axis. At a wall at distance x of the
// centre it is free from the tilt on for which 15 cos - 35 sin = x.
#include "lib/tilt/plan_tilts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "lib/path/axis_quality.h"
#include "lib/path/path_info.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge {
namespace {

using paths::upright;
constexpr double kDegree = std::numbers::pi / 180;

ToolAssembly long_ball() {
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = BallCutter{10, 20};
  tool.shank = {{10, 10, 20}};
  tool.holder = {{30, 30, 60}};
  return tool;
}

/// Least tilt, rad, that frees the holder beside a wall at a distance of the ball's centre.
double least_tilt(double distance_mm) { return std::acos(distance_mm / std::hypot(15, 35)) - std::atan2(35, 15); }

IndexedMesh floor_plate() { return shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)); }

/// Of all runs.
std::vector<TiltedPosition> positions_of(const TiltPlan& plan) {
  std::vector<TiltedPosition> all;
  for (const SmoothedRun& run : plan.runs) all.insert(all.end(), run.positions.begin(), run.positions.end());
  return all;
}

struct Bench {
  ToolVariants tool;
  Scene scene;
  Toolpath path;
  OwnSetup own;
  CheckResult before;
  MotionChecker checker;

  Bench(const std::vector<Pose>& poses, std::vector<IndexedMesh> parts, const ToolAssembly& assembly = long_ball(),
        unsigned threads = 1)
      : tool(tools::variants(assembly)),
        scene(scene_of(std::move(parts))),
        path(paths::through(poses)),
        own(&tool, scene, options_of(threads)),
        before(check(path, own.setup)),
        checker(own.setup) {}

  static Scene scene_of(std::vector<IndexedMesh> parts) {
    Scene scene;
    scene.parts = std::move(parts);
    return scene;
  }
  static CheckOptions options_of(unsigned threads) {
    CheckOptions options;
    options.threads = threads;
    return options;
  }

  [[nodiscard]] TiltPlan plan(const TiltOptions& options = {}) const {
    std::vector<bool> is_wanted;
    for (const MoveVerdict& verdict : before.verdicts)
      is_wanted.push_back(verdict.state == MoveState::gouge && verdict.witness->body != Body::cutter);
    return plan_tilts({path, before, own.setup.tools, checker, options, is_wanted}, {});
  }

  /// The path with the plan's positions in it.
  [[nodiscard]] Toolpath tilted(const TiltPlan& plan) const {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      Pose end = path.moves[i].end;
      for (const TiltedPosition& p : positions_of(plan)) {
        if (p.move == i && !p.is_end) poses.push_back(p.pose);
        if (p.move == i && p.is_end) end = p.pose;
      }
      poses.push_back(end);
    }
    return paths::through(poses);
  }
};

double largest_tilt(const TiltPlan& plan) {
  double most = 0;
  for (const TiltedPosition& p : positions_of(plan)) most = std::max(most, p.tilt_rad);
  return most;
}

/// A row at z = 0 along y, from above and up again.
std::vector<Pose> row(double from, double to, double step, double x = 0) {
  std::vector<Pose> poses{upright(x, from, 120)};
  for (double y = from; y < to + 1e-9; y += step) poses.push_back(upright(x, y, 0));
  poses.push_back(upright(x, to, 120));
  return poses;
}

void expect_clean(const Bench& bench, const TiltPlan& plan) {
  EXPECT_TRUE(plan.failed.empty()) << plan.failed.front().reason;
  const Toolpath path = bench.tilted(plan);
  const CheckResult after = check(path, bench.own.setup);
  EXPECT_EQ(after.counts.clean, path.moves.size());
}

TEST(PlanTilts, BesideAWallIsTheLeastTiltThatFreesTheHolder) {
  for (const double wall : {6.0, 9.0, 12.0}) {
    const Bench bench(row(-40, 40, 5), {floor_plate(), shapes::box(Vec3(wall, -100, -5), Vec3(wall + 50, 100, 90))});
    const TiltPlan plan = bench.plan();
    expect_clean(bench, plan);
    const double least = least_tilt(wall);
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
  // What open tools do: at every position the least tilt that frees it there.
  std::vector<Pose> least;
  double most = 0;
  for (const Move& move : bench.path.moves) {
    Pose pose = move.end;
    for (double tilt = 0; tilt < 30 * kDegree; tilt += 0.05 * kDegree) {
      const Vec3 axis(-std::sin(tilt), 0, std::cos(tilt));
      pose = {move.end.tip + 5 * move.end.axis - 5 * axis, axis};
      most = std::max(most, tilt);
      if (bench.checker.is_clean(Motion(pose), MoveKind::feed, bench.tool, bench.own.options)) break;
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
  EXPECT_GT(to_left, std::sin(least_tilt(8)) - 0.01);
  EXPECT_GT(to_right, std::sin(least_tilt(8)) - 0.01);
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
  tight.max_tilt_rad = least_tilt(9) - 0.2 * kDegree;
  usual.max_tilt_rad = least_tilt(9) + 0.5 * kDegree;
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
      const Motion motion(path.start_of(i), path.moves[i].end);
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
      EXPECT_LE(motion.angle_rad(), options.max_turn_rad_per_mm * way + 1e-9) << i;
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
  EXPECT_NE(reason.find(" mm of stock at ("), std::string::npos) << reason;
  // Above the floor, where nothing was finished, nothing is left.
  std::vector<Pose> above = row(-60, 60, 5);
  for (Pose& pose : above) pose.tip.z() += 0.3;
  const Bench rough(above, {floor_plate(), shapes::box(Vec3(9, -30, -5), Vec3(40, 30, 90))}, tool);
  expect_clean(rough, rough.plan());
  TiltOptions allowed;
  allowed.max_stock_mm = 5;
  expect_clean(bench, bench.plan(allowed));
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
}  // namespace gouge
