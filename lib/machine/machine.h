#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/geom/pose.h"

// A machine as the chain of its joints from the part to the tool. Directions and points are in part coordinates with
// all joints at 0. Positive means the motion of the tool relative to the part (ISO 841), also for joints that move the
// table.

namespace gouge {

enum class JointType { linear, rotary };
enum class JointSide { table, head };

struct Joint {
  std::string name;  ///< "X", "C"
  JointType type = JointType::linear;
  JointSide side = JointSide::head;
  Vec3 direction = Vec3::UnitX();  ///< unit; a rotary joint turns the tool about it by the right-hand rule
  Vec3 point = Vec3::Zero();       ///< on the axis of a rotary joint, mm; of a head joint relative to the gauge point
  bool has_point = false;          ///< the file states the point
  double point_slack_mm = 0;       ///< the true axis is at most this far from the axis through `point`
  std::optional<double> min, max;  ///< mm or rad; none: no limit is known
  bool is_continuous = false;      ///< a rotary joint may turn without end
  std::optional<double> rate;      ///< maximum speed, mm or rad per minute
  double preference = 0;           ///< of two solutions the one whose value has this sign is preferred; 0: none
};

[[nodiscard]] inline bool is_rotary(const Joint& joint) { return joint.type == JointType::rotary; }

/// Laws by which a control moves the tool between two positions. The first four keep the tip on its line or curve.
enum class TurnLaw {
  vector,      ///< the axis on the great circle
  axis,        ///< both rotary joints evenly from one position to the next
  documented,  ///< by vector or by axis: a move is clean if it is clean by both
  any,         ///< the rotary joints anywhere between their positions at both ends, whatever the control does
  joint,       ///< all joints evenly from one position to the next
  independent  ///< each joint at its own rate until it arrives; rapids alone
};
inline constexpr std::array<const char*, 6> kTurnLawNames = {"vector", "axis",  "documented",
                                                             "any",    "joint", "independent"};  // in this order
/// Feeds may run by any of the first so many.
inline constexpr std::size_t kFeedLaws = 5;
struct TurnLaws {
  TurnLaw feeds = TurnLaw::vector, rapids = TurnLaw::vector;
  /// Law of rapids without tool centre point control (Move::runs_joints): joint or independent; none: not known. Such feeds
  /// run by the law joint.
  std::optional<TurnLaw> joint_rapids = {};
};
[[nodiscard]] const char* turn_law_name(TurnLaw law);
/// Returns the law of that name; none where there is no such law.
[[nodiscard]] std::optional<TurnLaw> turn_law_called(const std::string& name);

/// Languages of programs, as a machine file names them.
inline const std::vector<std::string> kProgramLanguages = {"linuxcnc", "haas", "fanuc", "siemens", "heidenhain"};

struct Control {
  std::string name;
  std::optional<TurnLaw> feed_law, rapid_law;  ///< none: the manual promises none, so the user must give it
  std::string source;                          ///< manual and page
  /// Tolerances of the smoothing, mm and rad: maximum departure of tip and tool axis from the law; 0: none is stated.
  double tip_tolerance_mm = 0, axis_tolerance_rad = 0;
  std::optional<TurnLaw> joint_rapid_law = {};  ///< of rapids without tool centre point control: joint or independent
  std::string program = {};                     ///< one of kProgramLanguages; empty: not stated
  std::string start = {};                       ///< blocks in force at the start of a program: "G17 G21 G90"
  std::string unread_setting = {};              ///< setting that the readers of its programs do not follow; empty: none
};

struct Machine {
  std::string name;
  std::string source;         ///< of the kinematics
  std::vector<Joint> joints;  ///< from the part to the tool: three linear and two rotary
  Control control;
  /// Frame of the tool with all joints at 0, in part coordinates: the gauge point, and the tool axis as z.
  RigidTransform rest;
  bool is_placed = false;           ///< the part zero is known, so that limits of linear joints apply
  std::vector<std::size_t> unread;  ///< indices of the joints that its configuration does not describe

  /// Indices of the rotary joints in `joints`, that nearer to the part first.
  std::array<std::size_t, 2> rotary{};
  std::array<std::size_t, 3> linear{};
};

/// Fills in Machine::rotary and ::linear and normalises directions.
/// Errors (without a file): machine-joints. There are not three linear and two rotary joints, or linear directions lie
/// in one plane. Or rotary directions are parallel, a direction has no length, or a minimum is above the maximum. Or two
/// joints have the same name.
[[nodiscard]] Result<Machine> make_machine(Machine machine);

/// Returns whether a motion of the joints between two poses depends on the length of the tool. It does, unless a longer tool
/// shifts each linear joint by the same value at all rotary angles. Requires make_machine.
/// Proof: docs/method/machine.md, "Tool length".
[[nodiscard]] bool depends_on_tool_length(const Machine& machine);

/// Returns whether a motion of the joints between two poses depends on the place of the part on the machine. It does, unless
/// another place shifts each linear joint by the same value at all rotary angles. Requires make_machine.
/// Proof: docs/method/machine.md, "Place of the part".
[[nodiscard]] bool depends_on_part_zero(const Machine& machine);

/// Describes a machine in the coordinates of a part on it. `zero` maps part coordinates to machine coordinates, in which
/// the machine is described, with all joints at 0. Then directions, points and Machine::rest are in part coordinates.
/// Proof: docs/method/machine.md, "Part zero".
[[nodiscard]] Machine place_part(Machine machine, const RigidTransform& zero);

}  // namespace gouge
