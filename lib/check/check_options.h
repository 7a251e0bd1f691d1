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
  double tolerance_mm = 0.01;                 ///< maximum depth of a move that is not a gouge (bodies with a clearance:
                                              ///< 0)
  double resolution_mm = 0.001;               ///< certified gap between the bounds of a depth
  double gouge_gap_mm = 0;                    ///< maximum gap between the bounds of a gouge's depth; 0: the resolution
  double stock_to_leave_mm = 0;               ///< offset of the cutter against the part
  double shank_clearance_mm = 0;              ///< offset of the shank
  double holder_clearance_mm = 0;             ///< offset of the holder
  double near_miss_mm = 0;                    ///< 0: not requested
  bool is_depth_alone = false;                ///< do not check how far thin and pointed features reach into a solid
  MotionLaw law;                              ///< motion of the tool between positions
  MotionTube tube;                            ///< largest departure of the tool from that motion
  std::uint64_t turn_boxes = 200;             ///< maximum number of boxes of rotary joints examined in a move
                                              ///< (LawScope::any)
  unsigned threads = 0;                       ///< number of threads; 0: all
  std::uint64_t budget_per_move = 2'000'000;  ///< number of bounds after which a move is "not certified"
};

/// Minimum resolution of a depth. Below it the search would only resolve rounding.
inline constexpr double kFinestResolution_mm = 1e-6;

/// Returns the maximum depth of a surface in a tool with a guarantee: the tool reaches no farther into the solid than
/// kReachPerDepth times (tolerance + resolution).
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
