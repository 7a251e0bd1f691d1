#include "lib/tool/reach_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"
#include "lib/tool/foot_cells.h"
#include "lib/tool/inscribed_balls.h"

namespace gouge {
namespace {

constexpr double kRegionRounding = 2e-5;  // share of the height: twice the size of regions that RegionFinder ignores
constexpr double kNearly = 0.01;          // share of the depth: accuracy of the largest ball
constexpr double kFine = 0.02;            // share of the bound: cells this narrow are not divided
constexpr std::size_t kAxisPoints = 128, kNeighbours = 4, kMaxCells = 5'000;
constexpr int kHalvings = 30, kMaxJoints = 16;
// Maximum number of examined balls, and the number that one evaluation counts for. A tool of many teeth reaches the
// maximum. It gets a larger bound.
constexpr std::size_t kMaxLooks = 10'000'000, kLooksOfEvaluation = 30;

/// A ball of the half plane. All points nearer to `center` than `free_mm` lie deeper than the given depth.
struct Ball {
  Vec2 center = Vec2::Zero();
  double free_mm = 0;
  bool is_joined = false;  // connected with a point of the axis that the check needs
};

struct CellBall {
  FootCell cell;
  std::size_t ball = 0;  // its own ball, or the number of balls before it
  bool has_ball = false;
  bool is_covered = false;  // its own ball is a good enough bound
};

class ReachSearch {
 public:
  ReachSearch(const CompiledTool& form, const CompiledTool& bare, double depth_mm, double cutoff_mm)
      : form_(form),
        bare_(bare),
        depth_mm_(depth_mm),
        cutoff_mm_(cutoff_mm),
        size_mm_(form.r_max_mm + form.z_max_mm - form.z_min_mm) {}

  double run() {
    for (const FootCell& cell : foot_cells(form_)) cover(cell);
    add_axis();
    join();
    if (std::none_of(balls_.begin(), balls_.end(), [](const Ball& b) { return b.is_joined; })) return kNoReach_mm;
    double reach = 0;
    for (std::size_t k = 0; k < cells_.size(); ++k) reach = std::max(reach, bound(k, reach));
    return reach + Tolerance::kConstruction * size_mm_;
  }

 private:
  [[nodiscard]] double free_at(const Vec2& q) const {
    looks_ += kLooksOfEvaluation;
    return -signed_distance_mm(form_, std::max(0.0, q.x()), q.y()) - depth_mm_ - Tolerance::kConstruction * size_mm_;
  }

  /// Returns a part of the largest ball that touches the boundary, or nearly, at the middle ray's foot. The part is
  /// deeper than the given depth.
  [[nodiscard]] Ball own_ball(const FootCell& cell) const {
    looks_ += 4 * kLooksOfEvaluation;
    const InscribedBall ball = inscribed_ball(form_, cell, cell.middle(), depth_mm_, kNearly * depth_mm_);
    if (!(ball.radius_mm > 0)) return {};
    return {ball.center, ball.radius_mm - depth_mm_ - Tolerance::kConstruction * size_mm_};
  }

  /// Bounds the distance of the cell's points to the ball, if every ray enters the ball. Points before the entry are
  /// nearer than their foot. Points behind it are deeper than the entry, so the ray connects them with the ball.
  [[nodiscard]] static double bound_by_own(const FootCell& cell, const Ball& ball) {
    if (!(ball.free_mm > 0) || !cell.rays_meet(ball.center, ball.free_mm)) return kNoReach_mm;
    return std::max(0.0, cell.farthest_mm(ball.center, 0) - ball.free_mm);
  }

  static FootCell half_of(const FootCell& cell, bool is_second) {
    FootCell half = cell;
    (is_second ? half.from : half.to) = cell.middle();
    return half;
  }

