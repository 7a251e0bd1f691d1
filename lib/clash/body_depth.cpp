#include "lib/clash/body_depth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/clash/convex_region.h"
#include "lib/clash/local_maximum.h"
#include "lib/clash/surface_query.h"
#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr int kMixes = 3;         // number of facets that are mixed with the best one, one after another
constexpr int kWeightSteps = 24;  // number of steps in the search for each weight

constexpr std::size_t kMaxHullPoints = 8;

/// Distances of the hull's points to one facet, or a weighted mean of the distances to several.
using Distances = std::array<double, kMaxHullPoints>;

double largest(const Distances& d, std::size_t count) {
  return *std::max_element(d.begin(), d.begin() + static_cast<std::ptrdiff_t>(count));
}

Distances mixed(const Distances& a, const Distances& b, double weight) {
  Distances d;
  for (std::size_t v = 0; v < d.size(); ++v) d[v] = (1 - weight) * a[v] + weight * b[v];
  return d;
}

/// Returns the weight of `b` for which the largest mean is smallest. The largest mean is convex in the weight.
double best_weight(const Distances& a, const Distances& b, std::size_t count) {
  double low = 0, high = 1;
  for (int i = 0; i < kWeightSteps; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    const bool is_left_better = largest(mixed(a, b, left), count) < largest(mixed(a, b, right), count);
    (is_left_better ? high : low) = is_left_better ? right : left;
  }
  return 0.5 * (low + high);
}

/// Returns an upper bound of the distance to the surface, for all points of the convex hull of `points` (at most
/// kMaxHullPoints). The distance to a facet is convex, so its largest value over the hull is at one of the points. The
/// same holds for any weighted mean of such distances. The distance to the surface is at most that mean.
///
/// Requires at least one of `facets`; those nearest to the points are the best choice.
/// Ensures  The bound is exact (up to rounding) if the hull lies over one facet, or between two opposite facets.
double greatest_distance_mm(const Surface& surface, std::span<const Vec3> points,
                            std::span<const std::uint32_t> facets) {
  std::array<Distances, kMaxHullPoints + 1> rows{};
  const std::size_t count = std::min(facets.size(), rows.size());
  std::size_t best = 0;
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t v = 0; v < points.size(); ++v)
      rows[k][v] = std::sqrt(closest_on_triangle(points[v], surface.corners(facets[k])).distance2_mm2);
    if (largest(rows[k], points.size()) < largest(rows[best], points.size())) best = k;
  }
  Distances now = rows[best];
  double least = largest(now, points.size());
  for (int mix = 0; mix < kMixes && count > 1; ++mix) {
    Distances next = now;
    double next_least = least;
    for (std::size_t k = 0; k < count; ++k) {
      const Distances tried = mixed(now, rows[k], best_weight(now, rows[k], points.size()));
      if (!(largest(tried, points.size()) < next_least)) continue;
      next = tried;
      next_least = largest(tried, points.size());
    }
    if (!(next_least < least)) break;
    now = next;
    least = next_least;
  }
  return least;
}

// A piece is cut along the outline of a facet if the part over the facet has at least this share of the piece's area.
constexpr double kMinShare = 0.125;
// Share of the threshold by which a surface may reach over the near side of a region that is outside.
constexpr double kGraze = 0.25;

struct Region : SearchCandidate, ConvexRegion {
  enum class Kind : std::uint8_t { node, piece, cell };
  Kind kind = Kind::node;
  bool is_leaf = false;       ///< the node is a leaf
  std::uint32_t index = 0;    ///< index of a node, a leaf or a triangle
  std::uint32_t nearest = 0;  ///< the triangle nearest to the centre
  double ball_mm = 0;         ///< for a node: maximum distance of its content from the centre
  bool is_over_face = false;  ///< the centre lies over the nearest triangle, not beyond its outline
};

class DepthSearch : private BestFirstSearch<DepthSearch, Region> {
 public:
  DepthSearch(const ClashBody& of, const ClashBody& in, const Vec3& shift, const SearchGoal& goal)
      : of_(of), in_(in), shift_(shift), goal_(goal) {}

