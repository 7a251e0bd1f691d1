#include "lib/check/time_spans.h"

#include <algorithm>
#include <cmath>

namespace gouge {

namespace {
constexpr double kShortestSpan = 1e-12;
}

TimeSpans::TimeSpans(const Motion& motion) : motion_(motion) {
  for (std::uint32_t s = 0; s < motion.stretches().size(); ++s) {
    const TipStretch& stretch = motion.stretches()[s];
    roots_.push_back(s);
    spans_.push_back(make(stretch.t0, motion.is_alone() ? stretch.t0 : stretch.t1, s));
  }
}

bool TimeSpans::can_halve(std::uint32_t index) const {
  return spans_[index].t1 - spans_[index].t0 > kShortestSpan;
}

std::uint32_t TimeSpans::halve(std::uint32_t index) {
  if (spans_[index].children < 0) {
    const auto [t0, t1, stretch] = std::tuple(spans_[index].t0, spans_[index].t1, spans_[index].stretch);
    const double middle = 0.5 * (t0 + t1);
    spans_[index].children = static_cast<std::int32_t>(spans_.size());
    spans_.push_back(make(t0, middle, stretch));
    spans_.push_back(make(middle, t1, stretch));
  }
  return static_cast<std::uint32_t>(spans_[index].children);
}

ToolFrame TimeSpans::frame_at(double t, std::uint32_t stretch) const {
  const Vec3& start_axis = motion_.start().axis;
  const Vec3& turn_axis = motion_.rotation_axis();
  ToolFrame frame;
  frame.tip = motion_.tip_at(t, stretch);
  const double turned = motion_.angle_rad() * t;
  const Vec3 axis = std::cos(turned) * start_axis + std::sin(turned) * turn_axis.cross(start_axis);
  frame.rows.row(0) = turn_axis;
  frame.rows.row(1) = axis.cross(turn_axis);
  frame.rows.row(2) = axis;
  return frame;
}

TimeSpan TimeSpans::make(double t0, double t1, std::uint32_t stretch) const {
  TimeSpan span;
  span.t0 = t0;
  span.t1 = t1;
  span.stretch = stretch;
  span.f0 = frame_at(t0, stretch);
  span.f1 = frame_at(t1, stretch);
  span.tip_middle = 0.5 * (span.f0.tip + span.f1.tip);
  span.tip_way_mm = motion_.way_mm(t0, t1, stretch);
  span.sag_mm = motion_.sag_mm(t0, t1, stretch);
  span.turn_rad = motion_.angle_rad() * (t1 - t0);
  return span;
}

}  // namespace gouge
