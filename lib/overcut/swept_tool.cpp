#include "lib/overcut/swept_tool.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/check/support_plane.h"
#include "lib/overcut/deep_surface.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kAngleRounding = 1e-7;  // rounding of an arc sine near a pole
constexpr double kMinAcross = 0.1;
constexpr double kSmallPiece = 0.5;  // share of the rounded bound: size of the pieces whose box is enlarged by it
constexpr int kArcs = 24;            // number of arcs into which a sharp edge is divided; each is searched separately

/// Returns the smallest distance of a stretch from the tool axis.
double smallest_radius(const Vec3& a, const Vec3& b) {
  const Vec2 from = a.head<2>(), side = b.head<2>() - from;
  const double length2 = side.squaredNorm();
  const double share = length2 > 0 ? std::clamp(-from.dot(side) / length2, 0.0, 1.0) : 0.0;
  return (from + share * side).norm();
}

/// The chord of a cell's centre during an interval, in tool coordinates.
struct Chord {
  Vec3 q0, q1;
  double bulge_mm = 0, radius_mm = 0;

  Chord(const ToolInterval& interval, const Vec3& centre, double radius)
      : q0(interval.f0.to_tool(centre)), q1(interval.f1.to_tool(centre)), radius_mm(radius) {
    if (interval.t1 > interval.t0) bulge_mm = interval.rates.bulge_mm((centre - interval.tip_middle).norm() + radius);
  }
};

/// The hull of the tool's points at some heights. The points lie in and between the rings that discs of the half plane
/// make about the axis. Its support in a direction n is the largest r n_r + z n_z + radius of a few discs.
class Hull {
 public:
  /// Bounds the points at heights [z_lo, z_hi] that are at least r_lo from the axis. Directions have an angle in [low,
  /// high] to the r axis of the (r, z) plane.
  Hull(const CompiledTool& tool, double z_lo, double z_hi, double r_lo, double low, double high)
      : z_lo_(z_lo), z_hi_(z_hi), r_lo_(r_lo), min_across_(std::max(0.0, std::min(std::cos(low), std::cos(high)))) {
    for (const BoundaryElement& e : tool.elements) {
      const double bottom = std::min(e.a.y(), e.b.y()), top = std::max(e.a.y(), e.b.y());
      if (e.kind == ElementKind::arc) {
        if (top >= z_lo - e.radius_mm && bottom <= z_hi + e.radius_mm && e.center.x() + e.radius_mm >= r_lo)
          add_arc(e, low, high);
      } else if (e.kind == ElementKind::segment) {
        add_segment(e);
      }
    }
  }

  [[nodiscard]] bool is_empty() const { return discs_.empty(); }
  /// Returns the support. `along` is the direction's component along the axis.
  [[nodiscard]] double support_mm(double along) const {
    const double across = std::sqrt(std::max(0.0, 1 - along * along));
    double most = -std::numeric_limits<double>::infinity();
    for (const Disc& disc : discs_)
      most = std::max(most, disc.center.x() * across + disc.center.y() * along + disc.radius_mm);
    return most;
  }
  /// Returns the maximum by which the support exceeds its linear interpolation in time between two instants, divided by
  /// the square of the turn.
  [[nodiscard]] double bulge_mm() const {
    double most = 0;
    for (const Disc& disc : discs_) {
      const double r = disc.center.x();
      most = std::max(most, std::abs(disc.center.y()) + (r < 0 ? -r * (1 + 1 / min_across_) : r));
    }
    return most / 8;
  }

 private:
  struct Disc {
    Vec2 center;
    double radius_mm;
  };
  void add(const Vec2& center, double radius) { discs_.push_back({center, radius}); }

  void add_segment(const BoundaryElement& e) {
    const Vec2 side = e.b - e.a;
    double from = 0, to = 1;  // shares of the segment
    const auto keep_above = [&](double start, double slope, double least) {
      if (slope > 0) from = std::max(from, (least - start) / slope);
      if (slope < 0) to = std::min(to, (least - start) / slope);
      if (!(slope < 0 || slope > 0) && start < least) to = -1;
    };
    keep_above(e.a.y(), side.y(), z_lo_);
    keep_above(-e.a.y(), -side.y(), -z_hi_);
    keep_above(e.a.x(), side.x(), r_lo_);
    if (from > to) return;
    add(from > 0 ? Vec2(e.a + from * side) : e.a, 0);
    add(to < 1 ? Vec2(e.a + to * side) : e.b, 0);
  }