  BodyDepth run_all() {
    const BlockTree& tree = of_.boundary().tree();
    if (tree.nodes.empty() || in_.boundary().tree().nodes.empty()) return best_;
    add_node(LaneBound(tree), 0, false);
    Box3 box = of_.boundary().mesh().box();
    box = Box3(Vec3(box.min() + shift_), Vec3(box.max() + shift_)).intersection(in_.boundary().mesh().box());
    if (of_.is_solid() && !box.isEmpty()) add_cell(box);
    best_.depth_upper_mm = std::max(best_.depth_mm, run());
    best_.is_decided = is_decided();
    return best_;
  }

  static constexpr bool kDescends = false;
  [[nodiscard]] double threshold_mm() const { return goal_.pruning_threshold_mm(best_.depth_mm); }
  [[nodiscard]] bool is_exhausted() const { return best_.bounds >= goal_.budget; }

  void split(const Region& region) {
    if (region.kind == Region::Kind::node) return region.is_leaf ? split_leaf(region.index) : split_node(region.index);
    if (region.kind == Region::Kind::cell) {
      for (const Box3& half : halves(region.box())) add_cell(half);
      return;
    }
    for (const ConvexRegion& part : parts_of(region)) add_piece(region.index, part);
  }

 private:
  void split_node(std::uint32_t index) {
    const BlockTree& tree = of_.boundary().tree();
    const NodeBlock& node = tree.nodes[index];
    for (std::size_t lane = 0; lane < node.count; ++lane)
      add_node(LaneBound(tree, node, lane), node.child[lane], node.has_leaves);
  }

  void split_leaf(std::uint32_t index) {
    const TriangleBlock& leaf = of_.boundary().tree().leaves[index];
    for (std::size_t k = 0; k < leaf.count; ++k) {
      ConvexRegion facet;
      for (const Vec3& corner : of_.boundary().corners(leaf.triangle[k])) facet.add(corner + shift_);
      add_piece(leaf.triangle[k], facet);
    }
  }

  void add_node(const LaneBound& bound, std::uint32_t index, bool is_leaf) {
    ConvexRegion hull;
    for (const Vec3& corner : bound.hull()) hull.add(corner + shift_);
    Region region = region_of(Region::Kind::node, index, hull);
    region.is_leaf = is_leaf;
    region.ball_mm = bound.radius_mm;
    offer_bounded(region);
  }

  void add_piece(std::uint32_t triangle, const ConvexRegion& piece) {
    offer_bounded(region_of(Region::Kind::piece, triangle, piece));
  }

  void add_cell(const Box3& box) { offer_bounded(region_of(Region::Kind::cell, 0, region_of_box(box))); }

  static Region region_of(Region::Kind kind, std::uint32_t index, const ConvexRegion& shape) {
    Region region;
    static_cast<ConvexRegion&>(region) = shape;
    region.kind = kind;
    region.index = index;
    return region;
  }

  /// Offers the region with an upper bound of the depth in it, unless the region is completely outside.
  void offer_bounded(Region region) {
    const Vec3 centre = region.centre();
    const double radius = region.kind == Region::Kind::node ? region.ball_mm : region.radius_mm(centre);
    const ClosestPoint foot = measured(centre, region.kind);
    region.is_over_face = is_over(foot, centre);
    const double inside = -foot.signed_mm();
    if (inside < -radius - Tolerance::kRounding_mm) return;
    region.nearest = foot.triangle;
    region.upper_mm = inside + radius + Tolerance::kRounding_mm;
    if (region.upper_mm > threshold_mm()) {
      if (region.kind == Region::Kind::cell && !may_hold_maximum(centre, radius, foot)) return;
      region.upper_mm = std::min(region.upper_mm, bound(region, centre, radius, foot) + Tolerance::kRounding_mm);
    }
    offer(region);
  }

  [[nodiscard]] bool is_over(const ClosestPoint& foot, const Vec3& point) const {
    return closest_on_triangle(point, in_.boundary().corners(foot.triangle)).feature == TriangleFeature::face;
  }

