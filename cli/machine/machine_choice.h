#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lib/machine/joint_path.h"
#include "lib/machine/machine.h"
#include "lib/motion/motion_law.h"

namespace gouge {

/// Begins a --machine that is no file.
inline constexpr std::string_view kMachinePreset = "preset:";

/// Help of --machine.
inline constexpr const char* kMachineHelp =
    "Machine file, configuration of LinuxCNC (INI), or preset:NAME ('gougecheck machine list'): its rotary joints and the laws of its control";

/// Names of options in messages: those of the command line, or others.
struct MachineOptionNames {
  std::string machine = "--machine", feed_law = "--feed-law", rapid_law = "--rapid-law";
};

/// Laws as the user states them: "vector", "axis", or empty.
struct StatedLaws {
  std::string feed, rapid;
};

/// Reads a machine file, a configuration of LinuxCNC, or preset:NAME. `bytes`: takes the text that was read.
/// Errors: usage, for a preset that does not exist; those of read_file, read_machine and read_linuxcnc_ini.
[[nodiscard]] Result<Machine> load_machine(const std::string& typed, std::uint64_t max_bytes, std::string& bytes,
                                           const MachineOptionNames& names = {});

/// Returns the law of motion on a machine: as the user states it, else as its control promises.
/// Errors: usage, for a law of another name; machine-law, where neither states one.
[[nodiscard]] Result<MotionLaw> law_of(const Machine& machine, const StatedLaws& stated, RapidMode rapid,
                                       const MachineOptionNames& names = {});

/// Returns who states the laws: options, and the control with its source.
[[nodiscard]] std::string describe_law(const Machine& machine, const StatedLaws& stated,
                                       const MachineOptionNames& names = {});

/// Chooses the joints of a path and stores them with it. Moves that the machine cannot run are not checked, with their
/// reason. Returns a warning for each problem, at most twenty.
[[nodiscard]] Diagnostics choose_joints_of(const Machine& machine, Toolpath& path);

/// Describes a problem, as a warning with its line.
[[nodiscard]] Diagnostic describe_problem(const Machine& machine, const Toolpath& path, const JointProblem& problem);

}  // namespace gouge
