#include "lib/head/head_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/check/motion_interval.h"
#include "lib/geom/triangle.h"
#include "lib/penetration/closest_point.h"

namespace gouge {
namespace {

constexpr double kUnknown_mm = std::numeric_limits<double>::infinity();
constexpr double kRounding_mm = 1e-9;  // of coordinates up to 100 m and a few additions

struct HeadInterval : MotionInterval {
  HeadInterval(const HeadMotion& motion, const MotionInterval& interval)
      : MotionInterval(interval), to_tool0(motion.at(t0).inverse()), to_tool1(motion.at(t1).inverse()) {}

  RigidTransform to_tool0, to_tool1;
};

/// A node of a surface's tree or a piece of a facet, over a time interval.
struct Candidate : SearchCandidate {
  std::uint32_t interval = 0, surface = 0, index = 0;  ///< node, or slot of a facet
  bool is_facet = false, is_time_next = false;
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

class Search : public BestFirstSearch<Search, Candidate> {
 public:
  // A descent would measure other points first, and which of equally deep ones is the witness would change.
  static constexpr bool kDescends = false;

  Search(const HeadMotion& motion, const HeadBody& head, const std::vector<const DepthBody*>& surfaces,
         const SearchGoal& goal)
      : motion_(motion), intervals_(motion, motion.motion()), head_(head), surfaces_(surfaces), goal_(goal) {}

  HeadResult find() {
    for (std::uint32_t s = 0; s < intervals_.segments(); ++s) {
      for (std::uint32_t k = 0; k < surfaces_.size(); ++k) {
        if (!surfaces_[k]->tree.nodes.empty()) add_node(s, k, 0);
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
        if (c.is_facet) {
          add_piece(half + k, c.surface, c.index, c.piece);
        } else {
          add_node(half + k, c.surface, c.index);
        }
      }
    } else if (c.is_facet) {
      for (const std::array<Vec3, 3>& half : halves(c.piece, longest_edge(c.piece)))
        add_piece(c.interval, c.surface, c.index, half);
    } else {
      open_node(c);
    }
  }

 private:
  void open_node(const Candidate& c) {
    const DepthBody& surface = *surfaces_[c.surface];
    const KdopNode& node = surface.tree.nodes[c.index];
    for (std::uint32_t k = 0; k < node.children; ++k) add_node(c.interval, c.surface, node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k)
      add_piece(c.interval, c.surface, node.first + k, surface.corners[node.first + k]);
  }

  /// Upper bound of the depth over a ball of surface points and the whole interval.
  double bound(const HeadInterval& interval, const Vec3& centre, double radius, double& path_length) {
    ++result_.bounds;
    const Vec3 q0 = interval.to_tool0.point(centre), q1 = interval.to_tool1.point(centre);
    path_length = 0;
    const double s0 = signed_distance(q0);
    if (!(interval.t1 > interval.t0)) return radius - s0 + kRounding_mm;
    path_length = (q1 - q0).norm() + 2 * motion_.bulge_mm(interval.t0, interval.t1, interval.segment, q0.norm());
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
    const std::uint32_t face = closest_point(head_.surface, middle)->triangle;
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

  [[nodiscard]] double signed_distance(const Vec3& q) const { return closest_point(head_.surface, q)->signed_mm(); }

  void add_node(std::uint32_t index, std::uint32_t surface, std::uint32_t node) {
    const float* const box = surfaces_[surface]->boxes.data() + 6 * std::size_t{node};
    const Vec3 low(static_cast<double>(box[0]), static_cast<double>(box[1]), static_cast<double>(box[2]));
    const Vec3 high(static_cast<double>(box[3]), static_cast<double>(box[4]), static_cast<double>(box[5]));
    const double radius = 0.5 * (high - low).norm();
    Candidate c;
    double path_length = 0;
    c.upper_mm = bound(intervals_[index], 0.5 * (low + high), radius, path_length);
    c.interval = index;
    c.surface = surface;
    c.index = node;
    c.is_time_next = path_length > 2 * radius && intervals_.can_halve(index);
    offer(c);
  }

  void add_piece(std::uint32_t index, std::uint32_t surface, std::uint32_t place, const std::array<Vec3, 3>& piece) {
    const Vec3 centre = (piece[0] + piece[1] + piece[2]) / 3.0;
    double radius = 0;
    for (const Vec3& corner : piece) radius = std::max(radius, (corner - centre).norm());
    Candidate c;
    double path_length = 0;
    c.upper_mm = bound(intervals_[index], centre, radius, path_length);
    c.interval = index;
    c.surface = surface;
    c.index = place;
    if (c.upper_mm > threshold_mm()) c.upper_mm = std::min(c.upper_mm, bound_by_face(intervals_[index], piece));
    c.is_facet = true;
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
        const auto foot = closest_point(head_.surface, to_tool.point(p));
        if (!foot->is_inside || foot->distance_mm <= result_.depth_mm) continue;
        result_.depth_mm = foot->distance_mm;
        result_.has_witness = true;
        result_.t = t;
        result_.point = p;
        result_.normal = -to_tool.inverse().direction(foot->normal);
        result_.surface = c.surface;
        result_.triangle = surfaces_[c.surface]->tree.order[c.index];
      }
    }
  }

  const HeadMotion& motion_;
  IntervalTree<HeadInterval, HeadMotion> intervals_;
  const HeadBody& head_;
  const std::vector<const DepthBody*>& surfaces_;
  const SearchGoal& goal_;
  HeadResult result_;
};

}  // namespace

HeadResult search_head(const HeadMotion& motion, const HeadBody& head, const std::vector<const DepthBody*>& surfaces,
                       const SearchGoal& goal) {
  return Search(motion, head, surfaces, goal).find();
}

}  // namespace gouge
