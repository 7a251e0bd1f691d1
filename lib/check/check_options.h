#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/motion/motion_law.h"
#include "lib/tool/motion_tube.h"

namespace gouge {

/// Options of the check. Lengths in mm.
struct CheckOptions {
  double tolerance_mm = 0.01;                 ///< depth a move may have (bodies with a clearance: 0)
  double resolution_mm = 0.001;               ///< certified gap
  double gouge_gap_mm = 0;                    ///< gap to which the depth of a gouge is closed; 0: the resolution
  double stock_to_leave_mm = 0;               ///< grows the cutter against the part
  double shank_clearance_mm = 0;              ///< grows the shank
  double holder_clearance_mm = 0;             ///< grows the holder
  double near_miss_mm = 0;                    ///< 0: not requested
  bool is_depth_alone = false;                ///< how far thin and pointed features reach into a solid is not requested
  MotionLaw law;                              ///< how the tool moves between positions
  MotionTube tube;                            ///< how far the tool may depart from that
  unsigned threads = 0;                       ///< 0: all
  std::uint64_t budget_per_move = 2'000'000;  ///< bounds computed before a move is "not certified"
};

/// The least resolution of a depth that may be requested, beyond which the search would work on rounding alone.
inline constexpr double kFinestResolution_mm = 1e-6;

/// Returns how deep a surface may be in a tool without that the tool reaches farther into the solid than kReachPerDepth
/// times tolerance + resolution.
[[nodiscard]] inline CertifiedDepth certified_depth(const ToolVariants& tool, const PreparedScene& scene,
                                                    const CheckOptions& options) {
  std::vector<ToolVariants::CertifiedForm> forms;
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    if (!obstacle.meshes.empty())
      forms.push_back({&(tool.*obstacle.rule.form), &(tool.*obstacle.rule.certified_depths)});
  }
  return tool.certified_depth(forms, options.tolerance_mm + options.resolution_mm);
}

}  // namespace gouge