  void cover(const FootCell& cell) {
    const Ball ball = own_ball(cell);
    const bool has_ball = ball.free_mm > 0;
    const bool is_covered = has_ball && bound_by_own(cell, ball) <= cutoff_mm_;
    const double width = cell.width_mm(0) + cell.width_mm(depth_mm_);
    const bool is_fine = has_ball ? width < kFine * std::max(cutoff_mm_, depth_mm_) : width < size_mm_ / 16;
    if (is_covered || is_fine || cells_.size() > kMaxCells) {
      add_end_of_balls(cell, has_ball);
      cells_.push_back({cell, balls_.size(), has_ball, is_covered});
      if (has_ball) balls_.push_back(ball);
      return;
    }
    cover(half_of(cell, false));
    cover(half_of(cell, true));
  }

  /// Adds the outermost ball between a cell with a ball and a neighbour in the same element without one.
  void add_end_of_balls(const FootCell& cell, bool has_ball) {
    if (cells_.empty() || cells_.back().has_ball == has_ball) return;
    const FootCell& before = cells_.back().cell;
    const bool is_next = before.origin == cell.origin && before.along == cell.along && before.to >= cell.from;
    if (!is_next) return;
    FootCell point = cell;
    double with = has_ball ? cell.middle() : before.middle(), without = has_ball ? before.middle() : cell.middle();
    Ball outermost;
    for (int k = 0; k < kHalvings; ++k) {
      point.from = point.to = 0.5 * (with + without);
      const Ball ball = own_ball(point);
      const bool is_wide = ball.free_mm > kFine * depth_mm_;  // a narrower ball is hard to connect
      (is_wide ? with : without) = point.from;
      if (is_wide) outermost = ball;
    }
    if (outermost.free_mm > 0) balls_.push_back(outermost);
  }

  void add_axis() {
    for (std::size_t i = 0; i < kAxisPoints; ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(kAxisPoints);
      const Vec2 center(0, form_.z_min_mm + share * (form_.z_max_mm - form_.z_min_mm));
      const double free = free_at(center);
      if (free > 0) balls_.push_back({center, free});
    }
  }

  [[nodiscard]] bool is_asked(const Ball& ball) const {
    if (ball.center.x() > 0) return false;
    const double excess = kRegionRounding * (bare_.z_max_mm - bare_.z_min_mm);
    return -signed_distance_mm(bare_, 0, ball.center.y()) > depth_mm_ + excess;
  }

  /// Returns whether the whole straight line between two points is deeper than the given depth.
  [[nodiscard]] bool are_joined(const Ball& a, const Ball& b, int joints = kMaxJoints) const {
    if (a.free_mm + b.free_mm > (a.center - b.center).norm()) return true;
    if (joints == 0 || is_tired()) return false;
    Ball middle;
    middle.center = 0.5 * (a.center + b.center);
    middle.free_mm = free_at(middle.center);
    return middle.free_mm > 0 && are_joined(a, middle, joints - 1) && are_joined(middle, b, joints - 1);
  }

  /// Connects balls along the contour, in both directions, from the points on the axis until no more can be connected.
  void join() {
    for (Ball& ball : balls_) ball.is_joined = is_asked(ball);
    for (bool is_new = true; is_new && !is_tired();) {
      is_new = false;
      for (std::size_t i = 1; i < balls_.size(); ++i) is_new = take(balls_[i - 1], balls_[i]) || is_new;
      for (std::size_t i = balls_.size(); i-- > 1;) is_new = take(balls_[i], balls_[i - 1]) || is_new;
      for (std::size_t i = 0; i < balls_.size() && !is_new; ++i) is_new = !balls_[i].is_joined && join_any(balls_[i]);
    }
  }

  [[nodiscard]] bool take(const Ball& from, Ball& to) const {
    if (!from.is_joined || to.is_joined || !are_joined(from, to)) return false;
    return to.is_joined = true;
  }

  // Stops the search for connections. Then a ball remains unconnected and bounds nothing.
  [[nodiscard]] bool is_tired() const { return looks_ > kMaxLooks; }

