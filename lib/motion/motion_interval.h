#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/motion/motion.h"

// Time intervals of a motion and their halving. The caller adds its data of an interval.

namespace gouge {

/// A time interval within one segment of a motion. Types with more data of one derive from it.
struct MotionInterval {
  double t0 = 0, t1 = 0;
  std::uint32_t segment = 0;

  [[nodiscard]] double middle() const { return 0.5 * (t0 + t1); }
};

/// Returns a whole segment; of no length where the motion is a single pose.
[[nodiscard]] inline MotionInterval whole_segment(const Motion& motion, std::uint32_t segment) {
  const MotionSegment& whole = motion.segments()[segment];
  return {whole.t0, motion.is_alone() ? whole.t0 : whole.t1, segment};
}

/// Returns both halves, the earlier one first. They keep all other data of the interval.
template <typename Interval>
[[nodiscard]] std::array<Interval, 2> halves(const Interval& whole) {
  std::array<Interval, 2> parts{whole, whole};
  parts[0].t1 = parts[1].t0 = whole.middle();
  return parts;
}

/// The segments of a motion, then their parts, halved on demand and once each. The type `Interval` derives from
/// MotionInterval. It is made from what moves (`Source`) and a MotionInterval.
template <typename Interval, typename Source>
class IntervalTree {
 public:
  /// Requires motion.is_defined(). `source` must outlive it.
  IntervalTree(const Source& source, const Motion& motion)
      : source_(source), segments_(static_cast<std::uint32_t>(motion.segments().size())) {
    for (std::uint32_t s = 0; s < segments_; ++s) add(whole_segment(motion, s));
  }

  /// Returns the number of segments, which come first.
  [[nodiscard]] std::uint32_t segments() const { return segments_; }
  [[nodiscard]] const Interval& operator[](std::uint32_t index) const { return intervals_[index]; }
  /// Returns whether halving can still distinguish instants.
  [[nodiscard]] bool can_halve(std::uint32_t index) const {
    constexpr double kShortest = Tolerance::kFewRoundings;
    return intervals_[index].t1 - intervals_[index].t0 > kShortest;
  }
  /// Index of the first half; the second follows. Requires can_halve.
  std::uint32_t halve(std::uint32_t index) {
    if (first_half_[index] == 0) {
      first_half_[index] = static_cast<std::uint32_t>(intervals_.size());
      for (const MotionInterval& half : halves<MotionInterval>(intervals_[index])) add(half);
    }
    return first_half_[index];
  }

 private:
  void add(const MotionInterval& interval) {
    intervals_.emplace_back(source_, interval);
    first_half_.push_back(0);
  }

  const Source& source_;
  std::uint32_t segments_;
  std::vector<Interval> intervals_;
  std::vector<std::uint32_t> first_half_;  // 0: not halved
};

}  // namespace gouge
