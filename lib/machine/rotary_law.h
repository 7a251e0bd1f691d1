#pragma once

#include <memory>
#include <string>

#include "lib/machine/joint_path.h"
#include "lib/motion/axis_law.h"

namespace gouge {

/// The law "axis": the tip on its line or curve, both rotary joints evenly in one parameter. Siemens ORIAXES and
/// LinuxCNC promise it (docs/method/machine.md). With a wider scope it is the law "documented" or "any".
class RotaryLaw : public AxisLaw {
 public:
  explicit RotaryLaw(Machine machine, LawScope scope = LawScope::one) : machine_(std::move(machine)), scope_(scope) {}

  /// Returns the nearest angles of both directions, the first joint standing where one of them is a pole. Null where
  /// the machine does not reach one of them.
  [[nodiscard]] std::shared_ptr<const AxisPath> between(const Pose& from, const Pose& to) const override;
  /// Returns the angles chosen for the path, where they are those of the directions; else as `between`.
  [[nodiscard]] std::shared_ptr<const AxisPath> of_move(const Toolpath* path, std::size_t move, const Pose& from,
                                                        const Pose& to) const override;
  [[nodiscard]] LawScope scope() const override { return scope_; }
  [[nodiscard]] std::string name() const override;

 private:
  Machine machine_;
  LawScope scope_;
};

/// Rotary angles at both ends of a motion.
struct AngleRange {
  RotaryAngles from{}, to{};
};

/// Returns the nearest angles of both axes: the first joint stands where one of them is a pole. None: the machine does
/// not reach one of them.
[[nodiscard]] std::optional<AngleRange> nearest_angles(const Machine& machine, const Vec3& from, const Vec3& to);

/// Returns the angles chosen for a move of a path, where they are those of the axes; else `nearest_angles`. A position
/// alone stands at the angles of its end. `joints` may be null.
[[nodiscard]] std::optional<AngleRange> angles_of_move(const Machine& machine, const JointPath* joints,
                                                       std::size_t move, const Vec3& from, const Vec3& to);

/// Makes the path of a tool that stands at an axis that the machine does not reach.
[[nodiscard]] std::shared_ptr<const AxisPath> standing_at(const Vec3& axis);

/// Returns the largest angle between the tool axis of both rotary joints running evenly and that on the great circle,
/// rad, to about 1e-6. Requires directions that are not opposite.
[[nodiscard]] double largest_gap_rad(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to);

}  // namespace gouge
