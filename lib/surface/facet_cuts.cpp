#include "lib/surface/facet_cuts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/geom/vec.h"

namespace gouge {
namespace {

using Segment2 = std::array<Vec2, 2>;
using Polygon = std::vector<std::size_t>;

/// A directed line in the plane. Heights are positive on its left.
struct Line2 {
  Vec2 through, along;
  explicit Line2(const Segment2& segment)
      : through(segment[0]), along((segment[1] - segment[0]) / (segment[1] - segment[0]).norm()) {}
  [[nodiscard]] double height(const Vec2& point) const { return cross(along, point - through); }
};

class Cutter {
 public:
  Cutter(const std::array<Vec3, 3>& triangle, double rounding_mm) : origin_(triangle[0]), rounding_mm_(rounding_mm) {
    e1_ = (triangle[1] - triangle[0]).normalized();
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
    e2_ = normal.cross(e1_);
    for (const Vec3& corner : triangle) {
      points_.push_back(flat(corner));
      pieces_.points.push_back(corner);
    }
  }

  FacetPieces run(std::span<const std::array<Vec3, 2>> segments) {
    Task all{{0, 1, 2}, {}};
    for (const std::array<Vec3, 2>& segment : segments) add({flat(segment[0]), flat(segment[1])}, all.segments);
    std::vector<Task> open(1, std::move(all));
    while (!open.empty()) {
      Task task = std::move(open.back());
      open.pop_back();
      cut(std::move(task), open);
    }
    return std::move(pieces_);
  }

 private:
  struct Task {
    Polygon polygon;
    std::vector<Segment2> segments;
  };

  [[nodiscard]] Vec2 flat(const Vec3& point) const { return {e1_.dot(point - origin_), e2_.dot(point - origin_)}; }
  [[nodiscard]] double snapped(double height) const { return std::abs(height) <= rounding_mm_ ? 0 : height; }

  void add(const Segment2& segment, std::vector<Segment2>& segments) const {
    if ((segment[1] - segment[0]).norm() > rounding_mm_) segments.push_back(segment);
  }

  /// Cuts the polygon along one segment that runs through it. If there is none, the polygon is a piece.
  void cut(Task task, std::vector<Task>& open) {
    while (!task.segments.empty()) {
      const std::size_t pick = task.segments.size() / 2;
      const Segment2 segment = task.segments[pick];
      task.segments[pick] = task.segments.back();
      task.segments.pop_back();
      if (!runs_through(segment, task.polygon)) continue;
      const Line2 line(segment);
      std::array<Task, 2> halves;
      if (!split(task.polygon, line, halves[0].polygon, halves[1].polygon)) continue;
      for (const Segment2& other : task.segments) distribute(other, line, halves);
      open.push_back(std::move(halves[1]));
      open.push_back(std::move(halves[0]));
      return;
    }
    if (is_wide(task.polygon)) pieces_.polygons.push_back(std::move(task.polygon));
  }

  /// Returns whether the length of the segment in the polygon is more than rounding.
  [[nodiscard]] bool runs_through(const Segment2& segment, const Polygon& polygon) const {
    double from = 0, to = 1;
    for (std::size_t k = 0; k < polygon.size() && from < to; ++k) {
      const Vec2 side = points_[polygon[(k + 1) % polygon.size()]] - points_[polygon[k]];
      const double length = side.norm();
      if (!(length > 0)) continue;
      const double here = cross(side, segment[0] - points_[polygon[k]]) / length;
      const double there = cross(side, segment[1] - points_[polygon[k]]) / length;
      if (here <= rounding_mm_ && there <= rounding_mm_) return false;
      if (here < 0) from = std::max(from, here / (here - there));
      if (there < 0) to = std::min(to, here / (here - there));
    }
    return (to - from) * (segment[1] - segment[0]).norm() > rounding_mm_;
  }

  /// Splits a polygon. Returns false if it is on one side of the line.
  bool split(const Polygon& polygon, const Line2& line, Polygon& left, Polygon& right) {
    std::vector<double> heights;
    for (const std::size_t point : polygon) heights.push_back(snapped(line.height(points_[point])));
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    if (*lowest >= 0 || *highest <= 0) return false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const std::size_t next = (k + 1) % polygon.size();
      const double here = heights[k], there = heights[next];
      if (here >= 0) left.push_back(polygon[k]);
      if (here <= 0) right.push_back(polygon[k]);
      if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
        const Vec2 &a = points_[polygon[k]], &b = points_[polygon[next]];
        const std::size_t added = add_point(a + here / (here - there) * (b - a));
        left.push_back(added);
        right.push_back(added);
      }
    }
    return true;
  }

  std::size_t add_point(const Vec2& point) {
    points_.push_back(point);
    pieces_.points.push_back(origin_ + point.x() * e1_ + point.y() * e2_);
    return points_.size() - 1;
  }

  void distribute(const Segment2& segment, const Line2& line, std::array<Task, 2>& halves) const {
    const double here = snapped(line.height(segment[0])), there = snapped(line.height(segment[1]));
    const double most = std::max(here, there), least = std::min(here, there);
    if (least >= 0 && most <= 0) return;  // the segment is along the cut
    if (least >= 0) return add(segment, halves[0].segments);
    if (most <= 0) return add(segment, halves[1].segments);
    const Vec2 middle = segment[0] + here / (here - there) * (segment[1] - segment[0]);
    add({segment[0], middle}, halves[here > 0 ? 0 : 1].segments);
    add({middle, segment[1]}, halves[here > 0 ? 1 : 0].segments);
  }

  [[nodiscard]] bool is_wide(const Polygon& polygon) const {
    double area2 = 0, rim = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec2 &a = points_[polygon[k]], &b = points_[polygon[(k + 1) % polygon.size()]];
      area2 += cross(a - points_[polygon[0]], b - points_[polygon[0]]);
      rim += (b - a).norm();
    }
    return area2 > rounding_mm_ * rim;
  }

  Vec3 origin_, e1_, e2_;
  double rounding_mm_;
  std::vector<Vec2> points_;
  FacetPieces pieces_;
};

}  // namespace

FacetPieces cut_facet(const std::array<Vec3, 3>& triangle, std::span<const std::array<Vec3, 2>> segments,
                      double rounding_mm) {
  return Cutter(triangle, rounding_mm).run(segments);
}

}  // namespace gouge
