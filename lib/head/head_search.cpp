#include "lib/head/head_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/geom/triangle.h"
#include "lib/head/plane_bound.h"
#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxKept = 8;        // maximum number of planes
constexpr std::size_t kMaxNew = 2;         // maximum number of planes that one region adds
constexpr double kHardlyDeeper_mm = 2e-8;  // more than the rounding of a facet's plane (support_planes.cpp)
constexpr double kFacetsOwn = 1 - Tolerance::kFewRoundings;  // cosine: rounding of a facet's normal
constexpr double kSameNormal = 0.9999;  // cosine: a second plane with nearly the same normal gives no better bound

/// A node or leaf of a tree, or a piece of a facet, during a time interval.
struct Candidate : SearchCandidate {
  enum class Kind : std::uint8_t { root, node, leaf, facet };
  Kind kind = Kind::node;
  bool is_time_next = false;
  std::uint32_t interval = 0, tree = 0, index = 0;  ///< `index` is that of the node, leaf or triangle
  std::uint32_t parent = 0, lane = 0;  ///< for a node or leaf except the root: its parent node, and its lane there
  std::uint32_t facet = 0;             ///< facet of the head closest to the middle; initially that of the candidate it
                                       ///< is a part of
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< corners of the piece of a facet
};

class HeadSearch : public BestFirstSearch<HeadSearch, Candidate> {
 public:
  // If the search descended, it would measure other points first, and another of equally deep points would become the
  // witness.
  static constexpr bool kDescends = false;

  HeadSearch(const BodyMotion& motion, const HeadBody& head, std::span<const HeadTarget> targets,
             const SearchGoal& goal)
      : motion_(motion), intervals_(motion, motion.motion()), head_(head), targets_(targets), goal_(goal) {}

  HeadResult find() {
    for (std::uint32_t s = 0; s < intervals_.segments(); ++s) {
      for (std::uint32_t k = 0; k < targets_.size(); ++k) {
        Candidate root;
        root.kind = Candidate::Kind::root;
        root.interval = s;
        root.tree = k;
        if (!targets_[k].tree->nodes.empty()) add_node(root);
      }
    }
    return finish();
  }

  HeadResult find(const SearchStart& start) {
    prune(start.certified_mm);
    std::uint32_t facet = 0;
    for (const SearchSeed& seed : start.seeds) {
      for (std::uint32_t s = 0; s < intervals_.segments(); ++s)
        facet = add_piece(s, seed.target, seed.triangle, targets_[seed.target].tree->corners(seed.triangle), facet);
    }
    return finish();
  }

  [[nodiscard]] double threshold_mm() const { return goal_.pruning_threshold_mm(result_.depth_mm); }
  [[nodiscard]] bool is_exhausted() const { return result_.bounds >= goal_.budget; }

  void split(const Candidate& c) {
    if (c.is_time_next) {
      const std::uint32_t half = intervals_.halve(c.interval);
      for (std::uint32_t k = 0; k < 2; ++k) {
        if (c.kind == Candidate::Kind::facet) {
          add_piece(half + k, c.tree, c.index, c.piece, c.facet);
        } else {
          Candidate part = c;
          part.interval = half + k;
          add_node(part);
        }
      }
    } else if (c.kind == Candidate::Kind::facet) {
      for (const std::array<Vec3, 3>& half : halves(c.piece, longest_edge(c.piece)))
        add_piece(c.interval, c.tree, c.index, half, c.facet);
    } else {
      open(c);
    }
  }

 private:
  HeadResult finish() {
    result_.depth_upper_mm = std::max(run(), result_.depth_mm);
    return result_;
  }

  void open(const Candidate& c) {
    const BlockTree& tree = *targets_[c.tree].tree;
    if (c.kind == Candidate::Kind::leaf) {
      const TriangleBlock& leaf = tree.leaves[c.index];
      for (std::size_t k = 0; k < leaf.count; ++k)
        add_piece(c.interval, c.tree, leaf.triangle[k], tree.corners(leaf.triangle[k]), c.facet);
      return;
    }
    const NodeBlock& node = tree.nodes[c.index];
    for (std::uint32_t lane = 0; lane < node.count; ++lane) {
      Candidate child;
      child.kind = node.has_leaves ? Candidate::Kind::leaf : Candidate::Kind::node;
      child.interval = c.interval;
      child.tree = c.tree;
      child.index = node.child[lane];
      child.parent = c.index;
      child.lane = lane;
      child.facet = c.facet;
      add_node(child);
    }
  }

  [[nodiscard]] LaneBound bound_of(const Candidate& c) const {
    const BlockTree& tree = *targets_[c.tree].tree;
    return c.kind == Candidate::Kind::root ? LaneBound(tree) : LaneBound(tree, tree.nodes[c.parent], c.lane);
  }

  /// Bounds and offers a node. Requires a candidate that is complete except for its bound and its next step.
  void add_node(Candidate& c) {
    const BodyInterval& interval = intervals_[c.interval];
    const LaneBound held = bound_of(c);
    const double far_mm = interval.to_tool0.point(held.center).norm() + held.radius_mm;
    if (bound(c, NodeRegion(held, interval.to_tool0, interval.to_tool1, motion_.bulge_mm(interval, far_mm)))) offer(c);
  }

