#pragma once

#include <cstddef>
#include <string>

#include "lib/geom/pose.h"

namespace gouge {

/// The poses near a path that the joints of a machine can take. Constant: several threads may call it.
class PoseReach {
 public:
  virtual ~PoseReach() = default;

  /// Returns whether the machine can have the tool at `pose` where the path has the axis `programmed`, in a move or at
  /// its end.
  [[nodiscard]] virtual bool can_reach(std::size_t move, const Vec3& programmed, const Pose& pose) const = 0;
  /// Names the joint that prevents it, with its limit: "joint A would be at 31 degrees; its limit is 30 degrees". Empty:
  /// can_reach is true.
  [[nodiscard]] virtual std::string why_not(std::size_t move, const Vec3& programmed, const Pose& pose) const = 0;
};

}  // namespace gouge
