#include "lib/verify/separation.h"

#include <algorithm>
#include <limits>

#include "lib/geom/point_triangle.h"

namespace gouge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Maximum gap between pieces of a contour. The path out of the tool must be shorter than the depth
// (docs/method/verify.md).
constexpr double kJoint_mm = 1e-9;
constexpr std::ptrdiff_t kMaxPoses = 5;

bool is_same(const PoseBounds& a, const PoseBounds& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!a.tip[k].is_same(b.tip[k]) || !a.axis[k].is_same(b.axis[k])) return false;
  return true;
}

double larger(double a, const Bounds& b) { return std::max(a, b.sup()); }

/// Returns half the extent of a node or a block along a direction.
Bounds half_extent(const SurfacePatch& patch, const Bounds3& direction) {
  Bounds half(0);
  for (std::size_t k = 0; k < 3; ++k)
    half += patch.shape == PatchShape::block
                ? CGAL::abs(dot(direction, Bounds3(patch.arms[k])))
                : CGAL::abs(direction[k]) * Bounds(patch.half[static_cast<Eigen::Index>(k)]);
  return half;
}

}  // namespace

SurfacePatch triangle_patch(const std::array<Vec3, 3>& corners) {
  SurfacePatch patch;
  patch.corners = corners;
  patch.center = (corners[0] + corners[1] + corners[2]) / 3.0;
  for (const Vec3& p : corners) patch.radius_mm = larger(patch.radius_mm, length(Bounds3(p) - Bounds3(patch.center)));
  patch.into = -(corners[1] - corners[0]).cross(corners[2] - corners[0]);
  return patch;
}

SurfacePatch node_patch(const TriangleOrder& order, const TriangleOrder::Node& node) {
  const TriangleOrder::Extent& extent = order.extent(node);
  SurfacePatch patch;
  patch.shape = PatchShape::node;
  patch.center = extent.center;
  patch.half = extent.half;
  patch.into = extent.into;
  patch.least = extent.least;
  patch.radius_mm = length(Bounds3(extent.half)).sup();
  return patch;
}

TimeSpan span_of(const MotionPiece* first, const MotionPiece* last) {
  TimeSpan span;
  for (const MotionPiece* piece = first; piece != last; ++piece) {
    if (span.poses.empty() || !is_same(span.poses.back(), piece->start())) span.poses.push_back(piece->start());
    if (!is_same(span.poses.back(), piece->end())) span.poses.push_back(piece->end());
    span.sag_mm = std::max(span.sag_mm, piece->sag_mm());
    span.bend = std::max(span.bend, piece->bend());
    span.twist_mm = larger(span.twist_mm, length(piece->end().tip - piece->start().tip) *
                                              length(piece->end().axis - piece->start().axis) / Bounds(4));
  }
  const PoseBounds& begin = span.poses.front();
  const PoseBounds middle = last - first == 1 ? PoseBounds{Bounds(0.5) * (begin.tip + span.poses.back().tip),
                                                           begin.axis + span.poses.back().axis}
                                              : (first + (last - first) / 2)->start();
  span.middle = middle.middle();
  if (last - first > kMaxPoses - 1) {
    PoseBounds all = begin;
    for (const PoseBounds& pose : span.poses) all = {hull(all.tip, pose.tip), hull(all.axis, pose.axis)};
    span.poses = {{widened(all.tip, span.sag_mm), widened(all.axis, span.bend)}};
    span.sag_mm = span.bend = span.twist_mm = 0;
  }
  for (const PoseBounds& pose : span.poses) {
    if (&pose == &span.poses.front()) continue;
    span.path_mm = larger(span.path_mm, length(pose.tip - span.poses.front().tip));
    span.swing = larger(span.swing, length(pose.axis - span.poses.front().axis));
  }
  span.path_mm = (Bounds(span.path_mm) + Bounds(span.sag_mm)).sup();
  span.swing = (Bounds(span.swing) + Bounds(span.bend)).sup();
  return span;
}

