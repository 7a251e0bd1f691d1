#pragma once

#include <cmath>

#include "lib/check/motion.h"

namespace gouge {

/// A solid along one motion, asked from a point of the part.
class SweptSolid {
 public:
  /// Requires motion.is_defined(); it must outlive the solid.
  explicit SweptSolid(const Motion& motion) : motion_(motion) {}
  virtual ~SweptSolid() = default;
  SweptSolid(const SweptSolid&) = delete;
  SweptSolid& operator=(const SweptSolid&) = delete;

  /// Signed, 1-Lipschitz in the point; negative inside.
  [[nodiscard]] virtual double distance_at(const Vec3& point_part, double t) const = 0;
  /// Unit gradient of that distance.
  [[nodiscard]] virtual Vec3 outward_at(const Vec3& point_part, double t) const = 0;

  struct Nearest {
    double distance_mm = 0;  ///< signed, realised at t; negative: the point is inside then
    double t = 0;
    double lower_mm = 0;  ///< proven: at no instant is it less
  };

  /// The smallest signed distance over the motion, to `accuracy_mm` from above or as near as a
  /// few hundred instants bring it. Instants that cannot be at most `enough_mm` are not looked at.
  [[nodiscard]] Nearest nearest(const Vec3& point_part, double accuracy_mm, double enough_mm) const;

  /// Holds every point the solid takes.
  [[nodiscard]] Box3 box() const;

 protected:
  /// No point of the solid is farther from the tip.
  [[nodiscard]] virtual double reach_mm() const = 0;
  /// How far it turns over the whole motion, about all axes together.
  [[nodiscard]] virtual double turn_rad() const { return std::abs(motion_.angle_rad()); }
  [[nodiscard]] const Motion& motion() const { return motion_; }

 private:
  const Motion& motion_;
};

}  // namespace gouge