  bool join_any(Ball& ball) const {
    if (is_tired()) return false;
    looks_ += balls_.size();
    for (const Ball& other : balls_) {
      const bool is_touching = (other.center - ball.center).norm() < other.free_mm + ball.free_mm;
      if (other.is_joined && is_touching) return ball.is_joined = true;
    }
    Ball axis;
    axis.center = Vec2(0, ball.center.y());
    axis.free_mm = free_at(axis.center);
    return axis.free_mm > 0 && is_asked(axis) && (ball.is_joined = are_joined(axis, ball));
  }

  /// Returns a bound for all points of a cell. The search stops as soon as it is below cutoff_mm or `known_mm`.
  [[nodiscard]] double bound(std::size_t k, double known_mm) {
    const CellBall& own = cells_[k];
    if (own.is_covered && balls_[own.ball].is_joined) return bound_by_own(own.cell, balls_[own.ball]);
    std::size_t budget = kMaxCells;
    return bound_by_all(own.cell, own.ball, std::max(known_mm, cutoff_mm_), budget);
  }

  [[nodiscard]] double bound_by_all(const FootCell& cell, std::size_t near, double min_mm, std::size_t& budget) {
    const double ray = longest_ray(cell);
    double upper = kNoReach_mm;
    const auto use = [&](const Ball& ball) {
      if (ball.is_joined) upper = std::min(upper, std::max(0.0, cell.farthest_mm(ball.center, ray) - ball.free_mm));
    };
    const std::size_t first = near > kNeighbours ? near - kNeighbours : 0;
    for (std::size_t i = first; i < std::min(balls_.size(), near + kNeighbours); ++i) use(balls_[i]);
    if (is_tired()) return upper;
    looks_ += balls_.size();
    for (std::size_t i = balls_.size(); i-- > 0 && upper > min_mm;) use(balls_[i]);  // the newest balls are the nearest
    const double width = cell.width_mm(0) + cell.width_mm(std::min(ray, depth_mm_));
    if (upper <= min_mm || width < kFine * upper || budget < 2) return upper;
    budget -= 2;
    const double one = bound_by_piece(half_of(cell, false), near, min_mm, budget);
    return std::max(one, bound_by_piece(half_of(cell, true), near, std::max(min_mm, one), budget));
  }

  [[nodiscard]] double bound_by_piece(const FootCell& cell, std::size_t near, double min_mm, std::size_t& budget) {
    Ball ball = own_ball(cell);
    if (ball.free_mm > 0 && join_any(ball)) {
      const double own = bound_by_own(cell, ball);
      if (own <= min_mm) return own;
      balls_.push_back(ball);
    }
    return bound_by_all(cell, near, min_mm, budget);
  }

  /// Returns a bound of the distance of points with their foot in the cell from that foot. If one were at t, the middle
  /// ray's point at t would be at least t less their distance deep.
  [[nodiscard]] double longest_ray(const FootCell& cell) const {
    const double longest = std::min(cell.longest_ray_mm(), size_mm_);
    for (double t = depth_mm_; t < longest; t *= 1.25) {
      const Vec2 q = cell.at(cell.middle(), t);  // beyond the axis the mirrored tool follows
      if (-signed_distance_mm(form_, std::abs(q.x()), q.y()) <
          t - cell.width_mm(t) - Tolerance::kConstruction * size_mm_)
        return t;
    }
    return longest;
  }

  const CompiledTool& form_;
  const CompiledTool& bare_;
  double depth_mm_, cutoff_mm_, size_mm_;
  std::vector<CellBall> cells_;
  std::vector<Ball> balls_;
  mutable std::size_t looks_ = 0;
};

}  // namespace

double bound_reach(const CompiledTool& form, const CompiledTool& bare, double depth_mm, double cutoff_mm) {
  if (form.elements.empty()) return 0;
  return ReachSearch(form, bare, depth_mm, cutoff_mm).run();
}

}  // namespace gouge
