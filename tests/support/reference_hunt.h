#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <queue>
#include <vector>

#include "tests/support/reference.h"

// A search for the deepest point of a surface in a moving solid, for very many moves. It is a best-first search over
// time and surface together, with a bound of the change of a distance. A climb from the best places follows. The result
// is a lower bound of the true depth, and takes about a millisecond. Header only.

namespace gouge::reference {

/// Returns the solid angle of the mesh seen from p, as a share of the full sphere: 1 inside, 0 outside.
inline double solid_angle_share(const IndexedMesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const TriangleCorners& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p, c = mesh.vertices[t[2]] - p;
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return sum / (4 * std::numbers::pi);
}

/// The solid of a tool along a move.
class MovingTool {
 public:
  MovingTool(const Contour& contour, const Movement& movement) : contour_(contour), movement_(movement) {}

  using Frame = Pose;
  [[nodiscard]] Frame frame(double t) const { return movement_.at(t); }
  [[nodiscard]] double depth(const Frame& pose, const Vec3& p) const { return contour_.depth(pose, p); }
  [[nodiscard]] double turn_rad() const { return movement_.turn_rad(); }
  [[nodiscard]] const Movement& movement() const { return movement_; }

 private:
  const Contour& contour_;
  const Movement& movement_;
};

/// The solid of a head along a move. At every position it is turned from upright the shortest way. Between two
/// positions it turns with the axis. The rest of the turn about the axis is spread evenly over the move
/// (docs/method/guarantee.md). If the move has rotary axes, the head turns with them.
class MovingHead {
 public:
  MovingHead(const IndexedMesh& head, const Movement& movement) : head_(head), movement_(movement) {
    if (movement.rotaries || movement.frames) return;
    at_start_ = movement.ends ? Eigen::Quaterniond((*movement.ends)[0]) : upright_to(movement.from.axis);
    const Eigen::Quaterniond at_end =
        movement.ends ? Eigen::Quaterniond((*movement.ends)[1]) : upright_to(movement.to.axis);
    const Eigen::Quaterniond carried = along(movement.to.axis) * at_start_;
    const Eigen::AngleAxisd left(at_end * carried.conjugate());
    twist_ = left.angle() * (left.axis().dot(movement.to.axis) < 0 ? -1 : 1);
    if (twist_ > std::numbers::pi) twist_ -= 2 * std::numbers::pi;
  }

  struct Frame {
    Vec3 tip = Vec3::Zero();
    Eigen::Quaterniond turn;
  };
  [[nodiscard]] Frame frame(double t) const {
    const Pose pose = movement_.at(t);
    if (movement_.rotaries) return {pose.tip, movement_.rotaries->turn(t)};
    if (movement_.frames) return {pose.tip, Eigen::Quaterniond(movement_.frames->frame(t).rotation)};
    return {pose.tip, Eigen::Quaterniond(Eigen::AngleAxisd(t * twist_, pose.axis)) * along(pose.axis) * at_start_};
  }
  [[nodiscard]] double depth(const Frame& frame, const Vec3& p) const {
    const Vec3 q = frame.turn.conjugate() * (p - frame.tip);
    double nearest = 1e300;
    for (std::size_t t = 0; t < head_.triangles.size(); ++t)
      nearest = std::min(nearest, distance_to_triangle(q, head_.corner(t, 0), head_.corner(t, 1), head_.corner(t, 2)));
    return solid_angle_share(head_, q) > 0.5 ? nearest : -nearest;
  }
  [[nodiscard]] double turn_rad() const { return movement_.turn_rad() + std::abs(twist_); }
  [[nodiscard]] const Movement& movement() const { return movement_; }

 private:
  static Eigen::Quaterniond upright_to(const Vec3& axis) {
    return Eigen::Quaterniond::FromTwoVectors(Vec3(0, 0, 1), axis);
  }
  [[nodiscard]] Eigen::Quaterniond along(const Vec3& axis) const {
    return Eigen::Quaterniond::FromTwoVectors(movement_.from.axis, axis);
  }

  const IndexedMesh& head_;
  const Movement& movement_;
  Eigen::Quaterniond at_start_;
  double twist_ = 0;
};

template <class Solid>
class Hunt {
 public:
  Hunt(const Solid& solid, const std::vector<IndexedMesh>& meshes, int looks) : solid_(solid), looks_(looks) {
    length_ = solid.movement().length();
    turn_ = solid.turn_rad();
    for (const IndexedMesh& mesh : meshes) {
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        triangles_.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    }
  }

  /// Runs the search. A point no deeper than `mark_mm` is used only as a starting point of a climb.
  Found run(double mark_mm) {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
      offer({0, 0, 1, i, {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}}, mark_mm);
    int looks = 0;
    for (; looks < looks_ && !open_.empty(); ++looks) {
      const Cell cell = open_.top();
      if (cell.bound <= std::max(mark_mm, best().depth) + kAccuracy_mm) break;
      open_.pop();
      split(cell, mark_mm);
    }
    Found found;
    const bool is_decided = open_.empty() && best().depth < mark_mm - kClimbable_mm;
    for (const Place& place : places_) {
      if (!(place.depth > -1e299) || is_decided) continue;
      const Place top = climb(place);
      if (top.depth > found.depth_mm) found = {top.depth, top.t, point(top)};
    }
    return found;
  }

 private:
  static constexpr double kAccuracy_mm = 1e-3, kClimbable_mm = 0.05;

