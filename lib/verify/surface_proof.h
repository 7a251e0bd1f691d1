#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lib/geom/vec.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"
#include "lib/verify/triangle_order.h"

// The proof that no point of a surface is deeper in a tool than a depth during a motion. All of the surface and all of
// the time are cut in halves until each part is separated (separation.h). The proof is written as the cuts in the order
// of a walk, a byte a step. So a proof for the parts is one for the whole: no part can be left out.

namespace gouge {

/// Cuts, the other steps being a ProofKind.
inline constexpr char kCutSurface = 0, kCutTime = 1;

struct ProofQuestion {
  const ToolContour& tool;
  const TriangleOrder& surface;
  double depth_mm = 0;
};

/// Verified bounds are true to this: a depth is proved to be no more than what is claimed and this.
inline constexpr double kProofSlack_mm = 1e-6;

/// Appends the steps of a proof. False where none was found within `max_tries`; `steps` is then as it was.
/// Requires RoundsUpward, at least one piece.
[[nodiscard]] bool find_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces,
                              std::uint64_t max_tries, std::string& steps);

/// Place where a proof fails.
struct ProofFault {
  std::size_t piece = 0;  ///< of `pieces`
  Vec3 point = Vec3::Zero();
  const char* what = "";
};

/// Follows a proof from the front of `steps` and removes it there. False: it proves nothing, and `fault` states
/// where. Requires RoundsUpward, at least one piece. Cost: linear in the steps, whatever they state.
[[nodiscard]] bool follow_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces,
                                std::string_view& steps, ProofFault& fault);

}  // namespace gouge
