#include "lib/contact/nearest_instant.h"

#include <algorithm>
#include <cmath>

#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

constexpr int kMaxLooks = 40;      // maximum number of distances for a convex cutter, which takes two to five
constexpr int kMaxHalvings = 12;   // maximum number of halvings for a cutter that is not convex
constexpr double kMinStep = 0.02;  // share of the remaining time: a new instant is at least this far from the ones
                                   // before

/// Returns `v` in the axes of the first pose, after the turn that takes the axis of the second pose onto that of the
/// first.
Vec3 turned_back(const Vec3& v, const Vec3& first, const Vec3& second) {
  const Vec3 both = first + second;
  return v - both * (both.dot(v) / (1 + first.dot(second))) + 2 * second.dot(v) * first;
}

}  // namespace

NearestInstant::NearestInstant(const CutterStretch& stretch, std::span<const Vec3> points) : stretch_(stretch) {
  for (const Vec3& point : points) add(point);
}

NearestInstant::NearestInstant(const CutterStretch& stretch, const Vec3& middle, const std::array<Vec3, 3>& corners)
    : stretch_(stretch), corners_(&corners) {
  for (const Vec3& corner : corners) radius_mm_ = std::max(radius_mm_, corner.norm());
  add(middle);
  slack_mm_ += radius_mm_ * stretch.angle_rad;
}

// Adds a point. In the cutter's frame u = p - tip is turned back by the turn up to that instant. So the second
// derivative of the position of p there is at most angle^2 |u| + 2 angle |tip'|. Its deviation from the chord is at
// most an eighth of that.
void NearestInstant::add(const Vec3& point) {
  const Vec3 first = point - stretch_.start.tip;
  Vec3 last = point - stretch_.end.tip;
  const double angle = stretch_.angle_rad;
  const double path = (stretch_.end.tip - stretch_.start.tip).norm();
  const double far = std::max(first.norm(), last.norm());
  if (angle > 0) last = turned_back(last, stretch_.start.axis, stretch_.end.axis);
  Way& way = ways_[count_++];
  const Vec3& axis = stretch_.start.axis;
  const Vec3 change = last - first;
  way.z = first.dot(axis);
  way.z_change = change.dot(axis);
  way.across = first - way.z * axis;
  way.across_change = change - way.z_change * axis;
  speed_mm_ = std::max(speed_mm_, change.norm());
  slack_mm_ = std::max(slack_mm_, stretch_.off_mm + angle * (angle * far + 2 * path) / 8);
}

/// Measures the distance at time t along the chord, and keeps it if it is the smallest so far.
NearestInstant::Look NearestInstant::look(double t) {
  Look most{t, -std::numeric_limits<double>::infinity(), 0, 0};
  for (std::size_t k = 0; k < count_; ++k) {
    const Way& way = ways_[k];
    const Vec3 across = way.across + t * way.across_change;
    const double r = across.norm();
    const ToolDistance at = evaluate(*stretch_.cutter, r, way.z + t * way.z_change);
    if (at.signed_distance_mm <= most.value) continue;
    // On the axis, the mean of the gradients in all directions beside it is a valid gradient too.
    const Vec3 beside = r > 0 ? Vec3(at.normal.x() / r * across) : Vec3(Vec3::Zero());
    most.value = most.least = at.signed_distance_mm;
    most.slope = beside.dot(way.across_change) + at.normal.y() * way.z_change;
    if (corners_ == nullptr) continue;
    const Vec3 gradient = beside + at.normal.y() * stretch_.start.axis;
    most.least += std::min({gradient.dot((*corners_)[0]), gradient.dot((*corners_)[1]), gradient.dot((*corners_)[2])});
  }
  found_mm_ = std::min(found_mm_, most.value);
  return most;
}

void NearestInstant::search(double lower_cutoff_mm, double upper_cutoff_mm) {
  lower_cutoff_mm_ = lower_cutoff_mm - slack_mm_;
  upper_cutoff_mm_ = upper_cutoff_mm + slack_mm_;
  if (stretch_.is_convex) return search_convex();
  halve(look(0), look(1), 0);
}

bool NearestInstant::is_settled(double under_mm, double min_mm) const {
  return found_mm_ <= lower_cutoff_mm_ || under_mm > upper_cutoff_mm_ || found_mm_ - min_mm < kInstantGap_mm;
}

// Searches with a convex cutter. A convex function lies above all of its tangents. If two tangents fall towards one
// another, their crossing bounds it; for a single tangent, the bound is its lower end.
void NearestInstant::search_convex() {
  Look falling, rising;
  bool is_falling = false, is_rising = false;
  double t = 0.5;
  bound_mm_ = -std::numeric_limits<double>::infinity();
  for (int looks = 1;; ++looks) {
    const Look now = look(t);
    (now.slope < 0 ? falling : rising) = now;
    (now.slope < 0 ? is_falling : is_rising) = true;
    double least = 0, under = 0;  // bound for the point, and bound for the triangle around it
    const double apart = rising.t - falling.t;
    const double bend = rising.slope - falling.slope;
    double crossing = 0.5;
    if (is_falling && is_rising) {
      crossing = (falling.value - rising.value + rising.slope * apart) / bend;
      least = falling.value + falling.slope * crossing;
      under = falling.least + falling.slope * (falling.least - rising.least + rising.slope * apart) / bend;
    } else {
      const double rest = is_falling ? 1 - falling.t : -rising.t;
      least = now.value + now.slope * rest;
      under = now.least + now.slope * rest;
    }
    bound_mm_ = std::max(bound_mm_, under);
    if (looks == kMaxLooks || is_settled(under, least)) return;
    if (!is_falling || !is_rising) {
      t = is_falling ? 1 : 0;
      continue;
    }
    // On a smooth function the slope is about linear; at a kink the tangents cross.
    const double step = looks % 2 != 0 ? crossing / apart : -falling.slope / bend;
    t = falling.t + std::clamp(step, kMinStep, 1 - kMinStep) * apart;
  }
}

void NearestInstant::halve(const Look& first, const Look& last, int level) {
  const double known = std::min(first.value, last.value);
  const double least = std::min(known, 0.5 * (first.value + last.value - speed_mm_ * (last.t - first.t)));
  if (level == kMaxHalvings || found_mm_ <= lower_cutoff_mm_ || least - radius_mm_ > upper_cutoff_mm_ ||
      known - least < kInstantGap_mm) {
    bound_mm_ = std::min(bound_mm_, least - radius_mm_);
    return;
  }
  const Look middle = look(0.5 * (first.t + last.t));
  halve(first, middle, level + 1);
  if (found_mm_ > lower_cutoff_mm_) halve(middle, last, level + 1);
}

}  // namespace gouge