  struct Place {
    double depth = -1e300;
    double t = 0;
    std::uint32_t triangle = 0;
    double u = 0, v = 0;  ///< point = a + u (b - a) + v (c - a)
  };
  struct Cell {
    double bound = 0;
    double t0 = 0, t1 = 1;
    std::uint32_t triangle = 0;
    std::array<Vec2, 3> uv;
    double radius = 0, travel = 0;
    bool operator<(const Cell& other) const { return bound < other.bound; }
  };

  [[nodiscard]] const Place& best() const { return places_[0]; }
  [[nodiscard]] Vec3 point(std::uint32_t triangle, double u, double v) const {
    const auto& [a, b, c] = triangles_[triangle];
    return a + u * (b - a) + v * (c - a);
  }
  [[nodiscard]] Vec3 point(const Place& p) const { return point(p.triangle, p.u, p.v); }

  void offer(Cell cell, double mark_mm) {
    const Vec2 uv = (cell.uv[0] + cell.uv[1] + cell.uv[2]) / 3.0;
    const Vec3 middle = point(cell.triangle, uv.x(), uv.y());
    cell.radius = 0;
    for (const Vec2& corner : cell.uv)
      cell.radius = std::max(cell.radius, (point(cell.triangle, corner.x(), corner.y()) - middle).norm());
    const double t = 0.5 * (cell.t0 + cell.t1);
    const auto frame = solid_.frame(t);
    const Vec3 tip = solid_.movement().at(t).tip;
    // The time differs by at most half of the span from t. In that time the tip moves by at most half of its path in
    // the span.
    cell.travel =
        0.5 * (cell.t1 - cell.t0) * (length_ + turn_ * ((middle - tip).norm() + 0.5 * (cell.t1 - cell.t0) * length_));
    const double depth = solid_.depth(frame, middle);
    keep({depth, t, cell.triangle, uv.x(), uv.y()});
    cell.bound = depth + cell.radius + cell.travel;
    if (cell.bound > mark_mm) open_.push(cell);
  }

  // Keeps the place if it is among the three best places of different triangles.
  void keep(const Place& place) {
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (place.depth > places_[k].depth) {
        std::size_t last = k;
        while (last + 1 < places_.size() && places_[last].triangle != place.triangle) ++last;
        for (std::size_t m = last; m > k; --m) places_[m] = places_[m - 1];
        places_[k] = place;
        return;
      }
      if (places_[k].triangle == place.triangle) return;
    }
  }

  void split(const Cell& cell, double mark_mm) {
    if (cell.travel > cell.radius) {
      const double middle = 0.5 * (cell.t0 + cell.t1);
      Cell half = cell;
      half.t1 = middle;
      offer(half, mark_mm);
      half = cell;
      half.t0 = middle;
      return offer(half, mark_mm);
    }
    std::size_t longest = 0;
    double length = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 side = cell.uv[(k + 1) % 3] - cell.uv[k];
      const auto& [a, b, c] = triangles_[cell.triangle];
      const double of_side = (side.x() * (b - a) + side.y() * (c - a)).squaredNorm();
      if (of_side > length) {
        length = of_side;
        longest = k;
      }
    }
    const Vec2 middle = 0.5 * (cell.uv[longest] + cell.uv[(longest + 1) % 3]);
    for (const std::size_t moved : {longest, (longest + 1) % 3}) {
      Cell half = cell;
      half.uv[moved] = middle;
      offer(half, mark_mm);
    }
  }

  // Climbs from a place to the top of its hill, over the triangle and over time. Steps of equal length go along the
  // coordinates and in a dozen random directions, because hills have ridges.
  [[nodiscard]] Place climb(Place best) const {
    constexpr double kShortest_mm = 1e-7;
    const auto& [a, b, c] = triangles_[best.triangle];
    const Vec3 middle = point(best);
    const double speed = length_ + turn_ * (middle - solid_.movement().at(best.t).tip).norm();
    const Vec3 per_mm(speed > 0 ? 1 / speed : 0, 1 / (b - a).norm(), 1 / (c - a).norm());
    std::uint64_t state = 0x9e3779b97f4a7c15ULL + triangles_.size();
    const auto random = [&state] {
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      return static_cast<double>(state >> 11U) * 0x1.0p-52 - 1;
    };
    double step_mm = 0.1 * std::max({speed, (b - a).norm(), (c - a).norm()});
    for (int round = 0; round < 200 && step_mm > kShortest_mm; ++round) {
      const Place from = best;
      for (int k = 0; k < 18; ++k) {
        Vec3 travel = k < 6 ? Vec3((k % 2 == 0 ? 1 : -1) * Vec3::Unit(k / 2)) : Vec3(random(), random(), random());
        travel = step_mm * travel.cwiseProduct(per_mm);
        Place next = from;
        next.t = std::clamp(from.t + travel.x(), 0.0, 1.0);
        next.u = std::clamp(from.u + travel.y(), 0.0, 1.0);
        next.v = std::clamp(from.v + travel.z(), 0.0, 1.0 - next.u);
        next.depth = solid_.depth(solid_.frame(next.t), point(next));
        if (next.depth > best.depth) best = next;
      }
      step_mm *= best.depth > from.depth ? 1.5 : 0.4;
    }
    return best;
  }

  const Solid& solid_;
  int looks_;
  double length_ = 0, turn_ = 0;
  std::vector<std::array<Vec3, 3>> triangles_;
  std::array<Place, 3> places_;
  std::priority_queue<Cell> open_;
};

}  // namespace gouge::reference
