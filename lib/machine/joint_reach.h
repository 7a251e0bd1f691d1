#pragma once

#include <memory>
#include <optional>

#include "lib/machine/linear_limits.h"
#include "lib/motion/pose_reach.h"

namespace gouge {

/// The reach of a machine near a path: its rotary joints within their limits, and its linear joints too where
/// check_linear_limits compares them.
///
/// The joints follow the tool axis from its direction in the path to that of the pose. They leave the angles of the path
/// in the way in which choose_joints takes the nearest ones, and never pass to the other solution. Only at a pole may the
/// limits decide between both solutions. A pose is out of reach if the joints end beyond a limit, or if two turns from a
/// pole are equally near. A margin of two digits of a file is kept. Limits that are not known do not count.
class JointReach : public PoseReach {
 public:
  /// `path` must outlive it, with the angles of Toolpath::joints. `tool_length_mm`: as in gauge_length_of_move.
  JointReach(Machine machine, const Toolpath& path, std::optional<double> tool_length_mm);

  [[nodiscard]] bool can_reach(std::size_t move, const Vec3& programmed, const Pose& pose) const override;
  [[nodiscard]] std::string why_not(std::size_t move, const Vec3& programmed, const Pose& pose) const override;

 private:
  /// Returns what keeps the machine from a pose; none: nothing does.
  [[nodiscard]] std::optional<JointProblem> find_problem(std::size_t move, const Vec3& programmed,
                                                         const Pose& pose) const;
  [[nodiscard]] RotaryAngles angles_of(std::size_t move, const Vec3& programmed) const;
  [[nodiscard]] std::optional<JointProblem> leave_pole(std::size_t move, const Vec3& axis, RotaryAngles& angles) const;
  [[nodiscard]] std::optional<JointProblem> find_rotary_problem(std::size_t move, const Vec3& axis,
                                                                const RotaryAngles& angles) const;
  [[nodiscard]] std::optional<JointProblem> find_linear_problem(std::size_t move, const Vec3& tip,
                                                                const RotaryAngles& angles) const;

  Machine machine_, unlimited_;
  const Toolpath& path_;
  std::optional<double> tool_length_mm_;
  LinearLimitTest linear_;
};

}  // namespace gouge
