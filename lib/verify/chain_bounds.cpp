#include "lib/verify/chain_bounds.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

/// Sine and cosine of an angle of any number of turns.
SineCosine of_angle(const Bounds& angle) {
  const Bounds whole_turn(6.283185307179586, 6.283185307179587);
  const double turns = std::round(0.5 * (angle.inf() + angle.sup()) / 6.283185307179586);
  return sine_cosine(angle - Bounds(turns) * whole_turn);
}

Bounds3 turned(const Bounds3& direction, const SineCosine& by, const Bounds3& x) {
  return by.cosine * x + by.sine * cross(direction, x) + ((Bounds(1) - by.cosine) * dot(direction, x)) * direction;
}

/// A direction as written in doubles, which are not quite of length 1.
Bounds3 unit(const Vec3& direction) { return direction_of(Bounds3(direction)); }

/// The pose with all joints at 0.
PoseBounds rest_of(const ClaimedJoints& joints) {
  const Bounds3 axis = unit(joints.rest.rotation.col(2));
  return {Bounds3(joints.rest.shift) - Bounds(joints.tool_length_mm) * axis, axis};
}

PoseBounds pose_of(const ClaimedJoints& joints, const ChainValues& values) {
  PoseBounds pose = rest_of(joints);
  for (std::size_t k = kChainJoints; k-- > 0;) {
    const ClaimedJoint& joint = joints.chain[k];
    const Bounds3 d = unit(joint.direction), p(joint.point);
    if (!joint.is_rotary) {
      pose.tip = pose.tip + values[k] * d;
      continue;
    }
    const SineCosine by = of_angle(values[k]);
    pose.tip = p + turned(d, by, pose.tip - p);
    pose.axis = turned(d, by, pose.axis);
  }
  return pose;
}

Bounds triple(const Bounds3& a, const Bounds3& b, const Bounds3& c) { return dot(a, cross(b, c)); }

bool stands(const ClaimedJoint& joint, const Bounds& by) {
  return CGAL::abs(by).sup() <= (joint.is_rotary ? kClaimedStand_rad : kClaimedStand_mm);
}

/// The shares of a move that joints need at their own rates; 1 for those that stand. None: a rate is missing.
std::optional<ChainValues> arrivals_of(const ClaimedJoints& joints, const ChainValues& from, const ChainValues& to) {
  ChainValues minutes, arrivals;
  minutes.fill(Bounds(0));
  arrivals.fill(Bounds(1));
  Bounds longest(0);
  std::vector<std::size_t> moving;
  bool is_known = true;
  for (std::size_t k = 0; k < kChainJoints; ++k) {
    const Bounds by = to[k] - from[k];
    if (stands(joints.chain[k], by)) continue;
    moving.push_back(k);
    is_known = is_known && joints.chain[k].rate && *joints.chain[k].rate > 0;
    if (!is_known) continue;
    minutes[k] = CGAL::abs(by) / Bounds(*joints.chain[k].rate);
    longest = {std::max(longest.inf(), minutes[k].inf()), std::max(longest.sup(), minutes[k].sup())};
  }
  if (moving.size() < 2) return arrivals;
  if (!is_known || !(longest.inf() > 0)) return std::nullopt;
  for (const std::size_t k : moving) {
    const Bounds share = minutes[k] / longest;
    arrivals[k] = {share.inf(), std::min(share.sup(), 1.0)};
    if (!(arrivals[k].inf() > 0)) return std::nullopt;
  }
  return arrivals;
}

/// The farthest that the tip is from the axis of any joint.
double reach_mm(const ClaimedJoints& joints, const ChainValues& from, const ChainValues& to) {
  Bounds reach = Bounds(joints.tool_length_mm) + length(Bounds3(joints.rest.shift));
  for (std::size_t k = 0; k < kChainJoints; ++k) {
    const ClaimedJoint& joint = joints.chain[k];
    if (joint.is_rotary)
      reach = reach + Bounds(2) * length(Bounds3(joint.point));
    else
      reach = reach + Bounds(std::max(CGAL::abs(from[k]).sup(), CGAL::abs(to[k]).sup()));
  }
  return reach.sup();
}

/// Arrivals that are not surely apart, in their order: the joints of one arrive within `at`.
struct Break {
  Bounds at;
  std::vector<std::size_t> joints;
};

std::vector<Break> breaks_of(const ChainValues& arrivals) {
  std::array<std::size_t, kChainJoints> order{0, 1, 2, 3, 4};
  std::ranges::sort(order, {}, [&](std::size_t k) { return arrivals[k].inf(); });
  std::vector<Break> breaks;
  for (const std::size_t k : order) {
    if (!breaks.empty() && arrivals[k].inf() <= breaks.back().at.sup())
      breaks.back() = {hull(breaks.back().at, arrivals[k]), std::move(breaks.back().joints)};
    else
      breaks.push_back({arrivals[k], {}});
    breaks.back().joints.push_back(k);
  }
  return breaks;
}

}  // namespace

PoseBounds ChainSpan::pose(std::size_t end) const { return pose_of(*joints, values[end]); }