// The height above the tip is a product of two functions that are linear along the chords. The margin has its deviation
// between the end values (the twist), and the effects of sag and bend.
PatchHeights heights_of(const SurfacePatch& patch, const TimeSpan& span) {
  PatchHeights heights{kInfinity, -kInfinity, 0};
  const auto take = [&](const Bounds& z) {
    heights.low_mm = std::min(heights.low_mm, z.inf());
    heights.high_mm = std::max(heights.high_mm, z.sup());
  };
  for (const PoseBounds& pose : span.poses) {
    if (patch.shape == PatchShape::triangle) {
      for (const Vec3& corner : patch.corners) {
        const Bounds3 u = Bounds3(corner) - pose.tip;
        take(dot(u, pose.axis));
        heights.reach_mm = larger(heights.reach_mm, length(u));
      }
      continue;
    }
    const Bounds3 u = Bounds3(patch.center) - pose.tip;
    const Bounds half = half_extent(patch, pose.axis);
    take(dot(u, pose.axis) + half);
    take(dot(u, pose.axis) - half);
    heights.reach_mm = larger(heights.reach_mm, length(u) + Bounds(patch.radius_mm));
  }
  const Bounds reach(heights.reach_mm), sag(span.sag_mm);
  const double margin = (Bounds(span.twist_mm) + sag + Bounds(span.bend) * (reach + sag)).sup();
  heights.low_mm = (Bounds(heights.low_mm) - Bounds(margin)).inf();
  heights.high_mm = (Bounds(heights.high_mm) + Bounds(margin)).sup();
  return heights;
}

void Separation::look_at(const SurfacePatch& patch, const TimeSpan& span) {
  patch_ = &patch;
  span_ = &span;
  is_clipped_ = false;
  r_hi_ = -1;
  const PatchHeights heights = heights_of(patch, span);
  z_lo_ = heights.low_mm;
  z_hi_ = heights.high_mm;
  reach_mm_ = heights.reach_mm;
}

// The distance from the axis is |u x a|, with a unit vector a; |u x a - u' x a'| <= |u - u'| + |u'| |a - a'|.
void Separation::bound_radii() {
  if (r_hi_ >= 0) return;
  const PoseBounds& pose = span_->poses.front();
  const Bounds r = length(cross(Bounds3(patch_->center) - pose.tip, pose.axis));
  const Bounds off = Bounds(patch_->radius_mm) + Bounds(span_->path_mm) + Bounds(reach_mm_) * Bounds(span_->swing);
  r_lo_ = std::max(0.0, (r - off).inf());
  r_hi_ = (r + off).sup();
}