  /// Adds an arc. If it faces outwards, its disc replaces it only for the directions of its own normals at these
  /// heights.
  void add_arc(const BoundaryElement& e, double low, double high) {
    const Vec2 from = e.a - e.center, to = e.b - e.center;
    const bool is_steep = e.center.x() < 0 && min_across_ < kMinAcross;
    if (e.is_reflex || is_steep) {
      const double out = e.is_reflex ? 0 : e.radius_mm - (0.5 * (from + to)).norm() + Tolerance::kRounding_mm;
      add(e.a, out);
      add(e.b, out);
      // If the arc turns back over itself, the part that faces outwards ends inside the arc.
      if (e.is_reflex && std::max(from.x(), to.x()) > kAngleRounding * e.radius_mm) {
        add(e.center + Vec2(0, e.radius_mm), 0);
        add(e.center - Vec2(0, e.radius_mm), 0);
      }
      return;
    }
    const double rounding = kAngleRounding;
    if (std::min(from.x(), to.x()) < -rounding * e.radius_mm) return add(e.center, e.radius_mm);
    const auto angle = [&](double height) { return std::asin(std::clamp(height / e.radius_mm, -1.0, 1.0)); };
    const double a = std::max(angle(std::min(from.y(), to.y())), angle(z_lo_ - e.center.y()));
    const double b = std::min(angle(std::max(from.y(), to.y())), angle(z_hi_ - e.center.y()));
    if (a > b) return;
    if (high < a - rounding)
      return add(e.center + e.radius_mm * Vec2(std::cos(a), std::sin(a)), rounding * e.radius_mm);
    if (low > b + rounding) return add(e.center + e.radius_mm * Vec2(std::cos(b), std::sin(b)), rounding * e.radius_mm);
    add(e.center, e.radius_mm);
  }

  std::vector<Disc> discs_;
  double z_lo_, z_hi_, r_lo_, min_across_;
};

/// Returns a half-space that contains the part of the tool inside the cell. Its plane has a fixed direction in the
/// part. The reach of the tool along it changes nearly linearly with the instant. Proof: docs/method/overcut.md,
/// section 4.
DriftingHalfSpace behind(const CompiledTool& tool, const Vec3& direction, const Vec3& centre, const Chord& chord,
                         const ToolInterval& interval) {
  const double around = chord.radius_mm + chord.bulge_mm + Tolerance::kRounding_mm;
  const double z_lo = std::min(chord.q0.z(), chord.q1.z()) - around;
  const double z_hi = std::max(chord.q0.z(), chord.q1.z()) + around;
  const double along0 = direction.dot(interval.f0.rows.row(2)), along1 = direction.dot(interval.f1.rows.row(2));
  const auto angle = [](double along) { return std::asin(std::clamp(along, -1.0, 1.0)); };
  const double low = std::min(angle(along0), angle(along1)), high = std::max(angle(along0), angle(along1));
  const double r_lo = std::max(0.0, smallest_radius(chord.q0, chord.q1) - around);
  const Hull hull(tool, z_lo, z_hi, r_lo, low - interval.rates.turn_rad, high + interval.rates.turn_rad);
  if (hull.is_empty()) return {direction, -4 * around, 0};
  const double end0 = direction.dot(interval.f0.tip) + hull.support_mm(along0);
  const double end1 = direction.dot(interval.f1.tip) + hull.support_mm(along1);
  const double over = interval.rates.axis_acceleration_rad() * hull.bulge_mm() + interval.rates.tip_sag_mm;
  return {direction, 0.5 * (end0 + end1) - direction.dot(centre) + over + Tolerance::kRounding_mm, end1 - end0};
}

