#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "lib/geom/vec.h"
#include "lib/verify/moving_pose.h"
#include "lib/verify/tool_contour.h"
#include "lib/verify/triangle_order.h"

// The proof that no point of a surface is deeper in a tool than a given depth during a motion. The whole surface and
// the whole time are halved until each part is separated (separation.h). The proof is the sequence of these steps in
// the order of a traversal, one byte for each step. The halves always cover the whole, so no part can be left out.

namespace gouge {

/// Steps that divide the surface or the time. The other steps are a ProofKind.
inline constexpr char kCutSurface = 0, kCutTime = 1;

struct ProofQuestion {
  const ToolContour& tool;
  const TriangleOrder& surface;
  double depth_mm = 0;
};

/// Tolerance of verified bounds: a depth is proved to be at most the claimed depth plus this value.
inline constexpr double kProofSlack_mm = 1e-6;

/// Appends the steps of a proof to `steps`. Returns false if it finds no proof within `max_tries`; `steps` is then
/// unchanged.
/// Requires RoundsUpward, at least one piece.
[[nodiscard]] bool find_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces,
                              std::uint64_t max_tries, std::string& steps);

/// The place where a proof fails.
struct ProofFault {
  std::size_t piece = 0;  ///< index in `pieces`
  Vec3 point = Vec3::Zero();
  const char* what = "";
};

/// Follows a proof from the beginning of `steps` and removes it there. Returns false if the proof is wrong; `fault`
/// states where. Requires RoundsUpward, at least one piece. Cost: linear in the number of steps, for any content.
[[nodiscard]] bool follow_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces,
                                std::string_view& steps, ProofFault& fault);

}  // namespace gouge
