#include "lib/contact/cutter_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/path/path_info.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kSag_mm = 1e-3;
constexpr double kTurn_rad = 0.0175;  // maximum turn of a stretch: its points deviate little from their chords
constexpr std::uint32_t kLeaf = 4;

constexpr auto kSkipNothing = [](const auto& /*node*/) { return false; };

}  // namespace

bool is_convex(const CompiledTool& tool) {
  Vec2 along = Vec2::UnitX();
  for (const BoundaryElement& e : tool.elements) {
    if (e.is_reflex) return false;
    if (e.kind != ElementKind::segment) continue;
    const Vec2 next = (e.b - e.a).normalized();
    if (cross(along, next) < -Tolerance::kRounding) return false;
    along = next;
  }
  return true;
}

double farthest_mm(const CompiledTool& cutter) {
  return Vec2(cutter.r_max_mm, std::max(cutter.z_max_mm, -cutter.z_min_mm)).norm();
}

void CutterSweep::add(const Motion& motion, const CompiledTool& cutter, std::size_t move) {
  const bool is_round = gouge::is_convex(cutter);
  is_convex_ = is_convex_ && is_round;
  min_radius_mm_ = std::min(min_radius_mm_, cutter.r_max_mm);
  const double far = farthest_mm(cutter);
  std::uint32_t number = 0;
  for (const MotionSegment& segment : motion.segments()) {
    const double share = segment.t1 - segment.t0;
    int count = std::max(1, static_cast<int>(std::ceil(motion.turn_rad(segment.t0, segment.t1) / kTurn_rad)));
    const auto is_bent = [&] {
      const MotionRates first = motion.rates(segment.t0, segment.t0 + share / count, number);
      return first.tip_sag_mm + far * first.off_circle_rad > kSag_mm ||
             first.turn_rad * first.tip_path_mm / 4 > kSag_mm;
    };
    while (is_bent() && count < 10'000) count *= 2;
    for (int k = 0; k < count; ++k) {
      const double t0 = segment.t0 + share * k / count, t1 = segment.t0 + share * (k + 1) / count;
      CutterStretch stretch;
      stretch.start = {motion.tip_at(t0, number), motion.at(t0).axis};
      stretch.end = {motion.tip_at(t1, number), motion.at(t1).axis};
      const MotionRates rates = motion.rates(t0, t1, number);
      stretch.angle_rad = rates.turn_rad;
      stretch.off_mm = rates.tip_sag_mm + far * rates.off_circle_rad;
      stretch.cutter = &cutter;
      stretch.move = move;
      stretch.is_convex = is_round;
      stretches_.push_back(stretch);
    }
    ++number;
  }
}

void CutterSweep::index() {
  nodes_.clear();
  if (!stretches_.empty()) build(0, static_cast<std::uint32_t>(stretches_.size()));
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
    const CutterStretch& piece = stretches_[i];
    // The box surrounds the cutter about the axis at both ends, plus the deviation of both from their chords in
    // between.
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

// Surrounds the poses of a node. Between two poses a point of a body moves by at most the sum of two lengths. One is
// the motion of the tip; the other is the distance from the tip times the angle between the axes. A turn about the axis
// changes nothing. On the way of a piece, each tip is between the tips of its ends. Each axis is between its axes, or
// beyond them by at most its turn.
void CutterSweep::surround(Node& node) const {
  const CutterStretch& middle = stretches_[node.first + (node.last - node.first) / 2];
  node.middle = middle.start;
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const CutterStretch& piece = stretches_[i];
    if (piece.cutter != middle.cutter) node.spread_mm = kNever;
    const double way = std::max((piece.start.tip - node.middle.tip).norm(), (piece.end.tip - node.middle.tip).norm());
    const double turn = angle_between_rad(piece.start.axis, node.middle.axis) + piece.angle_rad;
    node.spread_mm = std::max(node.spread_mm, way + farthest_mm(*piece.cutter) * turn + piece.off_mm);
  }
}

bool CutterSweep::is_beyond(const Node& node, const Vec3& point, double within_mm) const {
  return node.spread_mm < kNever &&
         signed_distance_mm(*stretches_[node.first].cutter, node.middle, point) > node.spread_mm + within_mm;
}

/// Returns the largest distance of the points from the node's box.
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
    return box_mm <= std::max(within_mm, 0.0) && !is_beyond(nodes_[child], points.front(), within_mm) &&
           !skip(nodes_[child]);
  };
  return (is_near(near, near_mm) && visit(near, points, within, skip, look, work)) ||
         (is_near(far, far_mm) && visit(far, points, within, skip, look, work));
}

double CutterSweep::distance(const Vec3& point, double lower_cutoff_mm, double upper_cutoff_mm, SweepHint& hint) const {
  double found = kNever, bound = upper_cutoff_mm;
  if (nodes_.empty()) return bound;
  const std::span<const Vec3> points(&point, 1);
  const auto look = [&](std::uint32_t i) {
    NearestInstant nearest(stretches_[i], points);
    nearest.search(lower_cutoff_mm, std::min(found - kInstantGap_mm, upper_cutoff_mm));
    if (nearest.found_mm() < found) {
      found = nearest.found_mm();
      hint.piece = i;
    }
    bound = std::min(bound, nearest.bound_mm());
    return found <= lower_cutoff_mm;
  };
  const std::uint32_t first = hint.piece;
  if (first >= stretches_.size() || !look(first)) {
    visit(
        0, points, [&] { return std::min(found, upper_cutoff_mm); }, kSkipNothing,
        [&](std::uint32_t i) { return i != first && look(i); }, hint.work);
  }
  return bound;
}

std::size_t CutterSweep::covering_move(std::span<const Vec3> points, SweepHint& hint) const {
  if (nodes_.empty()) return kNone;
  const auto look = [&](std::uint32_t i) {
    NearestInstant nearest(stretches_[i], points);
    nearest.search(0, 0);
    if (nearest.found_mm() <= 0) hint.piece = i;
    return nearest.found_mm() <= 0;
  };
  const auto inside = [] { return 0.0; };
  const bool is_found =
      (hint.piece < stretches_.size() && look(hint.piece)) || visit(0, points, inside, kSkipNothing, look, hint.work);
  return is_found ? stretches_[hint.piece].move : kNone;
}

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
  // The deepest point is a point of the cutter, so it moves no farther than spread_mm.
  const auto are_behind = [&](const Node& node) {
    return behind(node.middle, *stretches_[node.first].cutter) > radius + node.spread_mm;
  };
  const std::array<Vec3, 3> from_middle = {corners[0] - middle, corners[1] - middle, corners[2] - middle};
  const auto look = [&](std::uint32_t i) {
    const CutterStretch& stretch = stretches_[i];
    if (std::min(behind(stretch.start, *stretch.cutter), behind(stretch.end, *stretch.cutter)) > radius) return false;
    NearestInstant nearest(stretch, middle, from_middle);
    nearest.search(-deep_mm, -deep_mm);
    if (nearest.bound_mm() > -deep_mm) return false;
    hint.piece = i;
    return true;
  };
  return (hint.piece < stretches_.size() && look(hint.piece)) ||
         visit(
             0, {&middle, 1}, [&] { return radius - deep_mm; }, are_behind, look, hint.work);
}

}  // namespace gouge
