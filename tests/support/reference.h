#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <queue>
#include <vector>

#include "lib/check/scene.h"
#include "lib/geom/pose.h"
#include "lib/path/toolpath.h"
#include "lib/tool/compiled_tool.h"
#include "tests/support/reference_contour.h"

// Depths computed by other means than those of the check. The pose follows from the meaning of a move, and the tool's
// distance only from its contour. The surface is sampled at many instants, with a bound of the change of a distance
// between them. The check and this file share no formula, no tree and no planes. Header only.

namespace gouge::reference {

/// Returns the pose of a straight move at t: the tip moves linearly, and the axis turns on the great circle at constant
/// rate.
inline Pose pose_at(const Pose& from, const Pose& to, double t) {
  Pose pose;
  pose.tip = (1 - t) * from.tip + t * to.tip;
  const double angle = 2 * std::atan2((to.axis - from.axis).norm(), (to.axis + from.axis).norm());
  const double sine = std::sin(angle);
  pose.axis = angle < 1e-9 ? Vec3((1 - t) * from.axis + t * to.axis)
                           : Vec3((std::sin((1 - t) * angle) * from.axis + std::sin(t * angle) * to.axis) / sine);
  pose.axis.normalize();
  return pose;
}

/// A head with two rotary axes that run at constant rates. C turns about z, the shorter way round. A turns about the x
/// axis as turned by C.
class Rotaries {
 public:
  Rotaries(const Vec3& from, const Vec3& to)
      : c0_(std::atan2(from.x(), -from.y())), a0_(std::acos(std::clamp(from.z(), -1.0, 1.0))) {
    const double c1 = std::atan2(to.x(), -to.y());
    dc_ = c1 - c0_;
    while (dc_ > std::numbers::pi) dc_ -= 2 * std::numbers::pi;
    while (dc_ < -std::numbers::pi) dc_ += 2 * std::numbers::pi;
    // For an upright axis C may have any angle, so it is that of the other end.
    if (std::hypot(from.x(), from.y()) < 1e-12) c0_ = c1;
    if (std::min(std::hypot(from.x(), from.y()), std::hypot(to.x(), to.y())) < 1e-12) dc_ = 0;
    da_ = std::acos(std::clamp(to.z(), -1.0, 1.0)) - a0_;
  }
  [[nodiscard]] Vec3 axis(double t) const {
    const double c = c0_ + t * dc_, a = a0_ + t * da_;
    return {std::sin(c) * std::sin(a), -std::cos(c) * std::sin(a), std::cos(a)};
  }
  [[nodiscard]] Eigen::Quaterniond turn(double t) const {
    return Eigen::Quaterniond(Eigen::AngleAxisd(c0_ + t * dc_, Vec3(0, 0, 1))) *
           Eigen::Quaterniond(Eigen::AngleAxisd(a0_ + t * da_, Vec3(1, 0, 0)));
  }
  [[nodiscard]] double turn_rad() const { return std::abs(dc_) + std::abs(da_); }

 private:
  double c0_, a0_, dc_ = 0, da_ = 0;
};

/// The frame of the tool by a machine: origin at the tip, z along the axis. Lower bounds of its turn and of the length of
/// its tip's path.
struct MachineFrames {
  std::function<RigidTransform(double)> frame;
  double turn_rad = 0, length_mm = 0;
};

/// A move by its meaning: straight, or along the arc or spline to which it points.
struct Movement {
  Pose from, to;
  const PathArc* arc = nullptr;
  const PathSpline* spline = nullptr;
  std::optional<Rotaries> rotaries;  ///< set if the axis does not turn on the great circle
  std::optional<std::array<Eigen::Matrix3d, 2>> ends =
      {};                                    ///< directions of the tool at both ends, as joints state them
  std::optional<MachineFrames> frames = {};  ///< set if a machine moves the tool, in place of both

  /// Returns an upper bound of the angle by which the tool turns.
  [[nodiscard]] double turn_rad() const {
    if (frames) return frames->turn_rad;
    if (rotaries) return rotaries->turn_rad();
    return 2 * std::atan2((to.axis - from.axis).norm(), (to.axis + from.axis).norm());
  }

