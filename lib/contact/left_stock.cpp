#include "lib/contact/left_stock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/geom/triangle.h"

namespace gouge {
namespace {

constexpr double kBorderShare = 0.02, kMostBorder_mm = 0.1;  // of the cutter's radius
constexpr double kLeastShare = 0.1;    // of the border: what is not decided on a piece so small is not decided
constexpr double kSamplePiece_mm = 1;  // the middle of a piece is asked how much is left there if it is no longer
constexpr double kFirstPiece_mm = 8;   // pieces of a triangle that are looked at apart from each other
constexpr int kMostPieces = 100'000;   // of one of those
constexpr double kRelativeGap = 0.02, kGap_mm = 0.005;

double longest_mm(const SidedPiece& at) {
  const std::size_t k = longest_edge(at.corners);
  return (at.corners[(k + 1) % 3] - at.corners[k]).norm();
}

Vec3 middle_of(const SidedPiece& at) { return (at.corners[0] + at.corners[1] + at.corners[2]) / 3.0; }

class Finder {
 public:
  Finder(const CutterSweep& before, std::span<const CutterSweep* const> after, const StockLimits& limits)
      : before_(before), after_(after), limits_(limits) {
    border_mm_ = std::min(kMostBorder_mm, kBorderShare * before.least_radius_mm());
    is_convex_ = std::ranges::all_of(after, [](const CutterSweep* sweep) { return sweep->is_convex(); });
  }

  /// Whether cutters of `before` may finish points of the piece.
  [[nodiscard]] bool may_be_finished(const SidedPiece& at) {
    return before_.may_reach(at, limits_.finished_mm + border_mm_, border_mm_, finished_hint_);
  }

  /// Of a ball about the surface.
  [[nodiscard]] bool may_be_finished(const Vec3& centre, double radius_mm) const {
    const double near = radius_mm + limits_.finished_mm;
    return before_.distance(centre, near, near + 1) <= near;
  }

  void refine(const SidedPiece& at) {
    if (pieces_++ > kMostPieces) return give_up(at);
    if (!may_be_finished(at) || is_covered(at)) return;
    const double longest = longest_mm(at);
    if (longest <= kSamplePiece_mm) {
      const Vec3 middle = middle_of(at);
      double radius = 0;
      for (const Vec3& corner : at.corners) radius = std::max(radius, (corner - middle).norm());
      const double bar = bar_mm();
      const Vec3 lifted = middle + bar * at.outward;
      // Where the middle is cut at the bar only a small piece can be near enough to it.
      if (radius < bar || !is_covered({&lifted, 1})) {
        const double away = away_from_cuts(middle, bar - radius);
        if (away + radius <= bar) return;
        if (away > limits_.allowed_mm && sample(at, middle, away) && away + radius <= bar_mm()) return;
      }
    }
    if (longest <= kLeastShare * border_mm_) return give_up(at);
    for (const auto& half : halves(at.corners, longest_edge(at.corners))) refine({half, at.outward});
  }

  [[nodiscard]] const std::optional<LeftStock>& left() const { return left_; }

 private:
  [[nodiscard]] bool is_found() const { return left_ && !left_->is_undecided; }

  /// As much as was found to be left, and no more than it matters.
  [[nodiscard]] double bar_mm() const {
    if (!is_found()) return limits_.allowed_mm;
    return left_->is_more ? limits_.most_mm + kFirstPiece_mm : left_->thickness_mm * (1 + kRelativeGap) + kGap_mm;
  }

  void give_up(const SidedPiece& at) {
    if (!left_) left_ = LeftStock{limits_.allowed_mm, false, true, middle_of(at), kNone};
  }

  /// Whether one pose of a new cutter is over all of the piece, at the bar or lower.
  [[nodiscard]] bool is_covered(const SidedPiece& at) {
    if (!is_convex_) return false;
    const Vec3 up = bar_mm() * at.outward;
    const std::array<Vec3, 3> corners = {at.corners[0] + up, at.corners[1] + up, at.corners[2] + up};
    return is_covered(corners);
  }

