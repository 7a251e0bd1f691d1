#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lib/machine/machine.h"
#include "lib/motion/axis_law.h"

namespace gouge {

/// When the joints of a machine run without tool centre point control.
enum class JointTiming {
  together,     ///< all start and arrive together, each linearly in one parameter
  independent,  ///< all start together, each at its own rate until it arrives
  unknown       ///< nothing states it: motions of several joints are open
};

/// The laws "joint" and "independent": the joints run, and tip and axis follow the forward kinematics. Proofs and sources:
/// docs/method/machine.md.
class JointLaw : public AxisLaw {
 public:
  /// `tool_length_mm`: from the gauge point to the tip, as in gauge_length_of_move; none: only the tools of the path state
  /// it. Not every machine needs it (depends_on_tool_length). Requires the points of rotary joints.
  JointLaw(Machine machine, JointTiming timing, std::optional<double> tool_length_mm)
      : machine_(std::make_shared<const Machine>(std::move(machine))),
        timing_(timing),
        tool_length_mm_(tool_length_mm) {}

  /// Uses the nearest angles of both axes. Returns null if the machine cannot reach one of them, or if a joint without a
  /// rate runs independently beside others. The same if the motion depends on a tool length or a part zero that is not known.
  [[nodiscard]] std::shared_ptr<const AxisPath> between(const Pose& from, const Pose& to) const override;
  /// Uses the angles chosen for the path if they give both axes; otherwise the same as `between`.
  [[nodiscard]] std::shared_ptr<const AxisPath> of_move(const Toolpath* path, std::size_t move, const Pose& from,
                                                        const Pose& to) const override;
  [[nodiscard]] std::string why_open(const Toolpath& path, std::size_t move) const override;
  [[nodiscard]] bool bends_without_turning() const override { return timing_ != JointTiming::together; }
  [[nodiscard]] std::string name() const override;

 private:
  /// Returns the tool length of a motion; 0 where no motion depends on it. None: it is not known.
  [[nodiscard]] std::optional<double> length_of(const Toolpath* path, std::size_t move) const;
  /// Returns whether the motions depend on a part zero that is not known.
  [[nodiscard]] bool lacks_part_zero() const;

  std::shared_ptr<const Machine> machine_;
  JointTiming timing_;
  std::optional<double> tool_length_mm_;
};

}  // namespace gouge