/// Returns a vector of tool coordinates in the part at the instant of s, approximately.
Vec3 in_part(const Vec3& tool_vector, double s, const ToolInterval& interval) {
  const Vec3 at0 = interval.f0.rows.transpose() * tool_vector, at1 = interval.f1.rows.transpose() * tool_vector;
  return ((0.5 - s) * at0 + (0.5 + s) * at1).normalized();
}

/// Finds a half-space that does not contain the place at the instant of s, if there is one. Its plane is square to the
/// direction of the nearest boundary. If that plane does not exclude the place, a plane parallel to the axis is tried.
DriftingHalfSpace beside(const CompiledTool& tool, const ToolSample& sample, const Vec3& place, double s,
                         const Vec3& centre, const Chord& chord, const ToolInterval& interval) {
  const auto behind_square_to = [&](const Vec3& direction) {
    return behind(tool, in_part(direction, s, interval), centre, chord, interval);
  };
  const auto room = [&](const DriftingHalfSpace& half) {
    return half.offset_mm + s * half.drift_mm - half.normal.dot(place - centre);
  };
  const DriftingHalfSpace half = behind_square_to(support_plane(tool, sample).normal);
  const Vec3 radial(sample.q.x(), sample.q.y(), 0);
  if (room(half) < 0 || sample.nearest.signed_distance_mm <= 0 || !(radial.norm() > Tolerance::kRounding_mm))
    return half;
  const DriftingHalfSpace other = behind_square_to(radial);
  return room(other) < room(half) ? other : half;
}

}  // namespace

double SweptTool::distance_at(const Vec3& point, double t) const {
  return signed_distance_mm(tool_, motion().at(t), point);
}

Vec3 SweptTool::outward_at(const Vec3& point, double t) const {
  const Pose pose = motion().at(t);
  const Vec3 d = point - pose.tip;
  const double z = d.dot(pose.axis);
  const Vec3 across = d - z * pose.axis;
  const double r = across.norm();
  const Vec2 normal = evaluate(tool_, r, z).normal;
  const Vec3 radial = r > 0 ? Vec3(across / r) : pose.axis.unitOrthogonal();
  return (normal.x() * radial + normal.y() * pose.axis).normalized();
}

SweptBound SweptTool::bound(const Vec3& centre, double radius, std::uint32_t index) const {
  const ToolInterval& interval = intervals_[index];
  const Chord chord(interval, centre, radius);
  const double length = (chord.q1 - chord.q0).norm();
  const ToolSample middle = sample_tool(tool_, 0.5 * (chord.q0 + chord.q1));
  SweptBound bound;
  bound.distance_mm = middle.nearest.signed_distance_mm;
  bound.t = interval.middle();
  bound.path_length_mm = length + 2 * chord.bulge_mm;
  bound.can_halve = intervals_.can_halve(index);
  if (bound.distance_mm - 0.5 * length - chord.bulge_mm > radius + Tolerance::kRounding_mm) return bound;
  bound.is_reached = true;
  if (rounded_) {
    const Vec2 q(middle.q.head<2>().norm(), middle.q.z());
    const double around = radius + 0.5 * length + chord.bulge_mm + Tolerance::kRounding_mm;
    bound.is_rounded =
        std::none_of(rounded_->sharp_zones->begin(), rounded_->sharp_zones->end(),
                     [&](const Box2& zone) { return zone.squaredExteriorDistance(q) <= around * around; });
  }
  bound.half = beside(tool_, middle, centre, 0, centre, chord, interval);
  return bound;
}

std::optional<DriftingHalfSpace> SweptTool::half_space(const Vec3& point, double s, const Vec3& centre, double radius,
                                                       std::uint32_t index) const {
  const ToolInterval& interval = intervals_[index];
  const Vec3 q = (0.5 - s) * interval.f0.to_tool(point) + (0.5 + s) * interval.f1.to_tool(point);
  return beside(tool_, sample_tool(tool_, q), point, s, centre, Chord(interval, centre, radius), interval);
}

