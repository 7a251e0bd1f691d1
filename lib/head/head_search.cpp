#include "lib/head/head_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/penetration/nearest_foot.h"

namespace gouge {
namespace {

constexpr double kShortestSpan = 1e-10;
constexpr double kUnknown_mm = std::numeric_limits<double>::infinity();
constexpr double kRounding_mm = 1e-9;  // of coordinates up to 100 m and a few additions

struct Span {
  double t0 = 0, t1 = 1;
  std::uint32_t stretch = 0;
  RigidTransform to_tool0, to_tool1;
  std::int32_t half = -1;  ///< first of two, once halved
};

struct Candidate {
  double upper_mm = 0;
  std::uint64_t serial = 0;
  std::uint32_t span = 0, surface = 0, index = 0;  ///< node, or place of a facet
  bool is_facet = false, is_time_next = false;
  std::array<Vec3, 3> piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

bool comes_later(const Candidate& a, const Candidate& b) {
  return a.upper_mm < b.upper_mm || (!(b.upper_mm < a.upper_mm) && a.serial > b.serial);
}

class Search {
 public:
  Search(const HeadMotion& motion, const HeadBody& head, const std::vector<const DepthBody*>& surfaces,
         const HeadQuestion& question)
      : motion_(motion), head_(head), surfaces_(surfaces), question_(question) {}

  HeadAnswer run() {
    const Motion& motion = motion_.motion();
    for (std::uint32_t s = 0; s < motion.stretches().size(); ++s) {
      const TipStretch& stretch = motion.stretches()[s];
      const std::uint32_t span = add_span(stretch.t0, motion.is_alone() ? stretch.t0 : stretch.t1, s);
      for (std::uint32_t k = 0; k < surfaces_.size(); ++k) {
        if (!surfaces_[k]->tree.nodes.empty()) add_node(span, k, 0);
      }
    }
    while (!open_.empty()) {
      std::pop_heap(open_.begin(), open_.end(), comes_later);
      const Candidate next = open_.back();
      if (next.upper_mm <= settled() || answer_.bounds >= question_.budget) {
        settled_mm_ = std::max(settled_mm_, next.upper_mm);
        break;
      }
      open_.pop_back();
      expand(next);
    }
    answer_.depth_upper_mm = std::max(answer_.depth_mm, settled_mm_);
    return answer_;
  }

 private:
  /// Candidates whose bound is not above this need no further look.
  [[nodiscard]] double settled() const {
    if (answer_.depth_mm > question_.tolerance_mm)
      return answer_.depth_mm + std::max(question_.resolution_mm, question_.gap_mm);
    return question_.tolerance_mm + question_.resolution_mm;
  }

  std::uint32_t add_span(double t0, double t1, std::uint32_t stretch) {
    spans_.push_back({t0, t1, stretch, motion_.at(t0).inverse(), motion_.at(t1).inverse(), -1});
    return static_cast<std::uint32_t>(spans_.size() - 1);
  }

  /// Upper bound of the depth over a ball of surface points and the whole span.
  double bound(const Span& span, const Vec3& centre, double radius, double& way) {
    ++answer_.bounds;
    const Vec3 q0 = span.to_tool0.point(centre), q1 = span.to_tool1.point(centre);
    way = 0;
    const double s0 = signed_distance(q0);
    if (!(span.t1 > span.t0)) return radius - s0 + kRounding_mm;
    way = (q1 - q0).norm() + 2 * motion_.bulge_mm(span.t0, span.t1, span.stretch, q0.norm());
    return radius + 0.5 * (way - s0 - signed_distance(q1)) + kRounding_mm;
  }

  /// Where all of the piece, at both ends of the span and `bulge` around, lies over one flat patch of the
  /// head, or over one face of it, and no higher than it is clear, what is above the plane is outside, and
  /// what is below is no deeper than that: a linear function, so its corners tell.
  [[nodiscard]] double bound_by_face(const Span& span, const std::array<Vec3, 3>& piece) const {
    std::array<Vec3, 6> q;
    double far = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      q[k] = span.to_tool0.point(piece[k]);
      q[k + 3] = span.to_tool1.point(piece[k]);
      far = std::max(far, q[k].norm());
    }
    const Vec3 middle = (q[0] + q[1] + q[2] + q[3] + q[4] + q[5]) / 6.0;
    const std::uint32_t face = nearest_foot(head_.surface, middle)->triangle;
    const double bulge = span.t1 > span.t0 ? motion_.bulge_mm(span.t0, span.t1, span.stretch, far) : 0;
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

  [[nodiscard]] double signed_distance(const Vec3& q) const {
    return nearest_foot(head_.surface, q)->signed_mm();
  }

  void offer(Candidate c) {
    if (c.upper_mm <= settled()) {
      settled_mm_ = std::max(settled_mm_, c.upper_mm);
      return;
    }
    c.serial = serial_++;
    open_.push_back(c);
    std::push_heap(open_.begin(), open_.end(), comes_later);
  }

