#pragma once

#include "lib/check/motion.h"
#include "lib/tool/compiled_tool.h"

namespace gouge {

/// A tool along one motion, asked from a point of the part.
class SweptTool {
 public:
  /// Requires motion.is_defined() and a tool with elements; both must outlive it.
  SweptTool(const Motion& motion, const CompiledTool& tool) : motion_(motion), tool_(tool) {}

  struct Nearest {
    double distance_mm = 0;  ///< signed, realised at t; negative: the point is inside the tool then
    double t = 0;
    double lower_mm = 0;  ///< proven: at no instant is it less
  };

  /// The smallest signed distance over the motion, to `accuracy_mm` from above or as near as a
  /// few hundred instants bring it. Instants that cannot be at most `enough_mm` are not looked at.
  [[nodiscard]] Nearest nearest(const Vec3& point_part, double accuracy_mm, double enough_mm) const;

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const;
  /// Unit gradient of that distance.
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const;

  /// Holds every place the tool takes.
  [[nodiscard]] Box3 box() const;

 private:
  const Motion& motion_;
  const CompiledTool& tool_;
};

}  // namespace gouge
