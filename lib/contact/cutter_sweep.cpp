#include "lib/contact/cutter_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/geom/cross.h"
#include "lib/path/path_info.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSag_mm = 1e-3;
constexpr double kTurn_rad = 0.0175;  // of a piece: its points are off their chords by little
constexpr std::uint32_t kLeaf = 4;
constexpr double kClose_mm = 2e-4;  // to which the nearest instant is found
constexpr int kMostLooks = 60;      // at one piece of motion, ...
constexpr int kMostHalvings = 12;   // ... of a cutter that is not convex

constexpr auto kSkipNothing = [](const auto& /*node*/) { return false; };

}  // namespace

bool is_convex(const CompiledTool& tool) {
  Vec2 along = Vec2::UnitX();
  for (const BoundaryElement& e : tool.elements) {
    if (e.is_reflex) return false;
    if (e.kind != ElementKind::segment) continue;
    const Vec2 next = (e.b - e.a).normalized();
    if (cross(along, next) < -1e-9) return false;
    along = next;
  }
  return true;
}

double farthest_mm(const CompiledTool& cutter) {
  return Vec2(cutter.r_max_mm, std::max(cutter.z_max_mm, -cutter.z_min_mm)).norm();
}

Pose CutterSweep::Piece::at(double t) const {
  const Vec3 tip = start.tip + t * (end.tip - start.tip);
  if (!(angle_rad > 0)) return {tip, start.axis};
  return {tip, (start.axis + t * (end.axis - start.axis)).normalized()};
}

void CutterSweep::add(const Motion& motion, const CompiledTool& cutter, std::size_t move) {
  const bool is_round = gouge::is_convex(cutter);
  is_convex_ = is_convex_ && is_round;
  least_radius_mm_ = std::min(least_radius_mm_, cutter.r_max_mm);
  std::uint32_t number = 0;
  for (const MotionSegment& segment : motion.segments()) {
    const double share = segment.t1 - segment.t0;
    int count = std::max(1, static_cast<int>(std::ceil(share * motion.angle_rad() / kTurn_rad)));
    while (motion.sag_mm(segment.t0, segment.t0 + share / count, number) > kSag_mm && count < 10'000) count *= 2;
    for (int k = 0; k < count; ++k) {
      const double t0 = segment.t0 + share * k / count, t1 = segment.t0 + share * (k + 1) / count;
      Piece piece;
      piece.start = {motion.tip_at(t0, number), motion.at(t0).axis};
      piece.end = {motion.tip_at(t1, number), motion.at(t1).axis};
      piece.angle_rad = (t1 - t0) * motion.angle_rad();
      // An axis that runs along the chord instead of the arc is ahead of an even turn, or behind, by less than angle^3 / 60.
      piece.off_mm = motion.sag_mm(t0, t1, number) + farthest_mm(cutter) * std::pow(piece.angle_rad, 3) / 60;
      piece.cutter = &cutter;
      piece.move = move;
      piece.is_convex = is_round;
      pieces_.push_back(piece);
    }
    ++number;
  }
}

void CutterSweep::index() {
  nodes_.clear();
  if (!pieces_.empty()) build(0, static_cast<std::uint32_t>(pieces_.size()));
}

std::uint32_t CutterSweep::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Node& made = nodes_.emplace_back();
  made.low.setConstant(kNever);
  made.high.setConstant(-kNever);
  made.first = first;
  made.last = last;
  surround(made);
  if (last - first > kLeaf) {
    build(first, first + (last - first) / 2);
    const std::uint32_t second = build(first + (last - first) / 2, last);
    Node& node = nodes_[index];
    node.second = second;
    for (const std::uint32_t child : {index + 1, second}) {
      node.low = node.low.cwiseMin(nodes_[child].low);
      node.high = node.high.cwiseMax(nodes_[child].high);
    }
    return index;
  }
  Node& node = nodes_[index];
  for (std::uint32_t i = first; i < last; ++i) {
    const Piece& piece = pieces_[i];
    // About the axis at both ends, and what both leave their chords by in between.
    const double bulge = farthest_mm(*piece.cutter) * piece.angle_rad * piece.angle_rad / 8 + piece.off_mm;
    const Vec3 wide = Vec3::Constant(piece.cutter->r_max_mm + bulge);
    for (const Pose& pose : {piece.start, piece.end}) {
      for (const double z : {piece.cutter->z_min_mm, piece.cutter->z_max_mm}) {
        node.low = node.low.cwiseMin(pose.tip + z * pose.axis - wide);
        node.high = node.high.cwiseMax(pose.tip + z * pose.axis + wide);
      }
    }
  }
  return index;
}