void Separation::clip(bool is_ring) {
  if (is_clipped_ && is_clipped_ring_ == is_ring) return;
  is_clipped_ = true;
  is_clipped_ring_ = is_ring;
  reaches_.clear();
  const double lo = (Bounds(z_lo_) - Bounds(max_mm_)).inf(), hi = (Bounds(z_hi_) + Bounds(max_mm_)).sup();
  const double near = is_ring ? (Bounds(r_lo_) - Bounds(max_mm_)).inf() : -1;
  Bounds far2(0);
  for (const ToolContour::Piece& p : tool_.pieces()) {
    if (p.z_hi() < lo || p.z_lo() > hi || p.r_hi() < near) continue;
    const Bounds ar(p.a.x()), az(p.a.y()), dr = Bounds(p.b.x()) - ar, dz = Bounds(p.b.y()) - az;
    Reach reach;
    if (p.is_arc) {
      const auto radius_at = [&](double z) {
        const Bounds up = Bounds(z) - Bounds(p.center.y());
        const Bounds out = square_root(CGAL::square(Bounds(p.radius_mm)) - CGAL::square(up));
        const bool is_right = p.a.x() + p.b.x() >= 2 * p.center.x();
        return is_right ? Bounds(p.center.x()) + out : Bounds(p.center.x()) - out;
      };
      const double from = std::max(p.z_lo(), lo), to = std::min(p.z_hi(), hi);
      double widest = p.r_hi();
      if (from > p.z_lo() || to < p.z_hi()) widest = std::min(widest, larger(radius_at(from).sup(), radius_at(to)));
      reach = {Bounds(widest), Bounds(from), Bounds(widest), Bounds(to), &p};
    } else {
      double from = 0, to = 1;
      const auto cut = [&](const Bounds& start, const Bounds& slope, double least) {  // start + s slope >= least
        if (slope.inf() > 0) from = std::max(from, ((Bounds(least) - start) / slope).inf());
        if (slope.sup() < 0) to = std::min(to, ((Bounds(least) - start) / slope).sup());
      };
      cut(az, dz, lo);
      cut(-az, -dz, -hi);
      cut(ar, dr, near);
      if (from > to) continue;
      const Bounds s0(from), s1(to);
      reach = {ar + s0 * dr, az + s0 * dz, ar + s1 * dr, az + s1 * dz};
    }
    for (const auto& [r, z] : {std::pair(reach.r0, reach.z0), std::pair(reach.r1, reach.z1)}) {
      const Bounds square = CGAL::square(r) + CGAL::square(z);
      if (square.sup() > far2.sup()) far2 = square;
    }
    reaches_.push_back(reach);
  }
  longest_mm_ = square_root(far2).sup();
}

/// Returns a bound of out r + up z over the pieces; out >= 0.
Bounds Separation::support(const Bounds& out, const Bounds& up) const {
  double top = -kInfinity;
  for (const Reach& reach : reaches_) {
    double here = std::max((reach.r0 * out + reach.z0 * up).sup(), (reach.r1 * out + reach.z1 * up).sup());
    if (reach.arc != nullptr) {
      const ToolContour::Piece& p = *reach.arc;
      const auto along = [&](const Vec2& q) { return Bounds(q.x()) * out + Bounds(q.y()) * up; };
      const auto left = [&](const Vec2& end) {  // cross(end - center, (out, up))
        return (Bounds(end.x()) - Bounds(p.center.x())) * up - (Bounds(end.y()) - Bounds(p.center.y())) * out;
      };
      const double side = p.is_hollow ? -1 : 1;
      const bool is_beside = (Bounds(side) * left(p.a)).sup() < 0 || (Bounds(side) * left(p.b)).inf() > 0;
      const Bounds round = is_beside ? Bounds(std::max(along(p.a).sup(), along(p.b).sup()))
                                     : along(p.center) + Bounds(p.radius_mm) * square_root(out * out + up * up);
      here = std::min(here, round.sup());
    }
    top = std::max(top, here);
  }
  return Bounds(top);
}

bool Separation::is_separated_by(const Vec3& n, double depth_mm, bool is_ring) {
  if (!(n.squaredNorm() > 0)) return false;
  if (is_ring) bound_radii();
  clip(is_ring);
  if (reaches_.empty()) return true;
  const Bounds3 across(n);
  const Bounds size = length(across);
  double least = kInfinity, most = -kInfinity;
  if (patch_->shape == PatchShape::triangle) {
    for (const Vec3& corner : patch_->corners) {
      const Bounds at = dot(across, Bounds3(corner));
      least = std::min(least, at.inf());
      most = std::max(most, at.sup());
    }
  } else {
    const Bounds half = half_extent(*patch_, across);
    const Bounds at = dot(across, Bounds3(patch_->center));
    least = (at - half).inf();
    most = (at + half).sup();
    if (patch_->shape == PatchShape::node && (n - patch_->into).isZero(0)) least = std::max(least, patch_->least);
  }
  double top = -kInfinity, lowest = kInfinity, vague = 0;
  for (const PoseBounds& pose : span_->poses) {
    const Bounds tip = dot(across, pose.tip);
    const Bounds here = tip + support(length(cross(across, pose.axis)), dot(across, pose.axis));
    top = std::max(top, here.sup());
    lowest = std::min(lowest, here.sup());
    vague = std::max(
        vague, (tip.sup() - tip.inf()) + longest_mm_ * (pose.axis[0].sup() - pose.axis[0].inf() + pose.axis[1].sup() -
                                                        pose.axis[1].inf() + pose.axis[2].sup() - pose.axis[2].inf()));
  }
  const Bounds drift = size * (Bounds(span_->sag_mm) + Bounds(span_->bend) * Bounds(longest_mm_) + Bounds(kJoint_mm));
  patch_loss_ = (most - least) / size.inf();
  time_loss_ = (top - lowest + vague + drift.sup()) / size.inf();
  return (Bounds(least) + Bounds(depth_mm) * size - Bounds(top) - drift).inf() >= 0;
}

