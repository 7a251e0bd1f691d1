#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/geom/pose.h"
#include "lib/tool/compiled_tool.h"

// The signed distance of a tool, computed only from its contour, for reference.h.

namespace gouge::reference {

/// The half profile of a tool as lines and arcs. Distances are computed by examining each of them. A point is inside if
/// a ray from it, away from the axis, crosses the profile an odd number of times. So undercuts and hollows have their
/// exact shape.
class Contour {
 public:
  explicit Contour(const CompiledTool& tool) {
    for (const BoundaryElement& e : tool.elements) {
      if (e.kind != ElementKind::vertex) pieces_.push_back(piece_of(e));
    }
    for (const Piece& p : pieces_) add_sides(p);
    for (const Piece& p : pieces_) {
      top_ = std::max({top_, p.a.y(), p.b.y()});
      widest_ = std::max({widest_, p.a.x(), p.b.x(), p.is_arc && faces(p, Vec2(1, 0)) ? p.c.x() + p.radius : 0});
    }
  }

  /// Returns the depth of (r, z) in the solid: the distance to the boundary, negative outside.
  [[nodiscard]] double depth(double r, double z) const {
    const Vec2 q(r, z);
    double nearest2 = 1e300;
    for (const Piece& p : pieces_) {
      if (p.is_arc) {
        const double away = arc_distance(p, q);
        nearest2 = std::min(nearest2, away * away);
      } else {
        nearest2 = std::min(nearest2, line_distance2(p, q));
      }
    }
    bool is_inside = false;
    for (const Side& s : sides_) is_inside ^= (s.a.y() <= z) != (s.b.y() <= z) && r < radius_at(s, z);
    return is_inside ? std::sqrt(nearest2) : -std::sqrt(nearest2);
  }

  /// Returns the distance to the nearest piece of one body.
  [[nodiscard]] double distance_to(Body body, double r, double z) const {
    double nearest = 1e300;
    for (const Piece& p : pieces_) {
      if (p.body != body) continue;
      nearest = std::min(nearest, p.is_arc ? arc_distance(p, Vec2(r, z)) : line_distance(p, Vec2(r, z)));
    }
    return nearest;
  }

  [[nodiscard]] double depth(const Pose& pose, const Vec3& p) const {
    const Vec3 d = p - pose.tip;
    const double z = d.dot(pose.axis);
    return depth(d.cross(pose.axis).norm(), z);
  }

  [[nodiscard]] bool is_empty() const { return pieces_.empty(); }
  [[nodiscard]] double top_mm() const { return top_; }
  [[nodiscard]] double widest_mm() const { return widest_; }

 private:
  struct Piece {
    bool is_arc = false;
    Body body = Body::cutter;
    Vec2 a, b, c;
    double radius = 0;
    double turn = 0;  ///< arcs: > 0 if they run counter-clockwise from a to b
  };

  static double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

  static Piece piece_of(const BoundaryElement& e) {
    Piece p{e.kind == ElementKind::arc, e.body, e.a, e.b, e.center, e.radius_mm, 0};
    if (p.is_arc) p.turn = cross(p.a - p.c, p.b - p.c) > 0 ? 1 : -1;
    return p;
  }

  // Returns whether the direction d from the centre meets the arc; arcs are shorter than half a circle.
  static bool faces(const Piece& p, const Vec2& d) {
    return p.turn * cross(p.a - p.c, d) >= 0 && p.turn * cross(d, p.b - p.c) >= 0;
  }

  static double line_distance2(const Piece& p, const Vec2& q) {
    const Vec2 along = p.b - p.a;
    const double s = std::clamp((q - p.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (p.a + s * along - q).squaredNorm();
  }
  static double line_distance(const Piece& p, const Vec2& q) { return std::sqrt(line_distance2(p, q)); }

  static double arc_distance(const Piece& p, const Vec2& q) {
    const Vec2 d = q - p.c;
    if (faces(p, d)) return std::abs(d.norm() - p.radius);
    return std::sqrt(std::min((q - p.a).squaredNorm(), (q - p.b).squaredNorm()));
  }

  // A stretch of the profile with one point at every height from a to b. It is a line, or an arc up to its highest or
  // lowest point.
  struct Side {
    Vec2 a, b, c;
    double radius = 0;
    double travel = 0;  ///< arcs: +1 on the side of the centre away from the axis, -1 on the side of the axis
  };

  void add_sides(const Piece& p) {
    if (!p.is_arc) return sides_.push_back({p.a, p.b, p.c, 0, 0});
    std::vector<Vec2> stops{p.a};
    for (const double up : {p.turn, -p.turn}) {
      const Vec2 top(0, up * p.radius);
      if (faces(p, top) && (p.c + top - p.a).norm() > 0 && (p.c + top - p.b).norm() > 0) stops.push_back(p.c + top);
    }
    stops.push_back(p.b);
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const Vec2 middle = 0.5 * (stops[k] + stops[k + 1]);
      sides_.push_back({stops[k], stops[k + 1], p.c, p.radius, middle.x() >= p.c.x() ? 1.0 : -1.0});
    }
  }

  static double radius_at(const Side& s, double z) {
    if (!(s.radius > 0)) return s.a.x() + (z - s.a.y()) / (s.b.y() - s.a.y()) * (s.b.x() - s.a.x());
    const double h = z - s.c.y();
    return s.c.x() + s.travel * std::sqrt(std::max(0.0, s.radius * s.radius - h * h));
  }

  std::vector<Side> sides_;
  std::vector<Piece> pieces_;
  double top_ = 0, widest_ = 0;
};

}  // namespace gouge::reference