// A point of a body is moved from one pose to another by no more than its tip, and its distance from the tip times the
// angle between the axes, about which it may be turned as one likes. On the way of a piece tips are between those of its
// ends, and axes between its axes or its turn beyond.
void CutterSweep::surround(Node& node) const {
  const Piece& middle = pieces_[node.first + (node.last - node.first) / 2];
  node.middle = middle.start;
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const Piece& piece = pieces_[i];
    if (piece.cutter != middle.cutter) node.spread_mm = kNever;
    const double way = std::max((piece.start.tip - node.middle.tip).norm(), (piece.end.tip - node.middle.tip).norm());
    const double turn = angle_between_rad(piece.start.axis, node.middle.axis) + piece.angle_rad;
    node.spread_mm = std::max(node.spread_mm, way + farthest_mm(*piece.cutter) * turn + piece.off_mm);
  }
}

bool CutterSweep::is_beyond(const Node& node, const Vec3& point, double within_mm) const {
  return node.spread_mm < kNever &&
         signed_distance_mm(*pieces_[node.first].cutter, node.middle, point) > node.spread_mm + within_mm;
}

/// Of the point that is farthest from the box, from it.
double CutterSweep::away_mm(const Node& node, std::span<const Vec3> points) const {
  double most = 0;
  for (const Vec3& point : points) {
    const Vec3 past = (node.low - point).cwiseMax(point - node.high).cwiseMax(0);
    most = std::max(most, past.squaredNorm());
  }
  return std::sqrt(most);
}

template <typename Within, typename Skip, typename Look>
bool CutterSweep::visit(std::uint32_t index, std::span<const Vec3> points, const Within& within, const Skip& skip,
                        const Look& look, std::size_t& work) const {
  const Node& node = nodes_[index];
  work += 1 + (node.second == 0 ? node.last - node.first : 0);
  if (node.second == 0) {
    for (std::uint32_t i = node.first; i < node.last; ++i) {
      if (look(i)) return true;
    }
    return false;
  }
  std::uint32_t near = index + 1, far = node.second;
  double near_mm = away_mm(nodes_[near], points), far_mm = away_mm(nodes_[far], points);
  if (far_mm < near_mm) {
    std::swap(near, far);
    std::swap(near_mm, far_mm);
  }
  const auto is_near = [&](std::uint32_t child, double box_mm) {
    const double within_mm = within();
    return box_mm <= within_mm && !is_beyond(nodes_[child], points.front(), within_mm) && !skip(nodes_[child]);
  };
  return (is_near(near, near_mm) && visit(near, points, within, skip, look, work)) ||
         (is_near(far, far_mm) && visit(far, points, within, skip, look, work));
}

/// How far points are outside the cutter at the instants of one piece of motion: the largest of their distances.
class CutterSweep::Instants {
 public:
  Instants(const Piece& piece, std::span<const Vec3> points) : piece_(piece), points_(points) {
    const double way = (piece.end.tip - piece.start.tip).norm();
    double far = 0;
    for (const Vec3& point : points) far = std::max(far, (point - piece.start.tip).norm());
    speed_mm_ = way + piece.angle_rad * (far + way);
    bend_mm_ = (far + way) * piece.angle_rad * piece.angle_rad / 8;
  }

