#include "lib/contact/left_stock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lib/base/best_first_search.h"
#include "lib/geom/triangle.h"
#include "lib/hierarchy/closest_triangle.h"

namespace gouge {
namespace {

constexpr double kBorderShare = 0.02, kMaxBorder_mm = 0.1;  // share of the cutter's radius
constexpr double kMinShare = 0.1;                           // share of the border: a smaller piece stays undecided
constexpr double kFirstPiece_mm = 8;                        // maximum length of a piece
// Points nearer to a gouge than kMaxRim_mm count as not finished. The surface must be within kNearRim of a queried
// place.
constexpr double kMaxRim_mm = 0.5, kNearRim = 0.25;
constexpr double kSure_mm = 1e-3;  // a point this much deeper than finished surface is certainly gouged
constexpr double kRelativeGap = 0.1, kStockGap_mm = 0.01;
constexpr double kBeyond_mm = 1e-3;  // width of the range if only a comparison with the distance is needed

double longest_mm(const SidedPiece& at) {
  const std::size_t k = longest_edge(at.corners);
  return (at.corners[(k + 1) % 3] - at.corners[k]).norm();
}

Vec3 middle_of(const SidedPiece& at) { return (at.corners[0] + at.corners[1] + at.corners[2]) / 3.0; }

/// A piece whose points may be finished, and on which up to upper_mm of stock may be left.
struct Candidate : SearchCandidate {
  SidedPiece at;
  SweepHint finished, gouged;
  std::array<SweepHint, std::tuple_size_v<SweepsAfter>> covered, nearest;
  std::size_t first = 0;  ///< index of the sweep that probably has a cut near the piece

  [[nodiscard]] std::size_t work() const {
    std::size_t all = finished.work + gouged.work;
    for (std::size_t i = 0; i < nearest.size(); ++i) all += covered[i].work + nearest[i].work;
    return all;
  }
};

/// Best-first search: the piece that may have the most stock is examined, sampled in its middle and halved.
class Finder : public BestFirstSearch<Finder, Candidate> {
 public:
  static constexpr bool kDescends = true;

  Finder(const BlockTree& parts, const CutterSweep& before, const SweepsAfter& after, const StockLimits& limits)
      : parts_(parts), before_(before), after_(after), limits_(limits) {
    border_mm_ = std::min(kMaxBorder_mm, kBorderShare * before.min_radius_mm());
    // A ball that is hardly deeper than finished surface reaches the finished height again within this distance.
    rim_mm_ = std::min(kMaxRim_mm, 2 * std::sqrt(before.min_radius_mm() * limits.finished_mm));
    is_convex_ =
        std::ranges::all_of(after, [](const CutterSweep* sweep) { return sweep == nullptr || sweep->is_convex(); });
  }

  /// Returns whether cutters of `before` may finish points of the piece.
  [[nodiscard]] bool may_be_finished(const SidedPiece& at, SweepHint& hint) const {
    return before_.may_reach(at, limits_.finished_mm + border_mm_, border_mm_, hint);
  }

  /// Returns the same for a ball around the surface, from either side.
  [[nodiscard]] bool may_be_finished(const Vec3& centre, double radius_mm, SweepHint& hint) const {
    const double near = radius_mm + limits_.finished_mm;
    return before_.distance(centre, near, near + kBeyond_mm, hint) <= near;
  }

  void add(const SidedPiece& at, const SweepHint& finished) {
    Candidate candidate;
    candidate.upper_mm = std::numeric_limits<double>::infinity();
    candidate.at = at;
    candidate.finished = finished;
    offer(candidate);
  }

  [[nodiscard]] std::optional<LeftStock> search() {
    run();
    if (const Candidate* const open = undecided()) give_up(open->at, open->upper_mm);
    if (undecided_mm_ <= threshold_mm()) return left_;
    if (!left_) return LeftStock{limits_.allowed_mm, false, false, undecided_, kNone};
    left_->is_more = true;
    return left_;
  }

  /// Returns the thickness above which a piece must be examined: slightly more than the largest rest found so far.
  [[nodiscard]] double threshold_mm() const {
    if (!is_found()) return limits_.allowed_mm;
    return left_->is_more ? limits_.max_mm + kFirstPiece_mm : left_->thickness_mm * (1 + kRelativeGap) + kStockGap_mm;
  }

  [[nodiscard]] bool is_exhausted() const {
    return work_ >= limits_.max_work || (is_found() && work_ - work_until_left_ >= limits_.max_work_once_left);
  }

