#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/head/head_body.h"
#include "lib/motion/body_motion.h"
#include "lib/motion/motion.h"
#include "lib/motion/motion_interval.h"
#include "lib/surface/surface.h"

namespace gouge {

/// The points x with normal . (x - centre) <= offset + s drift, at the instant that corresponds to s in [-1/2, 1/2] in
/// the interval. The centre and the interval are those of the queried cell.
struct DriftingHalfSpace {
  Vec3 normal = Vec3::Zero();
  double offset_mm = 0, drift_mm = 0;
};

/// Returns the half-space behind a plane of the solid itself, over a time interval. `n0` and `n1` are its normals at
/// both ends, in the part's directions. The cell's centre is `depth_mm` behind it in the middle of its chord, and
/// `drift_mm` more at the end than at the start. The half-space uses the mean of both normals, and adds half their
/// difference at the cell's rim.
[[nodiscard]] inline DriftingHalfSpace behind_plane(const Vec3& n0, const Vec3& n1, double depth_mm, double drift_mm,
                                                    double bulge_mm, double radius_mm) {
  constexpr double kRounding_mm = Tolerance::kRounding_mm;
  return {0.5 * (n0 + n1), depth_mm + bulge_mm + 0.5 * (n1 - n0).norm() * radius_mm + kRounding_mm, drift_mm};
}

/// Bounds on the part of a moving solid that enters a cell during a time interval.
struct SweptBound {
  bool is_reached = false;                ///< false: it is proved that no part does
  bool is_rounded = false;                ///< all of the solid in the cell is outside of its sharp zones
  bool can_halve = false;                 ///< the interval can be halved
  std::optional<DriftingHalfSpace> half;  ///< contains all of the solid that enters the cell
  double distance_mm = 0;                 ///< approximate signed distance of the cell's centre at ...
  double t = 0;                           ///< ... this instant, the best examined one
  double path_length_mm = 0;              ///< approximate length of the centre's path in the solid's frame
};

/// A solid during one motion, queried for points of the part.
class SweptSolid {
 public:
  /// Prepares the solid. Requires motion.is_defined(). The motion must outlive the solid.
  explicit SweptSolid(const Motion& motion) : motion_(motion) {}
  virtual ~SweptSolid() = default;
  SweptSolid(const SweptSolid&) = delete;
  SweptSolid& operator=(const SweptSolid&) = delete;

  /// Returns the signed distance, negative inside. It is 1-Lipschitz in the point.
  [[nodiscard]] virtual double distance_at(const Vec3& point_part, double t) const = 0;
  /// Returns the unit gradient of that distance.
  [[nodiscard]] virtual Vec3 outward_at(const Vec3& point_part, double t) const = 0;

  /// Returns the number of segments of the motion. They are the first of the numbered time intervals.
  [[nodiscard]] virtual std::uint32_t segments() const = 0;
  /// Halves an interval and returns the number of its first half; the second half has the next number.
  virtual std::uint32_t halve(std::uint32_t interval) = 0;
  /// Bounds the solid in the ball about `centre`.
  [[nodiscard]] virtual SweptBound bound(const Vec3& centre, double radius_mm, std::uint32_t interval) const = 0;
  /// Returns a half-space as in `bound`. Its plane touches the solid near a point of the ball at the instant of s.
  [[nodiscard]] virtual std::optional<DriftingHalfSpace> half_space(const Vec3& point, double s, const Vec3& centre,
                                                                    double radius_mm, std::uint32_t interval) const = 0;

  /// Returns boxes that contain all points of the solid during an interval, along three orthogonal unit vectors (rows
  /// of `frame`). With `is_sharp_only` there is one box for each of its sharp zones.
  [[nodiscard]] virtual std::vector<Box3> extents(const Eigen::Matrix3d& frame, std::uint32_t interval,
                                                  bool is_sharp_only) const = 0;
  /// Returns smaller boxes along the same axes that together contain the content of a sharp zone's box. Zones are
  /// counted as in `extents`.
  [[nodiscard]] virtual std::vector<Box3> pieces(const Eigen::Matrix3d& /*frame*/, std::uint32_t /*interval*/,
                                                 std::size_t /*zone*/) const {
    return {};
  }

  /// Returns a bound of the distance below the surface for every point outside of the solid's sharp zones.
  [[nodiscard]] virtual double rounded_bound_mm() const { return std::numeric_limits<double>::infinity(); }
  /// Returns a box for each segment, along the same axes. It contains all points of the solid that are outside of its
  /// sharp zones and more than `depth_mm` below the surface of `part`, at any instant of the segment.
  /// Requires a finite rounded_bound_mm().
  [[nodiscard]] virtual std::vector<Box3> deep_extents(const Eigen::Matrix3d& /*frame*/, const Surface& /*part*/,
                                                       double /*depth_mm*/) const {
    return {};
  }

  [[nodiscard]] const Motion& motion() const { return motion_; }

 private:
  const Motion& motion_;
};

/// A body that is fixed to the tool axis, during one motion. Not for several threads at once.
class SweptHead : public SweptSolid {
 public:
  /// Prepares the body. `head` must outlive it.
  SweptHead(const Motion& motion, const HeadBody& head);

  [[nodiscard]] double distance_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] Vec3 outward_at(const Vec3& point_part, double t) const override;
  [[nodiscard]] std::uint32_t segments() const override { return intervals_.segments(); }
  std::uint32_t halve(std::uint32_t interval) override { return intervals_.halve(interval); }
  [[nodiscard]] SweptBound bound(const Vec3& centre, double radius_mm, std::uint32_t interval) const override;
  /// Returns none if the head's surface over the cell is steep, or if the head continues above it.
  [[nodiscard]] std::optional<DriftingHalfSpace> half_space(const Vec3& point, double s, const Vec3& centre,
                                                            double radius_mm, std::uint32_t interval) const override;
  [[nodiscard]] std::vector<Box3> extents(const Eigen::Matrix3d& frame, std::uint32_t interval,
                                          bool is_sharp_only) const override;

 private:
  struct LastFoot {
    Vec3 of = Vec3::Zero();
    ClosestPoint foot;
  };

  [[nodiscard]] const ClosestPoint& closest_to(const Vec3& q) const;
  [[nodiscard]] std::optional<OuterPlane> plane_at(const ClosestPoint& foot) const;
  [[nodiscard]] std::optional<DriftingHalfSpace> half_space_at(const ClosestPoint& foot, const Vec3& centre,
                                                               double radius_mm, const BodyInterval& interval) const;

  const HeadBody& head_;
  BodyMotion moving_;
  IntervalTree<BodyInterval, BodyMotion> intervals_;
  Box3 box_;                              // in the tool's frame
  mutable std::optional<LastFoot> last_;  // saves time only; no result depends on it
};

}  // namespace gouge
