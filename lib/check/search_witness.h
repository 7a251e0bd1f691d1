#pragma once

#include "lib/check/search.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"
#include "lib/tool/evaluate.h"

namespace gouge {

/// A surface point in the coordinates of the tool at an instant of a motion. The pose is the one that any reader of the
/// file computes, so that the evidence can be checked by hand.
struct ToolPoint {
  Pose pose;
  Vec3 out = Vec3::UnitX();  ///< unit direction from the tool axis to the point
  double r = 0, z = 0;       ///< mm
};

/// Locates the point of a result. Requires found.has_witness.
[[nodiscard]] ToolPoint locate(const Motion& motion, const SearchResult& found);

/// Returns the evidence of a result on `target`. `at` is the distance of the located point from the target's tool.
[[nodiscard]] Witness make_witness(const Motion& motion, const SearchResult& found, const SearchTarget& target,
                                   const ToolPoint& point, const ToolDistance& at);

}  // namespace gouge
