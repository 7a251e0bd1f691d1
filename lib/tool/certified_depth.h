#pragma once

#include <map>
#include <mutex>
#include <utility>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// Maximum reach of a tool into a solid, as a multiple of the allowed depth, that does not count as a gouge. Corners of
/// 45 degrees and more, and thus all usual cutters, reach less than 3 times the depth. A blade or a tip of 30 degrees
/// reaches farther.
inline constexpr double kReachPerDepth = 3;

/// Bounds how far a tool reaches into a solid whose surface is nowhere deeper in the tool than a given depth.
struct CertifiedDepth {
  double depth_mm = 0;  ///< at this depth the tool reaches at most kReachPerDepth times the given depth; 0: there is no
                        ///< such depth
  double reach_mm = 0;  ///< bound of the reach at the given depth; kNoReach_mm: any amount
  int halvings = 0;     ///< depth_mm = given depth x 2^(-halvings / 2)
};

/// Returns the largest depth of the sequence given depth x 2^(-k / 2) for which bound_reach(form, bare, depth) is at
/// most kReachPerDepth times the given depth. Cost: bound_reach, once for a usual tool.
[[nodiscard]] CertifiedDepth find_certified_depth(const CompiledTool& form, const CompiledTool& bare, double given_mm);

/// Stored results of find_certified_depth for one tool. Each is computed once; any thread may query it. A copy starts
/// empty.
class CertifiedDepths {
 public:
  CertifiedDepths() = default;
  CertifiedDepths(const CertifiedDepths& /*other*/) {}
  CertifiedDepths& operator=(const CertifiedDepths& /*other*/) {
    known_.clear();
    return *this;
  }
  /// Returns the result of find_certified_depth. Requires the same `form` and `bare` at every call.
  [[nodiscard]] CertifiedDepth at(const CompiledTool& form, const CompiledTool& bare, double given_mm) const;

 private:
  mutable std::mutex mutex_;
  mutable std::map<double, CertifiedDepth> known_;
};

}  // namespace gouge