  void split(const Candidate& candidate) {
    Candidate next = candidate;
    const std::size_t before = next.work();
    const bool may_be_left = look(next);
    work_ += next.work() - before;
    const SidedPiece& at = candidate.at;
    if (!may_be_left || next.upper_mm <= threshold_mm()) return;
    if (longest_mm(at) <= kMinShare * border_mm_) return give_up(at, next.upper_mm);
    for (const auto& half : halves(at.corners, longest_edge(at.corners))) {
      next.at.corners = half;
      offer(next);
    }
  }

 private:
  [[nodiscard]] bool is_found() const { return left_.has_value(); }

  /// Records that the piece stays undecided: up to `max_mm` of stock may be left there.
  void give_up(const SidedPiece& at, double max_mm) {
    if (max_mm <= undecided_mm_) return;
    undecided_mm_ = max_mm;
    undecided_ = middle_of(at);
  }

  /// Bounds the rest of stock on a piece, and measures it in the middle. Returns false if nothing above the threshold
  /// is left.
  [[nodiscard]] bool look(Candidate& candidate) {
    const SidedPiece& at = candidate.at;
    const double threshold = threshold_mm();
    if (!may_be_finished(at, candidate.finished)) return false;
    const Vec3 middle = middle_of(at);
    double radius = 0;
    for (const Vec3& corner : at.corners) radius = std::max(radius, (corner - middle).norm());
    if (is_gouged(candidate, middle, radius)) return false;
    const bool is_rim_likely = was_at_rim_;
    if (is_rim_likely && is_at_rim(candidate, middle, radius)) return false;
    // A piece that is too large to be covered by the cut at its middle needs only a larger rest there.
    const double covering = threshold - radius, left = is_found() ? left_->thickness_mm : limits_.allowed_mm;
    const double enough = covering > 0 ? covering : left;
    const double away = away_from_cuts(candidate, middle, enough);
    // A cutter that covers the piece covers its middle too.
    if (away <= covering || (away <= threshold && is_covered(candidate, threshold))) {
      was_at_rim_ = false;
      return false;
    }
    was_at_rim_ = !is_rim_likely && is_at_rim(candidate, middle, radius);
    if (was_at_rim_) return false;
    candidate.upper_mm = std::min(candidate.upper_mm, away + radius);
    if (away <= left) return true;
    const Vec3 finished = middle + limits_.finished_mm * at.outward;
    const std::size_t move = before_.covering_move({&finished, 1}, candidate.finished);
    if (move == kNone || is_at_rim(candidate, middle, 0)) return true;
    if (!is_found()) work_until_left_ = work_;
    left_ = LeftStock{std::min(away, limits_.max_mm), away >= limits_.max_mm, true, middle, move};
    return true;
  }

  /// Returns whether the gouge at the middle of a piece was so deep that the whole piece was in it, or at its rim. There the cutter went through the surface, so stock that a path without the gouge leaves there was
  /// never finished.
  [[nodiscard]] bool is_gouged(Candidate& candidate, const Vec3& middle, double radius_mm) const {
    const double gouged = limits_.finished_mm + kSure_mm;
    return is_deeper(middle, radius_mm <= rim_mm_ ? gouged : gouged + radius_mm, candidate.gouged);
  }

  /// Returns whether a gouged place is within the rim's width of every point that is within `radius_mm` of the middle.
  [[nodiscard]] bool is_at_rim(Candidate& candidate, const Vec3& middle, double radius_mm) const {
    const double away = rim_mm_ - radius_mm, gouged = limits_.finished_mm + kSure_mm;
    if (away < 0) return false;
    const Vec3 &normal = candidate.at.outward, across = normal.unitOrthogonal(), other = normal.cross(across);
    const double diagonal = std::numbers::sqrt2 / 2;
    const std::array<Vec3, 9> places = {Vec3::Zero(),
                                        across,
                                        other,
                                        -across,
                                        -other,
                                        diagonal * (across + other),
                                        diagonal * (across - other),
                                        -diagonal * (across + other),
                                        diagonal * (other - across)};
    return std::ranges::any_of(places, [&](const Vec3& place) {
      // Beyond an edge there is no surface, but a cutter may be there.
      const auto near = closest_triangle(parts_, middle + away * place, kNearRim * away);
      return near && is_deeper(near->foot.point, gouged, candidate.gouged);
    });
  }

  /// Returns whether a point was at least `depth_mm` inside a cutter.
  [[nodiscard]] bool is_deeper(const Vec3& point, double depth_mm, SweepHint& hint) const {
    return before_.distance(point, -depth_mm, -depth_mm + kBeyond_mm, hint) <= -depth_mm;
  }

