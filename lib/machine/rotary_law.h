#pragma once

#include <memory>
#include <string>

#include "lib/machine/joint_path.h"
#include "lib/motion/axis_law.h"

namespace gouge {

/// The law "axis": the tip on its line or curve, both rotary joints evenly in one parameter. Siemens ORIAXES and
/// LinuxCNC promise it (docs/method/machine.md).
class RotaryLaw : public AxisLaw {
 public:
  explicit RotaryLaw(Machine machine) : machine_(std::move(machine)) {}

  /// Returns the nearest angles of both directions, the first joint standing where one of them is a pole. Null where
  /// the machine reaches one of them not at all.
  [[nodiscard]] std::shared_ptr<const AxisPath> between(const Vec3& from, const Vec3& to) const override;
  /// Returns the angles chosen for the path, where they are those of the directions; else as `between`.
  [[nodiscard]] std::shared_ptr<const AxisPath> of_move(const JointPath* joints, std::size_t move, const Vec3& from,
                                                        const Vec3& to) const override;
  [[nodiscard]] std::string name() const override { return "axis of " + machine_.name; }

 private:
  Machine machine_;
};

/// Returns the largest angle between the tool axis of both rotary joints running evenly and that on the great circle,
/// rad, to about 1e-6. Requires directions that are not opposite.
[[nodiscard]] double largest_gap_rad(const Machine& machine, const RotaryAngles& from, const RotaryAngles& to);

}  // namespace gouge