  /// Bounds and offers a piece. `facet` is a facet of the head near the piece. Returns the facet closest to it.
  std::uint32_t add_piece(std::uint32_t index, std::uint32_t tree, std::uint32_t triangle,
                          const std::array<Vec3, 3>& piece, std::uint32_t facet) {
    const BodyInterval& interval = intervals_[index];
    std::array<Vec3, 6> corners;
    double far_mm = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = interval.to_tool0.point(piece[k]);
      corners[k + 3] = interval.to_tool1.point(piece[k]);
      far_mm = std::max(far_mm, corners[k].norm());
    }
    Candidate c;
    c.kind = Candidate::Kind::facet;
    c.interval = index;
    c.tree = tree;
    c.index = triangle;
    c.piece = piece;
    c.facet = facet;
    if (!bound(c, PieceRegion(corners, motion_.bulge_mm(interval, far_mm)))) return facet;
    if (c.upper_mm > threshold_mm()) try_points(c, (piece[0] + piece[1] + piece[2]) / 3.0);
    offer(c);
    return c.facet;
  }

  /// Bounds the depth of a region. Returns false if the region stays out of the head's box. The first bounds come from
  /// planes that bounded other regions. The next is the signed distance of the middle, which changes by at most the
  /// distance moved. The last are planes near the middle.
  template <typename Region>
  [[nodiscard]] bool bound(Candidate& c, const Region& region) {
    const double reach_mm = targets_[c.tree].reach_mm;
    if (head_.box.exteriorDistance(region.middle) >= region.radius_mm + reach_mm + Tolerance::kRounding_mm)
      return false;
    ++result_.bounds;
    c.upper_mm = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < plane_count_ && c.upper_mm > threshold_mm(); ++k)
      c.upper_mm = std::min(c.upper_mm, depth_by_support(region, raised(planes_[k].plane, reach_mm)));
    if (c.upper_mm > threshold_mm()) bound_by_pairs(c, region, plane_count_);
    if (c.upper_mm > threshold_mm()) bound_by_foot(c, region);
    c.is_time_next = region.travel_mm > 2 * region.size_mm && intervals_.can_halve(c.interval);
    return true;
  }

  template <typename Region>
  void bound_by_foot(Candidate& c, const Region& region) {
    const ClosestPoint foot = head_.surface.closest_point_from(region.middle, c.facet);
    c.facet = foot.triangle;
    c.upper_mm =
        std::min(c.upper_mm, targets_[c.tree].reach_mm + region.radius_mm - foot.signed_mm() + Tolerance::kRounding_mm);
    if (c.upper_mm <= threshold_mm()) return;
    bound_by_planes(c, region, foot);
    if (c.upper_mm > threshold_mm()) bound_by_pairs(c, region, kMaxNew);
  }

  /// Bounds a piece by two kept planes at a time, one of which is among the first `firsts`. Deep in a head several faces
  /// are about equally near. Pairs that cannot discard the piece are left out. Before a gouge is known, a piece that may
  /// be deeper than the tolerance is kept, so that a gouge within the resolution is still found.
  void bound_by_pairs(Candidate& c, const PieceRegion& region, std::size_t firsts) const {
    const bool is_gouge = result_.depth_mm > goal_.tolerance_mm;
    const double reach_mm = targets_[c.tree].reach_mm, enough_mm = is_gouge ? threshold_mm() : goal_.tolerance_mm;
    std::array<CornerDepths, kMaxKept> depths;
    for (std::size_t k = 0; k < plane_count_; ++k)
      depths[k] = corner_depths(region, raised(planes_[k].plane, reach_mm));
    for (std::size_t a = 0; a < std::min(firsts, plane_count_); ++a) {
      for (std::size_t b = a + 1; b < plane_count_; ++b) {
        if (least_depth(depths[a], depths[b]) > enough_mm) continue;
        const double depth_mm = depth_by_two_supports(region, depths[a], depths[b]);
        if (is_gouge || depth_mm <= enough_mm) c.upper_mm = std::min(c.upper_mm, depth_mm);
        if (depth_mm <= enough_mm) return;
      }
    }
  }
  void bound_by_pairs(Candidate& /*c*/, const NodeRegion& /*region*/, std::size_t /*firsts*/) const {}

  /// Uses a facet's own plane first, if it bounds the whole head: then no other prism on the facet gives a better
  /// bound.
  template <typename Region>
  void bound_by_plane(Candidate& c, const Region& region, const ClosestPoint& at, bool is_middle_inside) {
    const auto support = head_.supports.plane(at.triangle);
    if (support) {
      keep_plane(at.triangle, *support);
      c.upper_mm = std::min(c.upper_mm, depth_by_support(region, raised(*support, targets_[c.tree].reach_mm)));
      if (c.upper_mm <= threshold_mm() || at.normal.dot(support->normal) > kFacetsOwn) return;
    }
    // A prism shows only that points are outside, not how far.
    if (targets_[c.tree].reach_mm > 0) return;
    const auto depth_mm = depth_by_plane(head_, region, HeadPlane(at), is_middle_inside, threshold_mm());
    if (depth_mm) c.upper_mm = std::min(c.upper_mm, *depth_mm);
  }

  void bound_by_planes(Candidate& c, const NodeRegion& region, const ClosestPoint& foot) {
    bound_by_plane(c, region, foot, foot.is_inside);
  }
  /// Bounds a piece by up to two planes. The plane at the closest point to the middle may leave too large a bound, for
  /// example across an edge of the head. Then the plane at the closest point to the lowest corner may give a smaller
  /// one.
  void bound_by_planes(Candidate& c, const PieceRegion& region, const ClosestPoint& foot) {
    bound_by_plane(c, region, foot, foot.is_inside);
    if (c.upper_mm <= threshold_mm()) return;
    const Vec3 lowest = region.lowest(foot.normal);
    const ClosestPoint other = head_.surface.closest_point_from(lowest, c.facet);
    if (other.normal.dot(foot.normal) < kSameNormal) bound_by_plane(c, region, other, foot.is_inside);
  }

  /// Keeps a plane for the next regions, because neighbouring regions are bounded by the same planes.
  void keep_plane(std::uint32_t facet, const OuterPlane& plane) {
    std::size_t at = 0;
    while (at < plane_count_ && planes_[at].facet != facet) ++at;
    if (at == plane_count_) {
      at = std::min(plane_count_, planes_.size() - 1);
      plane_count_ = at + 1;
      planes_[at] = {facet, plane};
    }
    const auto place = planes_.begin() + static_cast<std::ptrdiff_t>(at);
    std::rotate(planes_.begin(), place, place + 1);
  }

  /// Returns the plane raised by the reach. The whole head is below the plane, so the distance of a point above it from
  /// the head is at least its height.
  static OuterPlane raised(OuterPlane plane, double reach_mm) {
    plane.height_mm += reach_mm;
    return plane;
  }

  /// Returns a depth that is not worth a search. Neighbouring pieces share corners, so the deepest known point is tried
  /// again and again.
  [[nodiscard]] double no_deeper_mm() const { return result_.depth_mm + (result_.has_witness ? kHardlyDeeper_mm : 0); }

  /// Returns whether a kept plane proves that a point is hardly deeper than the deepest known point.
  [[nodiscard]] bool is_no_deeper(const Vec3& q, double reach_mm) const {
    return std::any_of(
        planes_.begin(), planes_.begin() + static_cast<std::ptrdiff_t>(plane_count_),
        [&](const Kept& kept) { return reach_mm + kept.plane.height_mm - kept.plane.normal.dot(q) <= no_deeper_mm(); });
  }

  void try_points(const Candidate& c, const Vec3& centre) {
    const BodyInterval& interval = intervals_[c.interval];
    const double reach_mm = targets_[c.tree].reach_mm;
    for (const Vec3& p : {centre, c.piece[0], c.piece[1], c.piece[2]}) {
      for (const double t : {interval.t0, interval.t1}) {
        const RigidTransform& to_tool = t > interval.t0 ? interval.to_tool1 : interval.to_tool0;
        const Vec3 q = to_tool.point(p);
        if (is_no_deeper(q, reach_mm)) continue;
        const double near2_mm2 = closest_on_triangle(q, head_.surface.corners(c.facet)).distance2_mm2;
        if (!(reach_mm > 0) && near2_mm2 <= no_deeper_mm() * no_deeper_mm()) continue;
        const ClosestPoint foot = head_.surface.closest_point_from(q, c.facet);
        if (const auto support = head_.supports.plane(foot.triangle)) keep_plane(foot.triangle, *support);
        const double value_mm = reach_mm - foot.signed_mm();
        if (value_mm <= result_.depth_mm) continue;
        result_.depth_mm = value_mm;
        result_.has_witness = true;
        result_.t = t;
        result_.point = p;
        result_.normal = -to_tool.inverse().direction(foot.normal);
        result_.target = c.tree;
        result_.triangle = c.index;
      }
    }
  }

  const BodyMotion& motion_;
  IntervalTree<BodyInterval, BodyMotion> intervals_;
  const HeadBody& head_;
  std::span<const HeadTarget> targets_;
  const SearchGoal& goal_;
  HeadResult result_;
  struct Kept {
    std::uint32_t facet = 0;
    OuterPlane plane;
  };
  std::array<Kept, kMaxKept> planes_;  // the plane that was useful last comes first
  std::size_t plane_count_ = 0;
};

}  // namespace

HeadResult search_head(const BodyMotion& motion, const HeadBody& head, std::span<const HeadTarget> targets,
                       const SearchGoal& goal) {
  return HeadSearch(motion, head, targets, goal).find();
}

HeadResult search_head(const BodyMotion& motion, const HeadBody& head, std::span<const HeadTarget> targets,
                       const SearchGoal& goal, const SearchStart& start) {
  if (!start.seeds.empty()) return HeadSearch(motion, head, targets, goal).find(start);
  HeadResult result;
  result.depth_upper_mm = std::max(0.0, start.certified_mm);
  return result;
}

}  // namespace gouge
