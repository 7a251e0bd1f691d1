#pragma once

#include <algorithm>
#include <vector>

#include "lib/stock/check_stock.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

// A block of stock and short programs that cut it. Header only.

namespace gouge::block {

/// The block from (-50, -50, -40) to (50, 50, 0).
inline StockSolid solid() { return StockSolid::box(Vec3(-50, -50, -40), Vec3(50, 50, 0)); }

struct Step {
  MoveKind kind;
  Pose to;
};

inline constexpr MoveKind kFeed = MoveKind::feed, kRapid = MoveKind::rapid;

/// Returns the path of the first tool through these positions.
inline Toolpath path_of(const std::vector<Step>& steps) {
  std::vector<Pose> poses;
  for (const Step& step : steps) poses.push_back(step.to);
  Toolpath path = paths::through(poses);
  for (std::size_t i = 0; i < steps.size(); ++i) path.moves[i].kind = steps[i].kind;
  return path;
}

/// Appends moves of another tool; its first position follows a tool change.
inline void append(const std::vector<Step>& steps, std::size_t tool, Toolpath& path) {
  path.tools.resize(std::max(path.tools.size(), tool + 1));
  for (const Step& step : steps) {
    Move move;
    move.kind = step.kind;
    move.end = step.to;
    move.tool = tool;
    move.line = path.moves.size() + 1;
    move.has_start = &step != steps.data();
    path.moves.push_back(move);
  }
}

inline StockResult run(const Toolpath& path, const std::vector<ToolVariants>& tools,
                       const StockSolid& stock = solid()) {
  std::vector<StockTool> all;
  for (const ToolVariants& tool : tools) all.push_back({&tool, true});
  const MotionLaw law;
  const StockOptions options;
  const CutHistory history(path, law, all, options);
  return check_stock(history, stock, options, 1);
}

/// A flat cutter with flutes of this length and a shank.
inline ToolVariants flat(double diameter, double flutes, double shank_diameter, double shank_length = 20) {
  ToolAssembly tool = tools::assembly(FlatCutter{diameter, flutes}, shank_diameter);
  tool.shank = {{shank_diameter, shank_diameter, shank_length}};
  return tools::variants(tool);
}

/// Returns a program of feeds and rapids about the upper face of a small block, whose face is z = 0. In moves of five axes
/// the tool axis turns by up to about `turn_rad`. After this share of the positions the tool leaves it along its axis and
/// comes back, both in rapid.
inline Toolpath random_program(test::Scatter& scatter, bool is_five_axis, int positions, double turn_rad = 0.15,
                               double axial_share = 0) {
  std::vector<Step> steps;
  Vec3 tip = scatter.point(12), axis = is_five_axis ? scatter.axis(0.5) : Vec3::UnitZ();
  tip.z() = scatter.in(-6, 6);
  for (int k = 0; k < positions; ++k) {
    const Pose pose{tip, axis};
    steps.push_back({kFeed, pose});
    if (axial_share > 0 && scatter.is(axial_share)) {
      steps.push_back({kRapid, {Vec3(tip + scatter.in(0.5, 15) * axis), axis}});
      steps.push_back({kRapid, pose});
    }
    tip += scatter.point(scatter.is(0.5) ? 2 : 12);
    tip = tip.cwiseMin(Vec3(14, 14, 8)).cwiseMax(Vec3(-14, -14, -9));
    if (is_five_axis && scatter.is(0.7)) axis = Vec3((axis + turn_rad * scatter.point(1)).normalized());
  }
  for (Step& step : steps)
    if (step.kind == kFeed && scatter.is(0.3)) step.kind = kRapid;
  return path_of(steps);
}

/// Small tools of all shapes of cutters, with a shank and a holder close above their flutes.
inline std::vector<ToolVariants> small_tools() {
  std::vector<ToolVariants> made;
  for (const Cutter& cutter :
       std::vector<Cutter>{FlatCutter{6, 5}, BallCutter{6, 6}, BullNoseCutter{8, 1, 5}, TaperedCutter{3, 1, 5, 8},
                           LollipopCutter{6, 3, 0}, TSlotCutter{10, 0.5, 0.5, 4}, DovetailCutter{8, 0.5, 30, 5},
                           RadiusCutter{4, 0.5, 2, 8, 5}}) {
    ToolAssembly tool = tools::assembly(cutter, 5);
    tool.shank = {{5, 5, 10}};
    tool.holder = {{14, 16, 12}};
    made.push_back(tools::variants(tool));
  }
  return made;
}

}  // namespace gouge::block