  [[nodiscard]] bool is_covered(std::span<const Vec3> points) {
    covered_hints_.resize(after_.size());
    for (std::size_t i = 0; i < after_.size(); ++i) {
      if (after_[i]->covering_move(points, covered_hints_[i]) != kNone) return true;
    }
    return false;
  }

  bool sample(const SidedPiece& at, const Vec3& middle, double away_mm) {
    if (is_found() && away_mm <= left_->thickness_mm) return false;
    const Vec3 finished = middle + limits_.finished_mm * at.outward;
    const std::size_t move = before_.covering_move({&finished, 1}, finished_hint_);
    if (move == kNone) return false;
    left_ = LeftStock{std::min(away_mm, limits_.most_mm), away_mm >= limits_.most_mm, false, middle, move};
    return true;
  }

  /// Of a point of the surface from the nearest cut, as far as it is more than `enough_mm`.
  [[nodiscard]] double away_from_cuts(const Vec3& point, double enough_mm) const {
    double least = limits_.most_mm;
    for (const CutterSweep* sweep : after_) {
      if (least > enough_mm) least = std::min(least, sweep->distance(point, enough_mm, least));
    }
    return std::max(least, 0.0);
  }

  const CutterSweep& before_;
  std::span<const CutterSweep* const> after_;
  StockLimits limits_;
  double border_mm_ = kMostBorder_mm;
  bool is_convex_ = true;
  std::optional<LeftStock> left_;
  int pieces_ = 0;
  SweepHint finished_hint_;
  std::vector<SweepHint> covered_hints_;
};

/// Pieces of all triangles that cutters of `before` may finish.
class Gatherer {
 public:
  Gatherer(const BlockTree& tree, Finder& finder) : tree_(tree), finder_(finder) {}

  void visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::size_t i = 0; i < node.count; ++i) {
      const Vec3 centre = tree_.origin + Vec3(node.center[0][i], node.center[1][i], node.center[2][i]);
      if (!finder_.may_be_finished(centre, static_cast<double>(node.radius_mm[i]))) continue;
      if (!node.has_leaves) {
        visit(node.child[i]);
        continue;
      }
      const TriangleBlock& leaf = tree_.leaves[node.child[i]];
      for (std::size_t k = 0; k < leaf.count; ++k) add(tree_.corners(leaf.triangle[k]));
    }
  }

  std::vector<SidedPiece> pieces;

 private:
  void add(const std::array<Vec3, 3>& triangle) {
    const Vec3 across = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    if (!(across.norm() > 0)) return;
    for (const double side : {1.0, -1.0}) cut({triangle, side * across.normalized()});
  }

  void cut(const SidedPiece& at) {
    if (!finder_.may_be_finished(at)) return;
    if (longest_mm(at) <= kFirstPiece_mm) {
      pieces.push_back(at);
      return;
    }
    for (const auto& half : halves(at.corners, longest_edge(at.corners))) cut({half, at.outward});
  }

  const BlockTree& tree_;
  Finder& finder_;
};

}  // namespace

std::optional<LeftStock> find_left_stock(const BlockTree& parts, const CutterSweep& before,
                                         std::span<const CutterSweep* const> after, const StockLimits& limits,
                                         unsigned threads) {
  if (parts.nodes.empty() || before.is_empty()) return std::nullopt;
  Finder finder(before, after, limits);
  Gatherer gatherer(parts, finder);
  gatherer.visit(0);
  std::vector<std::optional<LeftStock>> left(gatherer.pieces.size());
  for_each_chunk(left.size(), 1, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      Finder own = finder;
      own.refine(gatherer.pieces[i]);
      left[i] = own.left();
    }
  });
  std::optional<LeftStock> most;
  for (const std::optional<LeftStock>& one : left) {
    if (one && (!most || one->thickness_mm > most->thickness_mm || (most->is_undecided && !one->is_undecided)))
      most = one;
  }
  return most;
}

}  // namespace gouge