std::vector<Box3> SweptTool::extents(const Eigen::Matrix3d& frame, std::uint32_t index, bool is_sharp_only) const {
  if (!is_sharp_only || !rounded_)
    return {extent(frame, index, Box2(Vec2(0, tool_.z_min_mm), Vec2(tool_.r_max_mm, tool_.z_max_mm)))};
  std::vector<Box3> boxes;
  for (const Box2& zone : *rounded_->sharp_zones) boxes.push_back(extent(frame, index, zone));
  return boxes;
}

std::vector<Box3> SweptTool::pieces(const Eigen::Matrix3d& frame, std::uint32_t index, std::size_t zone) const {
  std::vector<Box3> boxes;
  for (int k = 0; k < kArcs; ++k) boxes.push_back(extent_of_arc(frame, index, (*rounded_->sharp_zones)[zone], k));
  return boxes;
}

double SweptTool::rounded_bound_mm() const {
  return rounded_ ? rounded_->depth_mm + rounded_->slack_mm : SweptSolid::rounded_bound_mm();
}

std::vector<Box3> SweptTool::deep_extents(const Eigen::Matrix3d& frame, const Surface& part, double depth_mm) const {
  const double bound = rounded_bound_mm(), surface_depth = depth_mm - rounded_->slack_mm;
  std::vector<Box3> boxes =
      deep_surface(motion(), *rounded_->cover, part.tree(), frame, surface_depth, kSmallPiece * bound);
  for (Box3& box : boxes) {
    if (box.isEmpty()) continue;
    box.min().array() -= bound + Tolerance::kRounding_mm;
    box.max().array() += bound + Tolerance::kRounding_mm;
  }
  return boxes;
}

/// Bounds one of kArcs equal pieces of a sharp zone's ring.
Box3 SweptTool::extent_of_arc(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring, int piece) const {
  constexpr double kAngle = 2 * std::numbers::pi / kArcs;
  const ToolInterval& interval = intervals_[index];
  const double far = ring.max().x() + std::max(std::abs(ring.min().y()), std::abs(ring.max().y()));
  const double bulge = interval.t1 > interval.t0 ? interval.rates.bulge_mm(far) : 0;
  const double r_min = std::max(0.0, ring.min().x());
  Box3 box;
  for (const ToolFrame* at : {&interval.f0, &interval.f1}) {
    const Eigen::Matrix3d to_frame = frame * at->rows.transpose();
    const Vec3 tip = frame * at->tip;
    for (int end = 0; end < 2; ++end) {
      const double angle = (piece + end) * kAngle;
      const Vec3 radial = to_frame * Vec3(std::cos(angle), std::sin(angle), 0);
      for (const double r : {r_min, ring.max().x()}) {
        for (const double z : {ring.min().y(), ring.max().y()})
          box.extend(Vec3(tip + r * radial + z * to_frame.col(2)));
      }
    }
  }
  // Every point of the arc is within this distance of its chord.
  const double out = ring.max().x() * (1 - std::cos(0.5 * kAngle)) + bulge + Tolerance::kRounding_mm;
  return Box3(Vec3(box.min().array() - out), Vec3(box.max().array() + out));
}

/// Bounds the ring that a box of the half plane makes about the axis.
Box3 SweptTool::extent(const Eigen::Matrix3d& frame, std::uint32_t index, const Box2& ring) const {
  const ToolInterval& interval = intervals_[index];
  const double far = ring.max().x() + std::max(std::abs(ring.min().y()), std::abs(ring.max().y()));
  const double bulge = interval.t1 > interval.t0 ? interval.rates.bulge_mm(far) : 0;
  Box3 box;
  for (const ToolFrame* at : {&interval.f0, &interval.f1}) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 direction = frame.row(k);
      const double along = at->rows.row(2).dot(direction);
      const double across =
          ring.max().x() * std::sqrt(std::max(0.0, 1 - along * along)) + bulge + Tolerance::kRounding_mm;
      const double tip = at->tip.dot(direction);
      const double a = tip + along * ring.min().y(), b = tip + along * ring.max().y();
      box.min()[k] = std::min(box.min()[k], std::min(a, b) - across);
      box.max()[k] = std::max(box.max()[k], std::max(a, b) + across);
    }
  }
  return box;
}

}  // namespace gouge
