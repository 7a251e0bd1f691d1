#include "lib/head/head_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "lib/geom/triangle.h"
#include "lib/hierarchy/lane_bound.h"

namespace gouge {
namespace {

constexpr double kUnknown_mm = std::numeric_limits<double>::infinity();
constexpr double kRounding_mm = 1e-9;  // of coordinates up to 100 m and a few additions

/// A node or leaf of a tree or a piece of a facet, over a time interval.
struct Candidate : SearchCandidate {
  enum class Kind : std::uint8_t { node, leaf, facet };
  Kind kind = Kind::node;
  bool is_time_next = false;
  std::uint32_t interval = 0, tree = 0, index = 0;  ///< of the node, leaf or triangle
  /// Of a facet; else the centre of a ball around what it holds, and its radius.
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double radius_mm = 0;
};

class Search : public BestFirstSearch<Search, Candidate> {
 public:
  // A descent would measure other points first, and which of equally deep ones is the witness would change.
  static constexpr bool kDescends = false;

  Search(const HeadMotion& motion, const HeadBody& head, std::span<const BlockTree* const> trees,
         const SearchGoal& goal)
      : motion_(motion), intervals_(motion, motion.motion()), head_(head), trees_(trees), goal_(goal) {}

  HeadResult find() {
    for (std::uint32_t s = 0; s < intervals_.segments(); ++s) {
      for (std::uint32_t k = 0; k < trees_.size(); ++k) {
        if (!trees_[k]->nodes.empty())
          add_ball(s, k, Candidate::Kind::node, 0, trees_[k]->origin, trees_[k]->radius_mm);
      }
    }
    result_.depth_upper_mm = std::max(run(), result_.depth_mm);
    return result_;
  }

  [[nodiscard]] double threshold_mm() const { return goal_.pruning_threshold_mm(result_.depth_mm); }
  [[nodiscard]] bool is_exhausted() const { return result_.bounds >= goal_.budget; }

  void split(const Candidate& c) {
    if (c.is_time_next) {
      const std::uint32_t half = intervals_.halve(c.interval);
      for (std::uint32_t k = 0; k < 2; ++k) {
        if (c.kind == Candidate::Kind::facet) {
          add_piece(half + k, c.tree, c.index, c.piece);
        } else {
          add_ball(half + k, c.tree, c.kind, c.index, c.piece[0], c.radius_mm);
        }
      }
    } else if (c.kind == Candidate::Kind::facet) {
      for (const std::array<Vec3, 3>& half : halves(c.piece, longest_edge(c.piece)))
        add_piece(c.interval, c.tree, c.index, half);
    } else {
      open(c);
    }
  }

 private:
  void open(const Candidate& c) {
    const BlockTree& tree = *trees_[c.tree];
    if (c.kind == Candidate::Kind::leaf) {
      const TriangleBlock& leaf = tree.leaves[c.index];
      for (std::size_t k = 0; k < leaf.count; ++k)
        add_piece(c.interval, c.tree, leaf.triangle[k], tree.corners(leaf.triangle[k]));
      return;
    }
    const NodeBlock& node = tree.nodes[c.index];
    for (std::size_t lane = 0; lane < node.count; ++lane) {
      const LaneBound bound(tree, node, lane);
      const Candidate::Kind kind = node.has_leaves ? Candidate::Kind::leaf : Candidate::Kind::node;
      add_ball(c.interval, c.tree, kind, node.child[lane], bound.center, bound.radius_mm);
    }
  }

  /// Whether the ball stays out of the head's box at both ends of the interval, and between them: then nothing in it
  /// enters the head, and no query is needed to know.
  [[nodiscard]] bool is_beside(const HeadInterval& interval, const Vec3& centre, double radius) const {
    const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
    const double out0 = head_.box.exteriorDistance(q0), out1 = head_.box.exteriorDistance(q1);
    if (!(out0 > 0 && out1 > 0)) return false;
    return radius + 0.5 * (path_length_mm(interval, q0, q1) - out0 - out1) + kRounding_mm <= 0;
  }

  /// Not below the length of the path of a point from q0 to q1, in the frame of the tool.
  [[nodiscard]] double path_length_mm(const HeadInterval& interval, const Vec3& q0, const Vec3& q1) const {
    if (!(interval.t1 > interval.t0)) return 0;
    return (q1 - q0).norm() + 2 * motion_.bulge_mm(interval.t0, interval.t1, interval.segment, q0.norm());
  }

  /// Upper bound of the depth over a ball of surface points and the whole interval.
  double bound(const HeadInterval& interval, const Vec3& centre, double radius, double& path_length) {
    ++result_.bounds;
    const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
    path_length = path_length_mm(interval, q0, q1);
    const double s0 = signed_distance(q0);
    if (!(interval.t1 > interval.t0)) return radius - s0 + kRounding_mm;
    return radius + 0.5 * (path_length - s0 - signed_distance(q1)) + kRounding_mm;
  }

