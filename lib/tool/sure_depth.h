#pragma once

#include <map>
#include <mutex>
#include <utility>

#include "lib/tool/compiled_tool.h"

namespace gouge {

/// What is not a gouge may reach into a solid by no more than this many times the depth allowed. Corners of 45 degrees
/// and more, thus all usual cutters, reach less than 3 times the depth; a blade or a tip of 30 degrees does not.
inline constexpr double kReachPerDepth = 3;

/// What a surface nowhere deeper in a tool than a given depth proves of how far the tool reaches into the solid.
struct SureDepth {
  double depth_mm = 0;  ///< up to here the tool reaches at most kReachPerDepth times the given depth; 0: no such depth
  double reach_mm = 0;  ///< at the given depth itself: at most this (kNoReach_mm: any amount)
  int halvings = 0;     ///< depth_mm = given depth x 2^(-halvings / 2)
};

/// The largest depth of the row given depth x 2^(-k / 2) for which bound_reach(form, bare, depth) is at most
/// kReachPerDepth times the given depth. Cost: bound_reach, once for a usual tool.
[[nodiscard]] SureDepth find_sure_depth(const CompiledTool& form, const CompiledTool& bare, double given_mm);

/// Results of find_sure_depth for one tool, each computed once; may be asked from any thread. A copy starts empty.
class SureDepths {
 public:
  SureDepths() = default;
  SureDepths(const SureDepths& /*other*/) {}
  SureDepths& operator=(const SureDepths& /*other*/) {
    known_.clear();
    return *this;
  }
  /// Requires the same `form` and `bare` at every call.
  [[nodiscard]] SureDepth at(const CompiledTool& form, const CompiledTool& bare, double given_mm) const;

 private:
  mutable std::mutex mutex_;
  mutable std::map<double, SureDepth> known_;
};

}  // namespace gouge