  /// Until an instant is found at which it is `enough_mm` or less, or it is known to be more than `hopeless_mm` at all,
  /// or the least is known closely.
  void search(double enough_mm, double hopeless_mm) {
    enough_mm_ = enough_mm - piece_.off_mm;
    hopeless_mm_ = hopeless_mm + piece_.off_mm;
    if (!(speed_mm_ > 0)) return settle(at(0));
    if (piece_.is_convex) return search_convex();
    const double at_0 = at(0), at_1 = at(1);
    halve(0, at_0, 1, at_1, 0);
  }

  [[nodiscard]] double found_mm() const { return found_mm_ + piece_.off_mm; }
  [[nodiscard]] double bound_mm() const { return std::min(bound_mm_, found_mm_) - piece_.off_mm; }
  [[nodiscard]] double found_at() const { return found_at_; }
  [[nodiscard]] double bend_mm() const { return bend_mm_ + piece_.off_mm; }

 private:
  double at(double t) {
    const Pose pose = piece_.at(t);
    double most = -kNever;
    for (const Vec3& point : points_) most = std::max(most, signed_distance_mm(*piece_.cutter, pose, point));
    if (most < found_mm_) {
      found_mm_ = most;
      found_at_ = t;
    }
    return most;
  }

  [[nodiscard]] bool is_settled(double least, double known) const {
    return found_mm_ <= enough_mm_ || least > hopeless_mm_ || known - least < kClose_mm;
  }

  void settle(double least) { bound_mm_ = std::min(bound_mm_, least); }

  // On a straight way without a turn the distance of a point to a convex body is a convex function of the instant, and
  // so is the largest of several. Lines through two values bound it beyond them from below.
  void search_convex() {
    double a = 0, b = 1, at_a = at(a), at_b = at(b);
    const double known = std::min(at_a, at_b), by_speed = 0.5 * (at_a + at_b - speed_mm_);
    if (is_settled(by_speed, known)) return settle(std::min(by_speed, known));
    double m = 0.5, at_m = at(m);
    for (int looks = 0;; ++looks) {
      const double to_left = at_m - std::max(at_b - at_m, 0.0) * (m - a) / (b - m);
      const double to_right = at_m - std::max(at_a - at_m, 0.0) * (b - m) / (m - a);
      const double down_left = std::max(to_left - 4 * bend_mm_, 0.5 * (at_a + at_m - speed_mm_ * (m - a)));
      const double down_right = std::max(to_right - 4 * bend_mm_, 0.5 * (at_m + at_b - speed_mm_ * (b - m)));
      const double found = std::min({at_a, at_m, at_b}), least = std::min({found, down_left, down_right});
      if (looks == kMostLooks || is_settled(least, found)) return settle(least);
      const bool is_left = down_left < down_right;
      const double t = is_left ? 0.5 * (a + m) : 0.5 * (m + b), at_t = at(t);
      // The least of three neighbours that are not equal stays the middle; what is beyond them is higher.
      if (is_left ? at_t <= at_m : at_t < at_m) {
        (is_left ? b : a) = m;
        (is_left ? at_b : at_a) = at_m;
        m = t;
        at_m = at_t;
      } else {
        (is_left ? a : b) = t;
        (is_left ? at_a : at_b) = at_t;
      }
    }
  }

  void halve(double a, double at_a, double b, double at_b, int level) {
    const double known = std::min(at_a, at_b), least = std::min(known, 0.5 * (at_a + at_b - speed_mm_ * (b - a)));
    if (level == kMostHalvings || is_settled(least, known)) return settle(least);
    const double middle = 0.5 * (a + b), at_middle = at(middle);
    halve(a, at_a, middle, at_middle, level + 1);
    if (found_mm_ > enough_mm_) halve(middle, at_middle, b, at_b, level + 1);
  }

  const Piece& piece_;
  std::span<const Vec3> points_;
  double speed_mm_ = 0;  // by which a distance changes at the most for t from 0 to 1
  double bend_mm_ = 0;   // by which it is off a convex function, where the cutter is convex
  double enough_mm_ = 0, hopeless_mm_ = 0;
  double found_mm_ = kNever, bound_mm_ = kNever, found_at_ = 0;
};

