#include "tests/bench/convex_piece.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gouge::bench {
namespace {

struct PlaneSample {
  double distance = 0;
  Vec2 gradient = Vec2::Zero();
};

/// Signed distance from the core in the half plane. A core without area has only an outside.
PlaneSample sample_core(const std::vector<Vec2>& contour, const Vec2& q) {
  double nearest2 = std::numeric_limits<double>::infinity();
  double highest = -nearest2;
  Vec2 away = Vec2::Zero(), face = Vec2::Zero();
  const bool has_area = contour.size() > 2;
  for (std::size_t k = 0; k + 1 < contour.size(); ++k) {
    const Vec2 along = contour[k + 1] - contour[k];
    const double t = std::clamp((q - contour[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec2 from = q - (contour[k] + t * along);
    if (from.squaredNorm() < nearest2) {
      nearest2 = from.squaredNorm();
      away = from;
    }
    const Vec2 normal = Vec2(along.y(), -along.x()) / along.norm();
    const double height = normal.dot(q - contour[k]);
    if (height > highest) {
      highest = height;
      face = normal;
    }
  }
  if (has_area && highest <= 0) return {highest, face};
  const double distance = std::sqrt(nearest2);
  return {distance, distance > 0 ? Vec2(away / distance) : (has_area ? face : Vec2::Zero())};
}

double lowest_change(const Vec3& gradient, const std::array<Vec3, 3>& t, const Vec3& from) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& corner : t) lowest = std::min(lowest, gradient.dot(corner - from));
  return lowest;
}

Vec3 closest_on_segment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  return length2 > 0 ? Vec3(a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along) : a;
}

/// Closest point of a triangle; a good guess is enough here, whatever the triangle's shape.
Vec3 closest_on_triangle(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area2 = normal.squaredNorm();
  if (area2 > 0) {
    bool is_over = true;
    for (std::size_t k = 0; k < 3; ++k) {
      is_over = is_over && normal.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) >= 0;
    }
    if (is_over) return p - (normal.dot(p - t[0]) / area2) * normal;
  }
  Vec3 best = closest_on_segment(t[0], t[1], p);
  for (std::size_t k = 1; k < 3; ++k) {
    const Vec3 other = closest_on_segment(t[k], t[(k + 1) % 3], p);
    if ((other - p).squaredNorm() < (best - p).squaredNorm()) best = other;
  }
  return best;
}

using Polygon = std::vector<Vec2>;

Vec2 centroid(const Polygon& polygon) {
  double area = 0;
  Vec2 moment = Vec2::Zero(), mean = Vec2::Zero();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec2 a = polygon[k] - polygon[0], b = polygon[k + 1] - polygon[0];
    const double twice = a.x() * b.y() - a.y() * b.x();
    area += twice;
    moment += twice * (a + b) / 3;
  }
  if (area > 1e-300) return polygon[0] + moment / area;
  for (const Vec2& p : polygon) mean += p;
  return mean / static_cast<double>(polygon.size());
}

/// Keeps of the polygon what has slope . p <= limit.
void clip(Polygon& polygon, const Vec2& slope, double limit, Polygon& scratch) {
  scratch.clear();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double over_a = slope.dot(a) - limit, over_b = slope.dot(b) - limit;
    if (over_a <= 0) scratch.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) {
      scratch.push_back(a + over_a / (over_a - over_b) * (b - a));
    }
  }
  polygon.swap(scratch);
}

struct Search {
  const ConvexPiece& piece;
  const Pose& pose;
  double accuracy;
  TriangleMinimum& best;

  /// Goes back and forth between the core and the triangle; true when the minimum is closed on the way. That
  /// is the common case.
  bool alternate(const std::array<Vec3, 3>& t) {
    constexpr int kTurns = 6;
    Vec3 x = (t[0] + t[1] + t[2]) / 3.0;
    for (int turn = 0; turn < kTurns; ++turn) {
      const PieceSample s = sample_piece(piece, pose, x);
      if (s.distance_mm < best.distance_mm) best = {s.distance_mm, x};
      if (s.distance_mm + lowest_change(s.gradient, t, x) >= best.distance_mm - accuracy) return true;
      if (s.distance_mm < -piece.rounding_mm) return false;
      x = closest_on_triangle(t, x - (s.distance_mm + piece.rounding_mm) * s.gradient);
    }
    return false;
  }