  [[nodiscard]] Pose at(double t) const {
    Pose pose = pose_at(from, to, t);
    if (rotaries) pose.axis = rotaries->axis(t);
    if (frames) {
      const RigidTransform frame = frames->frame(t);
      pose = {frame.shift, frame.rotation.col(2)};
    }
    if (arc != nullptr) pose.tip = on_arc(t) + t * (to.tip - on_arc(1));
    if (spline != nullptr) pose.tip = on_spline(t);
    return pose;
  }

  /// Returns an upper bound of the length of the tip's path.
  [[nodiscard]] double length() const {
    if (arc != nullptr) {
      const Vec3 a = from.tip - arc->center, b = to.tip - arc->center;
      return std::abs(arc->sweep_rad) * std::max(a.norm(), b.norm()) + 2 * (to.tip - on_arc(1)).norm() +
             std::abs(arc->axis.dot(b - a)) + std::abs(a.norm() - b.norm());
    }
    double length = frames ? frames->length_mm : (to.tip - from.tip).norm();
    if (spline == nullptr) return length;
    for (const SplinePiece& piece : spline->pieces) {
      for (std::size_t k = 0; k < 3; ++k)
        length = std::max(length, 3 * (piece.control[k + 1] - piece.control[k]).norm() / (piece.u1 - piece.u0));
    }
    return length;
  }

 private:
  // Returns the tip on an arc, turned by a quaternion. Distance from the axis and height along it change at constant
  // rates.
  [[nodiscard]] Vec3 on_arc(double t) const {
    const Vec3 a = from.tip - arc->center, b = to.tip - arc->center;
    const double h0 = a.dot(arc->axis), h1 = b.dot(arc->axis);
    const Vec3 out = a - h0 * arc->axis;
    const double r0 = out.norm(), r1 = (b - h1 * arc->axis).norm();
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(t * arc->sweep_rad, arc->axis));
    return arc->center + (h0 + t * (h1 - h0)) * arc->axis + (1 + t * (r1 - r0) / r0) * (turn * out);
  }

  // Returns the tip on a spline, by repeated linear interpolation (de Casteljau).
  [[nodiscard]] Vec3 on_spline(double t) const {
    std::size_t k = 0;
    while (k + 1 < spline->pieces.size() && t > spline->pieces[k].u1) ++k;
    const SplinePiece& piece = spline->pieces[k];
    const double u = (t - piece.u0) / (piece.u1 - piece.u0);
    std::array<Vec3, 4> p = piece.control;
    for (std::size_t left = 3; left > 0; --left) {
      for (std::size_t i = 0; i < left; ++i) p[i] = (1 - u) * p[i] + u * p[i + 1];
    }
    return p[0];
  }
};

/// Returns the movement of a path's move; a move without a start rests at its end.
inline Movement movement(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  Movement m{move.has_start ? path.start_of(index) : move.end, move.end, nullptr, nullptr, std::nullopt};
  if (move.has_start && move.curve_kind == CurveKind::arc) m.arc = &path.arcs[move.curve];
  if (move.has_start && move.curve_kind == CurveKind::spline) m.spline = &path.splines[move.curve];
  return m;
}

inline double distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double s = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (a + s * (b - a) - p).norm();
}

inline double distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const auto is_left = [&](const Vec3& u, const Vec3& v) { return (v - u).cross(p - u).dot(normal) >= 0; };
  if (is_left(a, b) && is_left(b, c) && is_left(c, a)) return std::abs((p - a).dot(normal));
  return std::min({distance_to_edge(p, a, b), distance_to_edge(p, b, c), distance_to_edge(p, c, a)});
}

struct Found {
  double depth_mm = 0;
  double t = 0;
  Vec3 point = Vec3::Zero();
};

struct Effort {
  int steps = 64;              ///< evenly spread instants, both ends included
  double accuracy_mm = 0.003;  ///< depths below the mark plus this are not refined
  int looks = 700;             ///< maximum number of points for an instant; those with the largest bound come first
};

