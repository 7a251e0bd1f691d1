#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "lib/tilt/plan_tilts.h"
#include "tests/support/paths.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

// Holders beside walls: a ball cutter of 10 mm, stick-out 40 mm, holder of 30 mm. Its centre is 5 mm above the tip, so
// the lower edge of the holder is 35 mm above the centre and 15 mm beside the axis. At a wall at distance x of the
// centre it is free from the tilt on for which 15 cos - 35 sin = x.

namespace gouge::tilt_bench {

using paths::upright;
inline constexpr double kDegree = std::numbers::pi / 180;

inline ToolAssembly long_ball() {
  ToolAssembly tool;
  tool.number = 1;
  tool.cutter = BallCutter{10, 20};
  tool.shank = {{10, 10, 20}};
  tool.holder = {{30, 30, 60}};
  return tool;
}

/// Least tilt, rad, that frees the holder beside a wall at a distance of the ball's centre.
inline double min_tilt(double distance_mm) { return std::acos(distance_mm / std::hypot(15, 35)) - std::atan2(35, 15); }

inline IndexedMesh floor_plate() { return shapes::box(Vec3(-200, -200, -10), Vec3(200, 200, 0)); }

/// Totals of all runs.
inline std::vector<TiltedPosition> positions_of(const TiltPlan& plan) {
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

inline double largest_tilt(const TiltPlan& plan) {
  double most = 0;
  for (const TiltedPosition& p : positions_of(plan)) most = std::max(most, p.tilt_rad);
  return most;
}

/// A row at z = 0 along y, from above and up again.
inline std::vector<Pose> row(double from, double to, double step, double x = 0) {
  std::vector<Pose> poses{upright(x, from, 120)};
  for (double y = from; y < to + 1e-9; y += step) poses.push_back(upright(x, y, 0));
  poses.push_back(upright(x, to, 120));
  return poses;
}

inline void expect_clean(const Bench& bench, const TiltPlan& plan) {
  EXPECT_TRUE(plan.failed.empty()) << plan.failed.front().reason;
  const Toolpath path = bench.tilted(plan);
  const CheckResult after = check(path, bench.own.setup);
  EXPECT_EQ(after.counts.clean, path.moves.size());
}

}  // namespace gouge::tilt_bench
