#pragma once

#include <cstdint>
#include <vector>

#include "lib/check/motion.h"
#include "lib/geom/vec.h"

// Intervals of a move, halved on demand, and the tool frames at their ends.

namespace gouge {

/// Tool coordinates at one instant: x along the rotation axis of the move, z along the tool axis.
struct ToolFrame {
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  Vec3 tip = Vec3::Zero();
  [[nodiscard]] Vec3 to_tool(const Vec3& p_part) const { return rows * (p_part - tip); }
};

/// A part of a move within one of its stretches.
struct TimeSpan {
  double t0 = 0, t1 = 0;
  ToolFrame f0, f1;
  Vec3 tip_middle = Vec3::Zero();
  double tip_way_mm = 0;  ///< the tip's way over the span is no longer (a straight one is just as long)
  double sag_mm = 0;      ///< how far the tip may be from where it would be on the straight chord
  double turn_rad = 0;    ///< rotation over the span
  std::uint32_t stretch = 0;
  std::int32_t children = -1;  ///< first of two, once halved

  /// How far the path of a point, `distance_mm` or less from the tip at mid span, may bulge from the straight
  /// chord between its places at the two ends, in tool coordinates. Proof:
  /// docs/algorithms/certified_sweep.md.
  [[nodiscard]] double bulge_mm(double distance_mm) const {
    return (2 * turn_rad * tip_way_mm + turn_rad * turn_rad * (distance_mm + 0.5 * tip_way_mm)) / 8 + sag_mm;
  }
};

class TimeSpans {
 public:
  /// Requires motion.is_defined().
  explicit TimeSpans(const Motion& motion);

  [[nodiscard]] const std::vector<std::uint32_t>& roots() const { return roots_; }
  [[nodiscard]] const TimeSpan& span(std::uint32_t index) const { return spans_[index]; }
  /// Whether halving can still tell instants apart.
  [[nodiscard]] bool can_halve(std::uint32_t index) const;
  /// Index of the first half; the second follows. Requires can_halve.
  std::uint32_t halve(std::uint32_t index);
  [[nodiscard]] ToolFrame frame_at(double t, std::uint32_t stretch) const;

 private:
  [[nodiscard]] TimeSpan make(double t0, double t1, std::uint32_t stretch) const;

  const Motion& motion_;
  std::vector<TimeSpan> spans_;
  std::vector<std::uint32_t> roots_;
};

}  // namespace gouge
