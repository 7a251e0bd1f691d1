#pragma once

#include <array>
#include <optional>
#include <string>

#include "lib/base/diagnostic.h"
#include "lib/machine/kinematics.h"
#include "postproc/gcode/running/program_setup.h"

namespace gouge {

/// Way in which the coordinates of a program become those of the tip.
enum class TipControl : std::uint8_t {
  off,            ///< the coordinates are those of the joints
  on,             ///< the coordinates are those of the tip on the part
  turned_offset,  ///< directions of the joints, from the work zero that the table has turned
  unknown         ///< nothing states which
};

/// A frame of the program: shift, turn, mirror and scale, without a motion of the tool's axis. The map x -> linear * x + shift,
/// mm.
struct ProgramFrame {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 point(const Vec3& x) const { return linear * x + shift; }
  /// Returns the frame that applies `inner` first.
  [[nodiscard]] ProgramFrame after(const ProgramFrame& inner) const {
    return {linear * inner.linear, linear * inner.shift + shift};
  }
};

/// Frame and length that are in force for positions.
struct AxisFrame {
  TipControl tip_control = TipControl::off;
  Vec3 shift_mm = Vec3::Zero();  ///< work zero from machine zero of the joint values
  RotaryAngles tip_frame{0,
                         0};  ///< rad; with the table there, coordinates of tool centre point control lie in `shift_mm`
  std::optional<RigidTransform> plane;  ///< tilted frame, in the coordinates of the work offset
  std::optional<ProgramFrame> frame;    ///< in the coordinates of `plane`, or of the work offset
  bool is_aligned = false;              ///< the tool axis is that of the tilted frame
  double tool_length_mm = 0;            ///< from the gauge point to the tip
  double excess_length_mm = 0;          ///< length that the control applies, beyond the true one
  std::string open_length;              ///< why these lengths are not known; empty: they are
  bool is_length_in_offset = false;     ///< the control applies none, as the work offset includes it along its Z
};

/// Tip in part coordinates from coordinates of the program: tip = linear * xyz + origin.
struct AxisMap {
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
  Vec3 origin = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();     ///< tool axis
  std::string open;              ///< why the map is not known; empty: it is
  bool is_open_along_z = false;  ///< only the length is not known, which moves the tip along Z

  [[nodiscard]] Vec3 tip(const Vec3& xyz) const { return linear * xyz + origin; }
  [[nodiscard]] Vec3 coordinates(const Vec3& tip_mm) const {
    return linear.partialPivLu().solve(Vec3(tip_mm - origin));
  }
};

/// Makes the maps of a machine; without a machine the coordinates are those of the part, and the tool axis is z.
class AxisMapper {
 public:
  /// `control` is the id of the language of the program.
  AxisMapper(const Machine* machine, const std::string& control);

  /// Returns the map with these rotary angles (rad, unknown where they are not numbers).
  [[nodiscard]] AxisMap map(const AxisFrame& state, const RotaryAngles& angles) const;
  /// Returns whether the tip is elsewhere if the work offset includes the tool length, along its Z: where the tool is not
  /// along Z, or the control turns positions about a point that it takes for the tip.
  [[nodiscard]] bool needs_applied_length(const AxisFrame& state, const RotaryAngles& angles) const;
  [[nodiscard]] bool has_machine() const { return machine_ != nullptr; }
  /// Returns why a motion is not known if the positions of the rotary joints are not, with the words that state them.
  [[nodiscard]] std::string unknown_angles() const;
  /// Returns why a motion is not known if nothing states TipControl, with the words that state it.
  [[nodiscard]] std::string unknown_tip_control() const;
  /// Returns the place of a rotary joint by its letter in RotaryAngles; none: the machine has none of this name.
  [[nodiscard]] std::optional<std::size_t> rotary_of(char letter) const;

 private:
  [[nodiscard]] AxisMap at_joints(const Vec3& shift_mm, const RotaryAngles& angles, double length_mm) const;
  [[nodiscard]] std::string missing_point(const RotaryAngles& angles) const;

  const Machine* machine_;
  std::string control_;
  std::array<std::size_t, 3> linear_{};  // joints of X, Y and Z
  AxisMap at_zero_;                      // with all joints at 0
};

/// Returns whether a rotary joint has ends: it then shows every turn, and does not roll over.
[[nodiscard]] inline bool has_ends(const Joint& joint) { return joint.min && joint.max && !joint.is_continuous; }

/// Returns the error that a program turns a rotary axis that the machine does not have; null: no machine is stated.
[[nodiscard]] Diagnostic describe_missing_axis(char letter, const Machine* machine, const std::string& file,
                                               std::size_t line);

/// Returns whether a length that the control applies along Z, and that is the true one, moves the tip without tool centre
/// point control. It does where the tool is not along Z.
[[nodiscard]] bool needs_true_length(const Machine& machine);

/// Returns why a machine cannot run programs: a linear joint that is not X, Y or Z. Empty: it can.
[[nodiscard]] std::string describe_unfit(const Machine& machine);

}  // namespace gouge