  void add_node(std::uint32_t span, std::uint32_t surface, std::uint32_t node) {
    const float* const box = surfaces_[surface]->boxes.data() + 6 * std::size_t{node};
    const Vec3 low(static_cast<double>(box[0]), static_cast<double>(box[1]), static_cast<double>(box[2]));
    const Vec3 high(static_cast<double>(box[3]), static_cast<double>(box[4]), static_cast<double>(box[5]));
    const double radius = 0.5 * (high - low).norm();
    Candidate c;
    double way = 0;
    c.upper_mm = bound(spans_[span], 0.5 * (low + high), radius, way);
    c.span = span;
    c.surface = surface;
    c.index = node;
    c.is_time_next = way > 2 * radius && can_halve(span);
    offer(c);
  }

  void add_piece(std::uint32_t span, std::uint32_t surface, std::uint32_t place,
                 const std::array<Vec3, 3>& piece) {
    const Vec3 centre = (piece[0] + piece[1] + piece[2]) / 3.0;
    double radius = 0;
    for (const Vec3& corner : piece) radius = std::max(radius, (corner - centre).norm());
    Candidate c;
    double way = 0;
    c.upper_mm = bound(spans_[span], centre, radius, way);
    c.span = span;
    c.surface = surface;
    c.index = place;
    if (c.upper_mm > settled()) c.upper_mm = std::min(c.upper_mm, bound_by_face(spans_[span], piece));
    c.is_facet = true;
    c.piece = piece;
    c.is_time_next = way > 2 * radius && can_halve(span);
    if (c.upper_mm > settled()) try_points(c, centre);
    offer(c);
  }

  void try_points(const Candidate& c, const Vec3& centre) {
    const Span& span = spans_[c.span];
    for (const Vec3& p : {centre, c.piece[0], c.piece[1], c.piece[2]}) {
      for (const double t : {span.t0, span.t1}) {
        const RigidTransform& to_tool = t > span.t0 ? span.to_tool1 : span.to_tool0;
        const auto foot = nearest_foot(head_.surface, to_tool.point(p));
        if (!foot->is_inside || foot->distance_mm <= answer_.depth_mm) continue;
        answer_.depth_mm = foot->distance_mm;
        answer_.has_witness = true;
        answer_.t = t;
        answer_.point = p;
        answer_.normal = -to_tool.inverse().direction(foot->normal);
        answer_.surface = c.surface;
        answer_.triangle = surfaces_[c.surface]->tree.order[c.index];
      }
    }
  }

  [[nodiscard]] bool can_halve(std::uint32_t span) const {
    return spans_[span].t1 - spans_[span].t0 > kShortestSpan;
  }

  std::uint32_t halve(std::uint32_t index) {
    if (spans_[index].half < 0) {
      const Span span = spans_[index];
      const double middle = 0.5 * (span.t0 + span.t1);
      const std::uint32_t first = add_span(span.t0, middle, span.stretch);
      add_span(middle, span.t1, span.stretch);
      spans_[index].half = static_cast<std::int32_t>(first);
    }
    return static_cast<std::uint32_t>(spans_[index].half);
  }

  void expand(const Candidate& c) {
    if (c.is_time_next) {
      const std::uint32_t half = halve(c.span);
      for (std::uint32_t k = 0; k < 2; ++k) {
        if (c.is_facet) {
          add_piece(half + k, c.surface, c.index, c.piece);
        } else {
          add_node(half + k, c.surface, c.index);
        }
      }
      return;
    }
    if (c.is_facet) return halve_piece(c);
    const DepthBody& surface = *surfaces_[c.surface];
    const KdopNode& node = surface.tree.nodes[c.index];
    for (std::uint32_t k = 0; k < node.children; ++k) add_node(c.span, c.surface, node.first + k);
    for (std::uint32_t k = 0; node.children == 0 && k < node.item_count; ++k)
      add_piece(c.span, c.surface, node.first + k, surface.corners[node.first + k]);
  }

  void halve_piece(const Candidate& c) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      const double length = (c.piece[(k + 1) % 3] - c.piece[k]).squaredNorm();
      if (length > (c.piece[(longest + 1) % 3] - c.piece[longest]).squaredNorm()) longest = k;
    }
    const Vec3 middle = 0.5 * (c.piece[longest] + c.piece[(longest + 1) % 3]);
    for (const std::size_t moved : {longest, (longest + 1) % 3}) {
      std::array<Vec3, 3> half = c.piece;
      half[moved] = middle;
      add_piece(c.span, c.surface, c.index, half);
    }
  }

  const HeadMotion& motion_;
  const HeadBody& head_;
  const std::vector<const DepthBody*>& surfaces_;
  const HeadQuestion& question_;
  std::vector<Span> spans_;
  std::vector<Candidate> open_;
  std::uint64_t serial_ = 0;
  double settled_mm_ = 0;
  HeadAnswer answer_;
};

}  // namespace

HeadAnswer search_head(const HeadMotion& motion, const HeadBody& head,
                       const std::vector<const DepthBody*>& surfaces, const HeadQuestion& question) {
  return Search(motion, head, surfaces, question).run();
}

}  // namespace gouge