  /// Keeps the part of the triangle where something lower than the best may still be, as a polygon in the
  /// triangle's own coordinates, and cuts it at its centre of gravity by the plane tangent there: convexity
  /// leaves at most 1 - 1/e of its area after each cut. No smoothness is required. True when nothing is left.
  bool cut(const std::array<Vec3, 3>& t) {
    constexpr int kCuts = 120;
    const Vec3 u = t[1] - t[0], v = t[2] - t[0];
    Polygon polygon = {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    for (int step = 0; step < kCuts; ++step) {
      const Vec2 c = centroid(polygon);
      const Vec3 x = t[0] + c.x() * u + c.y() * v;
      const PieceSample s = sample_piece(piece, pose, x);
      if (s.distance_mm < best.distance_mm) best = {s.distance_mm, x};
      const Vec2 slope(s.gradient.dot(u), s.gradient.dot(v));
      clip(polygon, slope, slope.dot(c) + best.distance_mm - accuracy - s.distance_mm, scratch);
      if (polygon.size() < 3) return true;
    }
    return false;
  }

  /// Quarters the triangle until every piece is closed: slow where the minimum is not smooth, never wrong.
  void visit(const std::array<Vec3, 3>& t) {
    const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    const PieceSample s = sample_piece(piece, pose, middle);
    if (s.distance_mm < best.distance_mm) best = {s.distance_mm, middle};
    // Convexity: the tangent plane at the middle lies below the function, and is lowest at a corner.
    if (s.distance_mm + lowest_change(s.gradient, t, middle) >= best.distance_mm - accuracy) return;
    const Vec3 ab = 0.5 * (t[0] + t[1]), bc = 0.5 * (t[1] + t[2]), ca = 0.5 * (t[2] + t[0]);
    visit({ab, bc, ca});
    visit({t[0], ab, ca});
    visit({ab, t[1], bc});
    visit({ca, bc, t[2]});
  }

  Polygon scratch{};
};

}  // namespace

PieceSample sample_piece(const ConvexPiece& piece, const Pose& pose, const Vec3& p) {
  const Vec3 d = p - pose.tip;
  const double z = d.dot(pose.axis);
  const Vec3 radial = d - z * pose.axis;
  const double r = radial.norm();
  const PlaneSample s = sample_core(piece.contour, Vec2(r, z));
  PieceSample out;
  out.distance_mm = s.distance - piece.rounding_mm;
  // On the axis every radial direction is as good; the function grows with r, so none is a subgradient too.
  out.gradient = s.gradient.y() * pose.axis;
  if (r > 1e-12) out.gradient += (s.gradient.x() / r) * radial;
  return out;
}

Vec3 support_offset(const ConvexPiece& piece, const Vec3& axis, const Vec3& direction) {
  const double along = direction.dot(axis);
  Vec3 radial = direction - along * axis;
  const double across = radial.norm();
  radial = across > 1e-12 ? Vec3(radial / across) : Vec3::Zero();
  double farthest = -std::numeric_limits<double>::infinity();
  Vec3 offset = Vec3::Zero();
  for (const Vec2& v : piece.contour) {
    const double reach = v.x() * across + v.y() * along;
    if (reach > farthest) {
      farthest = reach;
      offset = v.x() * radial + v.y() * axis;
    }
  }
  return offset + piece.rounding_mm * direction.normalized();
}

void lower_over_triangle(const ConvexPiece& piece, const Pose& pose, const std::array<Vec3, 3>& triangle,
                         double accuracy_mm, TriangleMinimum& best) {
  Search search = {piece, pose, accuracy_mm, best};
  if (!search.alternate(triangle) && !search.cut(triangle)) search.visit(triangle);
}

}  // namespace gouge::bench