/// A search for the deepest point in a move; its result is a lower bound of the true depth.
class Search {
 public:
  Search(const Contour& tool, const Movement& movement, const std::vector<IndexedMesh>& meshes, const Effort& effort)
      : tool_(tool), movement_(movement), from_(movement.from), to_(movement.to), effort_(effort) {
    if (tool.is_empty()) return;
    turn_ = 2 * std::atan2((to_.axis - from_.axis).norm(), (to_.axis + from_.axis).norm());
    length_ = movement.length();
    const Box3 reach = swept_box();
    for (const IndexedMesh& mesh : meshes) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        add({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}, reach);
    }
  }

  /// Runs the search. A point no deeper than `mark_mm` is used only as a starting point of a climb.
  Found run(double mark_mm) {
    mark_ = mark_mm;
    std::vector<std::size_t> all(pieces_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    best_of_.assign(static_cast<std::size_t>(effort_.steps) + 1, Place{});
    narrow(0, effort_.steps, all);
    std::sort(best_of_.begin(), best_of_.end(), [](const Place& a, const Place& b) { return a.depth > b.depth; });
    Found best;
    for (std::size_t k = 0; k < std::min<std::size_t>(3, best_of_.size()); ++k) {
      if (!(best_of_[k].depth > -1)) continue;
      const Place top = climb(best_of_[k]);
      if (top.depth > best.depth_mm) best = {top.depth, top.t, point(top)};
    }
    return best;
  }

 private:
  using Triangle = std::array<Vec3, 3>;
  struct Piece {
    Triangle corners;
    Vec3 middle;
    double radius = 0;
  };
  struct Place {
    double depth = -1e300;
    double t = 0;
    std::size_t piece = 0;
    double u = 0, v = 0;  ///< point = a + u (b - a) + v (c - a)
  };
  struct Cut {
    double bound = 0;
    std::size_t piece = 0;
    std::array<Vec2, 3> uv;
    bool operator<(const Cut& other) const { return bound < other.bound; }
  };

  [[nodiscard]] Box3 swept_box() const {
    Box3 box;
    for (const Pose& pose : {from_, to_}) {
      box.extend(pose.tip);
      box.extend(Vec3(pose.tip + tool_.top_mm() * pose.axis));
    }
    // Between two instants the axis leaves the hull of its two positions by at most the height of the arc.
    const bool is_straight = movement_.arc == nullptr && movement_.spline == nullptr;
    const double more = tool_.widest_mm() + tool_.top_mm() * (1 - std::cos(turn_ / 2)) + (is_straight ? 0 : length_);
    return Box3(box.min() - Vec3::Constant(more), box.max() + Vec3::Constant(more));
  }

  void add(const Triangle& t, const Box3& reach) {
    Box3 box(t[0]);
    box.extend(t[1]);
    box.extend(t[2]);
    if (!box.intersects(reach)) return;
    Piece piece{t, (t[0] + t[1] + t[2]) / 3.0, 0};
    for (const Vec3& c : t) piece.radius = std::max(piece.radius, (c - piece.middle).norm());
    pieces_.push_back(piece);
  }

  // Returns an upper bound of the motion of a point relative to the tool, between two instants `share` of the move
  // apart.
  [[nodiscard]] double travel(const Vec3& p, double share) const {
    const bool is_straight = movement_.arc == nullptr && movement_.spline == nullptr;
    const double far = std::max((p - from_.tip).norm(), (p - to_.tip).norm()) + (is_straight ? 0 : length_);
    return share * (length_ + turn_ * far);
  }

  void narrow(int first, int last, const std::vector<std::size_t>& candidates) {
    const double middle = 0.5 * (first + last) / effort_.steps;
    const double share = 0.5 * (last - first) / effort_.steps;
    const Pose pose = movement_.at(middle);
    std::vector<std::size_t> left;
    for (const std::size_t i : candidates) {
      const Piece& p = pieces_[i];
      if (tool_.depth(pose, p.middle) + p.radius + travel(p.middle, share) > mark_ - 0.002) left.push_back(i);
    }
    if (left.empty()) return;
    if (first == last) return look(first, left);
    const int cut = (first + last) / 2;
    narrow(first, cut, left);
    narrow(cut + 1, last, left);
  }

  [[nodiscard]] Vec3 point(const Place& p) const {
    const Triangle& t = pieces_[p.piece].corners;
    return t[0] + p.u * (t[1] - t[0]) + p.v * (t[2] - t[0]);
  }

  double try_place(const Pose& pose, double t, std::size_t piece, const Vec2& uv, Place& best) const {
    Place place{0, t, piece, uv.x(), uv.y()};
    place.depth = tool_.depth(pose, point(place));
    if (place.depth > best.depth) best = place;
    return place.depth;
  }

  void look(int step, const std::vector<std::size_t>& candidates) {
    const double t = static_cast<double>(step) / effort_.steps;
    const Pose pose = movement_.at(t);
    Place& best = best_of_[static_cast<std::size_t>(step)];
    std::priority_queue<Cut> open;
    for (const std::size_t i : candidates) bound(pose, t, i, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, best, open);
    for (int looks = 0; looks < effort_.looks && !open.empty(); ++looks) {
      const Cut cut = open.top();
      open.pop();
      if (cut.bound <= std::max(mark_, best.depth) + effort_.accuracy_mm) return;
      const Vec2 ab = 0.5 * (cut.uv[0] + cut.uv[1]), bc = 0.5 * (cut.uv[1] + cut.uv[2]),
                 ca = 0.5 * (cut.uv[2] + cut.uv[0]);
      bound(pose, t, cut.piece, {ab, bc, ca}, best, open);
      bound(pose, t, cut.piece, {cut.uv[0], ab, ca}, best, open);
      bound(pose, t, cut.piece, {ab, cut.uv[1], bc}, best, open);
      bound(pose, t, cut.piece, {ca, bc, cut.uv[2]}, best, open);
    }
  }

  void bound(const Pose& pose, double t, std::size_t piece, const std::array<Vec2, 3>& uv, Place& best,
             std::priority_queue<Cut>& open) const {
    const Vec2 middle = (uv[0] + uv[1] + uv[2]) / 3.0;
    const double here = try_place(pose, t, piece, middle, best);
    for (const Vec2& corner : uv) try_place(pose, t, piece, corner, best);
    // After k divisions into four, the pieces of a triangle are 2^k times smaller than the triangle.
    const double scale = std::max((uv[1] - uv[0]).cwiseAbs().maxCoeff(), (uv[2] - uv[0]).cwiseAbs().maxCoeff());
    open.push({here + scale * pieces_[piece].radius, piece, uv});
  }

  // Climbs from a sample to the top of its hill, over the triangle and over time.
  [[nodiscard]] Place climb(Place best) const {
    double step = 1.0 / effort_.steps, size = 0.1;
    for (int round = 0; round < 60 && step > 1e-12; ++round) {
      const Place from = best;
      for (int k = 0; k < 27; ++k) {
        Place next = from;
        next.t = std::clamp(from.t + (k % 3 - 1) * step, 0.0, 1.0);
        next.u = std::clamp(from.u + (k / 3 % 3 - 1) * size, 0.0, 1.0);
        next.v = std::clamp(from.v + (k / 9 - 1) * size, 0.0, 1.0 - next.u);
        next.depth = tool_.depth(movement_.at(next.t), point(next));
        if (next.depth > best.depth) best = next;
      }
      if (best.depth > from.depth) continue;
      step /= 2;
      size /= 2;
    }
    return best;
  }

  const Contour& tool_;
  Movement movement_;
  Pose from_, to_;
  Effort effort_;
  double turn_ = 0, length_ = 0, mark_ = 0;
  std::vector<Piece> pieces_;
  std::vector<Place> best_of_;
};

/// Returns the deepest point of parts and fixtures in a move, as far as the search finds it.
inline Found deepest(const Contour& against_part, const Contour& against_fixture, const Movement& movement,
                     const Scene& scene, double mark_mm, const Effort& effort = {}) {
  const Found part = Search(against_part, movement, scene.parts, effort).run(mark_mm);
  const Found fixture = Search(against_fixture, movement, scene.fixtures, effort).run(std::max(mark_mm, part.depth_mm));
  return fixture.depth_mm > part.depth_mm ? fixture : part;
}
inline Found deepest(const Contour& against_part, const Contour& against_fixture, const Pose& from, const Pose& to,
                     const Scene& scene, double mark_mm, const Effort& effort = {}) {
  return deepest(against_part, against_fixture, Movement{from, to, nullptr, nullptr, std::nullopt}, scene, mark_mm,
                 effort);
}

}  // namespace gouge::reference