  /// Where all of the piece, at both ends of the interval and `bulge` around, lies over one flat patch of the
  /// head, or over one face of it, and no higher than it is clear, what is above the plane is outside, and
  /// what is below is no deeper than that: a linear function, so its corners suffice.
  [[nodiscard]] double bound_by_face(const HeadInterval& interval, const std::array<Vec3, 3>& piece) const {
    std::array<Vec3, 6> q;
    double far = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      q[k] = interval.to_tool0.point(piece[k]);
      q[k + 3] = interval.to_tool1.point(piece[k]);
      far = std::max(far, q[k].norm());
    }
    const Vec3 middle = (q[0] + q[1] + q[2] + q[3] + q[4] + q[5]) / 6.0;
    const std::uint32_t face = head_.surface.closest_point(middle)->triangle;
    const double bulge =
        interval.t1 > interval.t0 ? motion_.bulge_mm(interval.t0, interval.t1, interval.segment, far) : 0;
    const double patch = deepest_below(head_.flat.patches[head_.flat.patch_of[face]], q, bulge);
    return std::min(patch, deepest_below(head_.flat.faces[face], q, bulge)) + bulge + kRounding_mm;
  }

  static double deepest_below(const FlatPatch& patch, const std::array<Vec3, 6>& q, double bulge) {
    const double inside = std::max(bulge + kRounding_mm, patch.rim_mm);
    double deepest = 0;
    for (const Vec3& x : q) {
      if (!(patch.inside_mm(x) >= inside)) return kUnknown_mm;
      const double height = patch.height_mm(x);
      // Higher than is known to be clear, the distance to the plane bounds the depth all the same.
      deepest = std::max(deepest, height + bulge < patch.clear_mm ? -height : std::abs(height));
    }
    return deepest + 2 * patch.off_mm;
  }

  [[nodiscard]] double signed_distance(const Vec3& q) const { return head_.surface.closest_point(q)->signed_mm(); }

  void add_ball(std::uint32_t interval, std::uint32_t tree, Candidate::Kind kind, std::uint32_t index,
                const Vec3& centre, double radius) {
    if (is_beside(intervals_[interval], centre, radius)) return;
    Candidate c;
    double path_length = 0;
    c.upper_mm = bound(intervals_[interval], centre, radius, path_length);
    c.kind = kind;
    c.interval = interval;
    c.tree = tree;
    c.index = index;
    c.piece[0] = centre;
    c.radius_mm = radius;
    c.is_time_next = path_length > 2 * radius && intervals_.can_halve(interval);
    offer(c);
  }

  void add_piece(std::uint32_t index, std::uint32_t tree, std::uint32_t triangle, const std::array<Vec3, 3>& piece) {
    const Vec3 centre = (piece[0] + piece[1] + piece[2]) / 3.0;
    double radius = 0;
    for (const Vec3& corner : piece) radius = std::max(radius, (corner - centre).norm());
    if (is_beside(intervals_[index], centre, radius)) return;
    Candidate c;
    double path_length = 0;
    c.upper_mm = bound(intervals_[index], centre, radius, path_length);
    c.interval = index;
    c.tree = tree;
    c.index = triangle;
    if (c.upper_mm > threshold_mm()) c.upper_mm = std::min(c.upper_mm, bound_by_face(intervals_[index], piece));
    c.kind = Candidate::Kind::facet;
    c.piece = piece;
    c.is_time_next = path_length > 2 * radius && intervals_.can_halve(index);
    if (c.upper_mm > threshold_mm()) try_points(c, centre);
    offer(c);
  }

  void try_points(const Candidate& c, const Vec3& centre) {
    const HeadInterval& interval = intervals_[c.interval];
    for (const Vec3& p : {centre, c.piece[0], c.piece[1], c.piece[2]}) {
      for (const double t : {interval.t0, interval.t1}) {
        const RigidTransform& to_tool = t > interval.t0 ? interval.to_tool1 : interval.to_tool0;
        const auto foot = head_.surface.closest_point(to_tool.point(p));
        if (!foot->is_inside || foot->distance_mm <= result_.depth_mm) continue;
        result_.depth_mm = foot->distance_mm;
        result_.has_witness = true;
        result_.t = t;
        result_.point = p;
        result_.normal = -to_tool.inverse().direction(foot->normal);
        result_.tree = c.tree;
        result_.triangle = c.index;
      }
    }
  }

  const HeadMotion& motion_;
  IntervalTree<HeadInterval, HeadMotion> intervals_;
  const HeadBody& head_;
  std::span<const BlockTree* const> trees_;
  const SearchGoal& goal_;
  HeadResult result_;
};

}  // namespace

HeadResult search_head(const HeadMotion& motion, const HeadBody& head, std::span<const BlockTree* const> trees,
                       const SearchGoal& goal) {
  return Search(motion, head, trees, goal).find();
}

}  // namespace gouge