/// Returns the direction of the shortest path out of the tool; for a point outside, the direction away from the tool.
/// It uses the middle of the span. Plain doubles are sufficient, because any plane is valid.
Vec3 Separation::away_from(const Vec3& point) const {
  const Pose& pose = span_->middle;
  const Vec3 u = point - pose.tip;
  const double z = u.dot(pose.axis);
  const Vec3 across = u - z * pose.axis;
  const double r = across.norm();
  const Vec3 out = r > 0 ? Vec3(across / r) : pose.axis.unitOrthogonal();
  const Vec2 normal = tool_.nearest({r, z}).normal;
  return normal.x() * out + normal.y() * pose.axis;
}

Vec3 Separation::direction(ProofKind kind) {
  if (kind == ProofKind::own_plane || kind == ProofKind::own_ring)
    return patch_->into.dot(away_from(patch_->center)) < 0 ? Vec3(-patch_->into) : patch_->into;
  if (kind == ProofKind::center_plane || kind == ProofKind::center_ring) return away_from(patch_->center);
  constexpr int kRounds = 5;
  Vec3 point = patch_->center;
  for (int k = 0; k < kRounds; ++k) {
    const Pose& pose = span_->middle;
    const Vec3 u = point - pose.tip;
    const double z = u.dot(pose.axis);
    const Vec3 across = u - z * pose.axis;
    const double r = across.norm();
    const Vec3 out = r > 0 ? Vec3(across / r) : pose.axis.unitOrthogonal();
    const Vec2 foot = tool_.nearest({r, z}).foot;
    point = closest_on_triangle(pose.tip + foot.x() * out + foot.y() * pose.axis, patch_->corners).point;
  }
  return away_from(point);
}

bool Separation::is_near_exit_point(double depth_mm) {
  bound_radii();
  const Pose& pose = span_->middle;
  const Vec3 u = patch_->center - pose.tip;
  const double z = u.dot(pose.axis);
  const Vec2 way_out = tool_.nearest({(u - z * pose.axis).norm(), z}).foot;
  double far = 0;
  for (const double r : {r_lo_, r_hi_})
    for (const double at : {z_lo_, z_hi_})
      far = larger(far, square_root(CGAL::square(Bounds(r) - Bounds(way_out.x())) +
                                    CGAL::square(Bounds(at) - Bounds(way_out.y()))));
  return (Bounds(depth_mm) - Bounds(far) - Bounds(kJoint_mm)).inf() >= 0;
}

bool Separation::holds(ProofKind kind, double depth_mm) {
  if (kind == ProofKind::exit_point) return is_near_exit_point(depth_mm);
  if (patch_->shape != PatchShape::triangle && (kind == ProofKind::closest_plane || kind == ProofKind::closest_ring))
    return false;
  return is_separated_by(direction(kind), depth_mm, kind >= ProofKind::own_ring);
}

}  // namespace gouge
