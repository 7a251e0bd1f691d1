#include "lib/contact/cutter_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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
constexpr std::uint32_t kSmallNode = 16;

/// Returns an upper bound of the angle between two unit vectors. It uses asin x <= x + (pi / 2 - 1) x^3, which holds
/// because all terms of the series are positive, and those after the first are at most their values at 1 times x^3.
double turn_at_most_rad(const Vec3& a, const Vec3& b) {
  constexpr double kRest = std::numbers::pi / 2 - 1;
  const double chord = (a - b).norm();
  return chord + kRest * chord * chord * chord / 4;
}

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
  nodes_.reserve(stretches_.size());
  cores_.clear();
  cores_.reserve(stretches_.size());
  for (const CutterStretch& stretch : stretches_) cores_.push_back(core_of(stretch));
  if (!stretches_.empty()) build(0, static_cast<std::uint32_t>(stretches_.size()));
}

CutterSweep::Core CutterSweep::core_of(const CutterStretch& stretch) {
  Core core;
  const Vec3 between = stretch.start.axis + stretch.end.axis;
  core.middle = {0.5 * (stretch.start.tip + stretch.end.tip), between.normalized()};
  core.half_way = 0.5 * (stretch.end.tip - stretch.start.tip);
  core.half_way_mm = core.half_way.norm();
  core.beside_mm = stretch.off_mm;
  core.turn_rad = 0.5 * stretch.angle_rad;
  return core;
}

std::uint32_t CutterSweep::build(std::uint32_t first, std::uint32_t last) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  std::uint32_t second = 0;
  if (last - first > kLeaf) {
    build(first, first + (last - first) / 2);
    second = build(first + (last - first) / 2, last);
  }
  Node& node = nodes_[index];
  node.low.setConstant(kNever);
  node.high.setConstant(-kNever);
  node.first = first;
  node.last = last;
  node.second = second;
  surround(index);
  if (second != 0) {
    for (const std::uint32_t child : {index + 1, second}) {
      node.low = node.low.cwiseMin(nodes_[child].low);
      node.high = node.high.cwiseMax(nodes_[child].high);
    }
    return index;
  }
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

// Surrounds the poses of a node by those of its stretches. For a large node, whose bound excludes few points, it takes
// those of its halves.
void CutterSweep::surround(std::uint32_t index) {
  Node& node = nodes_[index];
  const std::uint32_t between = node.first + (node.last - node.first) / 2;
  const Vec3 &from = stretches_[node.first].start.tip, &to = stretches_[node.last - 1].end.tip;
  Core& all = node.core;
  all.middle = {0.5 * (from + to), cores_[between].middle.axis};
  all.half_way = 0.5 * (to - from);
  all.half_way_mm = all.half_way.norm();
  const double length = all.half_way.squaredNorm();
  const auto beside_mm = [&](const Vec3& tip) {
    const Vec3 along = tip - all.middle.tip;
    const double share = length > 0 ? std::clamp(along.dot(all.half_way) / length, -1.0, 1.0) : 0;
    return (along - share * all.half_way).norm();
  };
  const auto include = [&](const Core& core, const CompiledTool* cutter) {
    if (cutter != stretches_[between].cutter) all.beside_mm = kNever;
    for (const double end : {-1.0, 1.0})
      all.beside_mm = std::max(all.beside_mm, beside_mm(core.middle.tip + end * core.half_way) + core.beside_mm);
    all.turn_rad = std::max(all.turn_rad, turn_at_most_rad(core.middle.axis, all.middle.axis) + core.turn_rad);
  };
  if (node.last - node.first > kSmallNode) {
    for (const std::uint32_t child : {index + 1, node.second})
      include(nodes_[child].core, stretches_[nodes_[child].first].cutter);
    return;
  }
  for (std::uint32_t i = node.first; i < node.last; ++i) include(cores_[i], stretches_[i].cutter);
}

// Let u be the point in the cutter's frame at the middle pose. The tip moves by w, which is at most half of the way plus
// a distance beside it, and the axis turns by an angle. So u moves by -w, by a vector across u of length angle |u|, and
// by at most angle |w| + angle^2 |u| / 2 more. The distance from a convex cutter is a convex function of u, so it changes
// by no less than its gradient states. From any other cutter, it changes by no more than u moves. A triangle turns about
// the point too.
bool CutterSweep::is_beyond(const Core& core, const CutterStretch& of, const Vec3& point, double within_mm,
                            const Corners* corners) {
  const Vec3 from_tip = point - core.middle.tip;
  const Vec3 &axis = core.middle.axis, &half_way = core.half_way;
  const double z = from_tip.dot(axis);
  const Vec3 across = from_tip - z * axis;
  const double r = across.norm(), far = r + std::abs(z), turn = core.turn_rad;
  const double way = core.half_way_mm + core.beside_mm;
  double radius = 0;
  if (corners != nullptr) {
    for (const Vec3& corner : *corners) radius = std::max(radius, corner.norm());
  }
  if (!of.is_convex) return signed_distance_mm(*of.cutter, r, z) > way + (far + way) * turn + radius + within_mm;
  const ToolDistance at = evaluate(*of.cutter, r, z);
  const double outwards = r > 0 ? at.normal.x() / r : 0;
  double nearer = 0;
  if (corners != nullptr) {
    const Vec3 gradient = outwards * across + at.normal.y() * axis;
    for (const Vec3& corner : *corners) nearer = std::max(nearer, -gradient.dot(corner));
  }
  const double along = std::abs(outwards * across.dot(half_way) + at.normal.y() * axis.dot(half_way));
  const double lever = std::abs(r * at.normal.y() - z * at.normal.x());
  const double moved = along + core.beside_mm + turn * (lever + way + radius + 0.5 * turn * far);
  return at.signed_distance_mm > moved + nearer + within_mm;
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
      if (!skip(cores_[i], stretches_[i]) && look(i)) return true;
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
    const Node& of = nodes_[child];
    return box_mm <= std::max(within(), 0.0) && !skip(of.core, stretches_[of.first]);
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
    const auto within = [&] { return std::min(found, upper_cutoff_mm); };
    const auto skip = [&](const Core& core, const CutterStretch& of) { return is_beyond(core, of, point, within()); };
    visit(
        0, points, within, skip, [&](std::uint32_t i) { return i != first && look(i); }, hint.work);
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
  const auto skip = [&](const Core& core, const CutterStretch& of) { return is_beyond(core, of, points.front(), 0); };
  const bool is_found =
      (hint.piece < stretches_.size() && look(hint.piece)) || visit(0, points, inside, skip, look, hint.work);
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
  const Corners from_middle = {corners[0] - middle, corners[1] - middle, corners[2] - middle};
  // The deepest point moves as far as the tip, plus its distance from the tip times the turn.
  const auto skip = [&](const Core& core, const CutterStretch& of) {
    const double moved_mm = core.half_way_mm + core.beside_mm + std::abs(of.cutter->core.y()) * core.turn_rad;
    return behind(core.middle, *of.cutter) > radius + moved_mm || is_beyond(core, of, middle, -deep_mm, &from_middle);
  };
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
             0, {&middle, 1}, [&] { return radius - deep_mm; }, skip, look, hint.work);
}

}  // namespace gouge