double CutterSweep::distance(const Vec3& point, double enough_mm, double hopeless_mm, SweepHint& hint) const {
  double found = kNever, bound = hopeless_mm;
  if (nodes_.empty()) return bound;
  const std::span<const Vec3> points(&point, 1);
  const auto look = [&](std::uint32_t i) {
    Instants instants(pieces_[i], points);
    instants.search(enough_mm, std::min(found - kClose_mm, hopeless_mm));
    if (instants.found_mm() < found) {
      found = instants.found_mm();
      hint.piece = i;
    }
    bound = std::min(bound, instants.bound_mm());
    return found <= enough_mm;
  };
  const std::uint32_t first = hint.piece;
  if (first >= pieces_.size() || !look(first)) {
    visit(
        0, points, [&] { return std::min(found, hopeless_mm); }, kSkipNothing,
        [&](std::uint32_t i) { return i != first && look(i); }, hint.work);
  }
  return bound;
}

std::size_t CutterSweep::covering_move(std::span<const Vec3> points, SweepHint& hint) const {
  if (nodes_.empty()) return kNone;
  const auto look = [&](std::uint32_t i) {
    Instants instants(pieces_[i], points);
    instants.search(0, 0);
    if (instants.found_mm() <= 0) hint.piece = i;
    return instants.found_mm() <= 0;
  };
  const auto inside = [] { return 0.0; };
  const bool is_found =
      (hint.piece < pieces_.size() && look(hint.piece)) || visit(0, points, inside, kSkipNothing, look, hint.work);
  return is_found ? pieces_[hint.piece].move : kNone;
}

// The distance from a convex cutter that does not turn is a convex function of point and instant together, so its least
// value over all instants is one of the point. On a triangle with the middle c each point q has another one at
// c + (c - q) / 2; so at q it is at least three times its value at c less twice the largest one at a corner.
bool CutterSweep::may_reach(const SidedPiece& piece, double lift_mm, double deep_mm, SweepHint& hint) const {
  if (nodes_.empty()) return false;
  const Vec3 up = lift_mm * piece.outward;
  const std::array<Vec3, 3> corners = {piece.corners[0] + up, piece.corners[1] + up, piece.corners[2] + up};
  const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  double radius = 0;
  for (const Vec3& corner : corners) radius = std::max(radius, (corner - middle).norm());
  const auto behind = [&](const Pose& pose, const CompiledTool& cutter) {
    return piece.outward.dot(middle - up - pose.tip - cutter.core.y() * pose.axis);
  };
  // The deepest point is one of the cutter, so it is moved no farther than that.
  const auto are_behind = [&](const Node& node) {
    return behind(node.middle, *pieces_[node.first].cutter) > radius + node.spread_mm;
  };
  const auto look = [&](std::uint32_t i) {
    const Piece& motion = pieces_[i];
    if (std::min(behind(motion.start, *motion.cutter), behind(motion.end, *motion.cutter)) > radius) return false;
    Instants instants(motion, {&middle, 1});
    instants.search(-deep_mm, radius - deep_mm);
    if (instants.bound_mm() > radius - deep_mm) return false;
    if (instants.found_mm() > -deep_mm && motion.is_convex) {
      const Pose pose = motion.at(instants.found_at());
      double most = -kNever;
      for (const Vec3& corner : corners) most = std::max(most, signed_distance_mm(*motion.cutter, pose, corner));
      if (3 * instants.bound_mm() - 2 * most - 8 * instants.bend_mm() > -deep_mm) return false;
    }
    hint.piece = i;
    return true;
  };
  return (hint.piece < pieces_.size() && look(hint.piece)) ||
         visit(
             0, {&middle, 1}, [&] { return std::max(0.0, radius - deep_mm); }, are_behind, look, hint.work);
}

}  // namespace gouge