  /// Returns whether a single pose of a new cutter covers all of the piece, at a distance of at most `max_mm`.
  [[nodiscard]] bool is_covered(Candidate& candidate, double max_mm) const {
    if (!is_convex_) return false;
    const Vec3 up = max_mm * candidate.at.outward;
    const auto& at = candidate.at.corners;
    const std::array<Vec3, 3> corners = {at[0] + up, at[1] + up, at[2] + up};
    return is_true_of_any(
        candidate, [&](std::size_t i) { return after_[i]->covering_move(corners, candidate.covered[i]) != kNone; });
  }

  /// Returns whether `ask` holds for one of the sweeps after the change, and tries the most likely one first.
  template <typename Ask>
  [[nodiscard]] bool is_true_of_any(Candidate& candidate, const Ask& ask) const {
    for (std::size_t k = 0, i = candidate.first; k < after_.size(); ++k, i = (i + 1) % after_.size()) {
      if (after_[i] == nullptr || !ask(i)) continue;
      candidate.first = i;
      return true;
    }
    return false;
  }

  /// Returns the distance of a surface point from the nearest cut; `lower_cutoff_mm` if it is not more than that.
  [[nodiscard]] double away_from_cuts(Candidate& candidate, const Vec3& point, double lower_cutoff_mm) const {
    double least = limits_.max_mm;
    const bool is_enough = is_true_of_any(candidate, [&](std::size_t i) {
      least = std::min(least, after_[i]->distance(point, lower_cutoff_mm, least, candidate.nearest[i]));
      return least <= lower_cutoff_mm;
    });
    return is_enough ? lower_cutoff_mm : std::max(least, 0.0);
  }

  const BlockTree& parts_;
  const CutterSweep& before_;
  const SweepsAfter& after_;
  StockLimits limits_;
  double border_mm_ = kMaxBorder_mm, rim_mm_ = kMaxRim_mm;
  bool is_convex_ = true;
  std::optional<LeftStock> left_;
  double undecided_mm_ = 0;
  Vec3 undecided_ = Vec3::Zero();
  std::size_t work_ = 0, work_until_left_ = 0;
  bool was_at_rim_ = false;  // how the last piece ended; the next one often ends in the same way
};

/// A source of pieces for a search: the pieces of all triangles that cutters of `before` may finish.
class Gatherer {
 public:
  Gatherer(const BlockTree& tree, Finder& finder, bool are_solids)
      : tree_(tree), finder_(finder), are_solids_(are_solids) {}

  void visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::size_t i = 0; i < node.count; ++i) {
      const Vec3 centre = tree_.origin + Vec3(node.center[0][i], node.center[1][i], node.center[2][i]);
      if (!finder_.may_be_finished(centre, static_cast<double>(node.radius_mm[i]), near_)) continue;
      if (!node.has_leaves) {
        visit(node.child[i]);
        continue;
      }
      const TriangleBlock& leaf = tree_.leaves[node.child[i]];
      for (std::size_t k = 0; k < leaf.count; ++k) add(tree_.corners(leaf.triangle[k]));
    }
  }

 private:
  void add(const std::array<Vec3, 3>& triangle) {
    const Vec3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    if (!(across.norm() > 0)) return;
    const Vec3 middle = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    double radius = 0;
    for (const Vec3& corner : triangle) radius = std::max(radius, (corner - middle).norm());
    if (!finder_.may_be_finished(middle, radius, near_)) return;
    cut({triangle, across.normalized()});
    if (!are_solids_) cut({triangle, -across.normalized()});
  }

  void cut(const SidedPiece& at) {
    if (!finder_.may_be_finished(at, hint_)) return;
    if (longest_mm(at) <= kFirstPiece_mm) return finder_.add(at, hint_);
    for (const auto& half : halves(at.corners, longest_edge(at.corners))) cut({half, at.outward});
  }

  const BlockTree& tree_;
  Finder& finder_;
  bool are_solids_;
  SweepHint hint_, near_;
};

}  // namespace

std::optional<LeftStock> find_left_stock(const BlockTree& parts, const CutterSweep& before, const SweepsAfter& after,
                                         const StockLimits& limits) {
  if (parts.nodes.empty() || before.is_empty()) return std::nullopt;
  Finder finder(parts, before, after, limits);
  Gatherer(parts, finder, limits.are_solids).visit(0);
  return finder.search();
}

}  // namespace gouge
