#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "tests/bench/bench_part.h"
#include "tests/bench/bench_tool.h"

// A part of the benchmark and its finishing, as plain data: surface, tools, and a curve that
// states for every point of the path where the tool touches and how it leans.

namespace gouge::bench {

/// One point of the finishing curve.
struct CurvePoint {
  double x_mm = 0, y_mm = 0;          ///< where the tool touches, seen from above
  Vec2 forward = Vec2::UnitX();       ///< direction of travel seen from above, unit
  double lead_deg = 0, tilt_deg = 0;  ///< lean of the axis against the surface's normal
  double lift_mm = 0;                 ///< above 0: an air pass, lifted by that much
  double dip_mm = 0;                  ///< above 0: pushed into the surface by that much
  double holder_share = 0;            ///< 0 to 1: how much of the lean that makes the holder hit
  double holder_depth_mm = 0;         ///< how deep it hits at share 1
};

struct PartPlan {
  std::string name;
  Height height;
  std::function<IndexedMesh(std::size_t triangles)> mesh;
  std::vector<BenchTool> tools;
  std::size_t positions = 0;
  std::function<CurvePoint(double u)> curve;  ///< u in [0, positions)
};

/// The wavy block, 100 x 100 mm, finished in 80 passes of 250 positions: what the engine is tuned with.
[[nodiscard]] PartPlan plan_wavy();

/// A bladed hub with pockets, finished along a spiral with other tools: never examined while tuning.
[[nodiscard]] PartPlan plan_unseen();

/// 0 outside (first, last), 1 inside but for smooth ramps of the given length at both ends.
[[nodiscard]] double window(double at, double first, double last, double ramp);

}  // namespace gouge::bench
