#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cli/machine/joint_facts.h"
#include "lib/machine/joint_path.h"
#include "lib/machine/machine.h"
#include "lib/motion/motion_law.h"

namespace gouge {

/// Begins a --machine that is not a file.
inline constexpr std::string_view kMachinePreset = "preset:";

/// Help of --machine.
inline constexpr const char* kMachineHelp =
    "Machine with its rotary joints and control laws: a machine file, a LinuxCNC configuration (INI), or "
    "preset:NAME (see 'gougecheck machine list')";

/// Help of --zero.
inline constexpr const char* kZeroHelp =
    "Part zero in machine coordinates with all joints at 0, x,y,z[,rx,ry,rz]: lengths in mm or with a unit (0.5in), then "
    "angles in degrees about the fixed axes X, Y, Z. Limits of linear joints then apply (default: not known, parallel to "
    "the axes of the machine)";

/// Help of --joint-rapid-law.
inline constexpr const char* kJointRapidLawHelp =
    "Law of rapid moves without tool centre point control in a program (G-code). joint: all joints arrive together. "
    "independent: each joint runs at its own rate (default: that of the control)";

/// Names of options in messages: those of the command line, or others.
struct MachineOptionNames {
  std::string machine = "--machine", feed_law = "--feed-law", rapid_law = "--rapid-law", rapid = "--rapid",
              tool_length = "--tool-length";
  JointOptionNames joints = {};
  std::string zero = "--zero";
  std::string joint_rapid_law = "--joint-rapid-law";
};

/// A machine and its laws as the user states them; laws: kTurnLawNames, or empty.
struct StatedMachine {
  std::string machine, feed_law, rapid_law;
  std::optional<double> tool_length_mm = {};  ///< from the gauge point to the tip
  double tool_length_slack_mm = 0;            ///< the true length is at most so much longer or shorter
  StatedJoints joints = {};
  std::string zero = {};  ///< part zero in machine coordinates, as typed: "x,y,z" or "x,y,z,rx,ry,rz"; empty: not known
  bool has_heads = false;            ///< bodies that are no solids of revolution move with the tool
  std::string joint_rapid_law = {};  ///< of rapids without tool centre point control: joint, independent, or empty
};

/// The machine of a job and the law of motion on it.
struct ChosenMachine {
  Machine machine;
  TurnLaws laws;
  MotionLaw law;                         ///< by `laws`
  std::string law_evidence;              ///< options, and the control with its source
  std::string bytes;                     ///< of its file or preset
  std::optional<double> tool_length_mm;  ///< as stated
  double tip_slack_mm = 0;               ///< addition to the tip tolerance, for intervals (tip_slack.h)
};

/// Reads a machine file, a configuration of LinuxCNC, or preset:NAME, and takes the facts of joints that the user states.
/// With a part zero the machine is placed about the part (place_part).
/// `bytes`: takes the text that was read.
/// Errors: usage, for a preset that does not exist; those of read_file, read_machine, read_linuxcnc_ini and state_joints. Also
/// usage, for a part zero of another form.
[[nodiscard]] Result<Machine> load_machine(const StatedMachine& stated, std::uint64_t max_bytes, std::string& bytes,
                                           const MachineOptionNames& names = {});

/// Returns the error of a law with another name, of a law that needs a machine without one, or of facts of joints without
/// a machine. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_machine_fact(const StatedMachine& stated,
                                                                const MachineOptionNames& names = {});

/// Returns the machine of a job, with the laws that the user states, else those that its control promises. None: no
/// machine is stated.
/// Errors: (1) those of find_wrong_machine_fact and load_machine. (2) usage: dogleg rapids beside a law of all joints.
/// (3) machine-law: nothing states a law, or a law needs a fact that is not given, or intervals do not bound the tip.
[[nodiscard]] Result<std::optional<ChosenMachine>> choose_machine(const StatedMachine& stated, RapidMode rapid,
                                                                  std::uint64_t max_bytes,
                                                                  const MachineOptionNames& names = {});

/// Makes the law of motion of a machine. `has_heads`: bodies that are no solids of revolution move with the tool. Error: machine-law, a law needs a fact that is not given.
[[nodiscard]] Result<MotionLaw> make_motion_law(const Machine& machine, const TurnLaws& laws, RapidMode rapid,
                                                const std::optional<double>& tool_length_mm, bool has_heads,
                                                const MachineOptionNames& names = {});

/// Chooses the joints of a path and stores them with it. Angles that the program states (Toolpath::joints) stay. Moves that the machine cannot run, and those whose motion `law`
/// leaves open, are not checked, with their reason. With a part zero, that includes limits of linear joints. Returns a
/// warning for each problem of the joints, at most twenty, and a warning if limits of linear joints cannot be compared.
/// `is_turn_needed`: that of choose_joints.
[[nodiscard]] Diagnostics choose_joints_of(const Machine& machine, const MotionLaw& law,
                                           const std::optional<double>& tool_length_mm, bool is_turn_needed,
                                           Toolpath& path);

/// Returns whether more of a motion matters than tip and tool axis: heads, or a tip that the joints carry.
[[nodiscard]] bool needs_turn(const TurnLaws& laws, bool has_heads);

/// Describes a problem, as a warning with its line.
[[nodiscard]] Diagnostic describe_problem(const Machine& machine, const Toolpath& path, const JointProblem& problem);

}  // namespace gouge