  /// Returns the point of the other surface that is closest to `point`. If `point` is in both bodies, its depth counts
  /// as a result.
  ClosestPoint measured(const Vec3& point, Region::Kind kind) {
    ++best_.bounds;
    const ClosestPoint foot = in_.closest_point(point);
    if (kind == Region::Kind::node || !foot.is_inside || foot.distance_mm <= best_.depth_mm) return foot;
    if (kind == Region::Kind::cell && !of_.closest_point(point - shift_).is_inside) return foot;
    best_.depth_mm = foot.distance_mm;
    best_.point = point;
    best_.normal = foot.normal;
    best_.triangle = foot.triangle;
    return foot;
  }

  /// Returns whether a point of the cell that is in both bodies may be a local maximum of the depth.
  [[nodiscard]] bool may_hold_maximum(const Vec3& centre, double radius, const ClosestPoint& foot) {
    ++best_.bounds;
    if (of_.closest_point(centre - shift_).signed_mm() > radius + Tolerance::kRounding_mm) return false;
    return in_.maxima().may_hold(centre, radius + Tolerance::kRounding_mm, foot);
  }

  double bound(const Region& region, const Vec3& centre, double radius, const ClosestPoint& foot) {
    std::array<std::uint32_t, kMaxHullPoints + 1> facets{foot.triangle};
    std::size_t count = 1;
    for (const Vec3& point : region.points()) {
      const std::uint32_t facet = measured(point, region.kind).triangle;
      if (std::find(facets.begin(), facets.begin() + static_cast<std::ptrdiff_t>(count), facet) ==
          facets.begin() + static_cast<std::ptrdiff_t>(count))
        facets[count++] = facet;
    }
    const double over = greatest_distance_mm(in_.boundary(), region.points(), std::span(facets).first(count));
    return foot.is_inside ? over : std::min(over, grazing_bound(region, centre, radius, foot));
  }

  /// Bounds the depth if the centre is outside. Apart from `graze`, all of the surface in the ball around the region
  /// lies beyond the region. So a line from the centre to a point inside crosses the surface within `graze` of the
  /// region's far side. The distance of the point from the crossing is at most the length on which the line descends by
  /// `graze`.
  [[nodiscard]] double grazing_bound(const Region& region, const Vec3& centre, double radius,
                                     const ClosestPoint& foot) const {
    const double graze = kGraze * threshold_mm();
    const Vec3 down = -foot.normal;
    double lowest = 0;
    for (const Vec3& point : region.points()) lowest = std::max(lowest, down.dot(point - centre));
    const double from = lowest - graze;
    if (!(from > graze)) return radius + foot.distance_mm;
    const auto none_allowed = [](std::uint32_t) { return false; };
    const BallCap rest{centre, radius + Tolerance::kRounding_mm, -down, -from};
    if (find_in_cap(in_.boundary(), rest, none_allowed)) return radius + foot.distance_mm;
    return graze * radius / from;
  }

  /// Cuts the piece along the outline of the nearest facet, if the part over the facet is large enough. Otherwise
  /// halves it.
  [[nodiscard]] std::vector<ConvexRegion> parts_of(const Region& piece) const {
    if (piece.is_over_face) {
      std::vector<ConvexRegion> parts = cut_along(piece, in_.boundary().corners(piece.nearest));
      if (parts.size() > 1 && parts.front().area_mm2() >= kMinShare * piece.area_mm2()) return parts;
    }
    return halves(piece);
  }

  const ClashBody& of_;
  const ClashBody& in_;
  Vec3 shift_;
  SearchGoal goal_;
  BodyDepth best_;

  friend class BestFirstSearch<DepthSearch, Region>;
};

}  // namespace

BodyDepth find_body_depth(const ClashBody& of, const ClashBody& in, const Vec3& shift, const SearchGoal& goal) {
  return DepthSearch(of, in, shift, goal).run_all();
}

}  // namespace gouge