// With r and v the point and its velocity at the start, |v(t) - v| <= A and |r(t) - r| <= |v| + A / 2 in a unit of time.
Bounds ChainSpan::tip_acceleration() const {
  Bounds3 tip = rest_of(*joints).tip, velocity;
  Bounds most(0);
  for (std::size_t k = kChainJoints; k-- > 0;) {
    const ClaimedJoint& joint = joints->chain[k];
    const Bounds3 d = unit(joint.direction), p(joint.point);
    const Bounds rate = values[1][k] - values[0][k], w = CGAL::abs(rate);
    if (!joint.is_rotary) {
      tip = tip + values[0][k] * d;
      velocity = velocity + rate * d;
      continue;
    }
    const Bounds3 r = tip - p, around = cross(d, r);
    most = most + Bounds(2) * w * (length(cross(d, velocity)) + most) +
           w * w * (length(around) + length(velocity) + Bounds(0.5) * most);
    const SineCosine by = of_angle(values[0][k]);
    tip = p + turned(d, by, r);
    velocity = turned(d, by, velocity + rate * around);
  }
  return most;
}

Bounds ChainSpan::axis_acceleration() const {
  Bounds rates(0);
  for (const std::size_t k : joints->rotary) rates = rates + CGAL::abs(values[1][k] - values[0][k]);
  return CGAL::square(rates);
}

std::array<ChainSpan, 2> ChainSpan::halves() const {
  std::array<ChainSpan, 2> both{*this, *this};
  both[0].values[1] = both[1].values[0] = values_at(values[0], values[1], Bounds(0.5));
  return both;
}

std::optional<ChainValues> chain_values(const ClaimedJoints& joints, const RotaryAngles& angles, const Vec3& tip) {
  ChainValues values;
  values.fill(Bounds(0));  // a default interval has no value
  for (std::size_t k = 0; k < 2; ++k) values[joints.rotary[k]] = Bounds(angles[k]);
  const Bounds3 rest = Bounds3(tip) - pose_of(joints, values).tip;
  // The tip moves with a linear joint along its direction, turned by the rotary joints before it.
  std::vector<std::size_t> linear;
  std::vector<Bounds3> ways;
  for (std::size_t k = 0; k < kChainJoints; ++k) {
    if (joints.chain[k].is_rotary) continue;
    Bounds3 way = unit(joints.chain[k].direction);
    for (std::size_t j = k; j-- > 0;)
      if (joints.chain[j].is_rotary) way = turned(unit(joints.chain[j].direction), of_angle(values[j]), way);
    linear.push_back(k);
    ways.push_back(way);
  }
  if (linear.size() != 3) return std::nullopt;
  const Bounds whole = triple(ways[0], ways[1], ways[2]);
  if (whole.inf() <= 0 && whole.sup() >= 0) return std::nullopt;
  values[linear[0]] = triple(rest, ways[1], ways[2]) / whole;
  values[linear[1]] = triple(ways[0], rest, ways[2]) / whole;
  values[linear[2]] = triple(ways[0], ways[1], rest) / whole;
  return values;
}

ChainValues values_at(const ChainValues& from, const ChainValues& to, const Bounds& share) {
  ChainValues values;
  // The true value is in both: the first is narrow where the ends are wide (halving widens nothing), the second where the
  // share is.
  for (std::size_t k = 0; k < kChainJoints; ++k) {
    const Bounds a = (Bounds(1) - share) * from[k] + share * to[k], b = from[k] + share * (to[k] - from[k]);
    values[k] = {std::max(a.inf(), b.inf()), std::min(a.sup(), b.sup())};
  }
  return values;
}

std::optional<std::vector<ChainSpan>> chain_spans(const ClaimedJoints& joints, ClaimedRun run, const ChainValues& from,
                                                  const ChainValues& to) {
  ChainSpan whole{&joints, {from, to}, true, 0, 0};
  if (run != ClaimedRun::independent) return std::vector<ChainSpan>{whole};
  const auto arrivals = arrivals_of(joints, from, to);
  if (!arrivals) return std::nullopt;
  const double reach = reach_mm(joints, from, to);
  std::vector<ChainSpan> spans;
  ChainValues last = from;
  // The real break is the last arrival in `at`; before it a joint of the break may stand already, by no more than `late`.
  for (const Break& one : breaks_of(*arrivals)) {
    ChainSpan span{&joints, {last, to}, true, 0, 0};
    for (std::size_t k = 0; k < kChainJoints; ++k) {
      const Bounds share = one.at / (*arrivals)[k];
      if (share.inf() < 1) {
        const Bounds reached = values_at(from, to, Bounds(share.inf(), std::min(share.sup(), 1.0)))[k];
        span.values[1][k] = share.sup() >= 1 ? hull(reached, to[k]) : reached;
      }
    }
    Bounds late(0), late_rad(0);
    for (const std::size_t k : one.joints) {
      const Bounds width = Bounds(one.at.sup()) - Bounds(one.at.inf());
      const Bounds by = CGAL::abs(to[k] - from[k]) / (*arrivals)[k] * width;
      late = late + (joints.chain[k].is_rotary ? Bounds(reach) * by : by);
      if (joints.chain[k].is_rotary) late_rad = late_rad + by;
    }
    span.slack_mm = late.sup();
    span.slack = late_rad.sup();
    last = span.values[1];
    spans.push_back(span);
  }
  return spans;
}

}  // namespace gouge
