#pragma once

#include <optional>
#include <string>

#include "cli/machine/machine_choice.h"
#include "cli/options/reading_options.h"
#include "postproc/formats/read_toolpath.h"

namespace CLI {
class App;
}

// Toolpaths that a command reads without a job: CL data, or the program of a machine.

namespace gouge {

/// Options for such toolpaths, as typed.
struct ProgramReading {
  StatedMachine stated;
  std::string tool_length, tip_tolerance, axis_tolerance;
  ReadingArguments reading;
  InputLimit input;
};

/// Departures that the smoothing of the control may cause, where an option states them.
struct StatedTolerances {
  std::optional<double> tip_mm, axis_rad;
};

enum class MachineOption : std::uint8_t { possible, required };

/// Adds the options under their headings. The heading that is in force stays.
void add_program_reading(CLI::App& command, ProgramReading& arguments, MachineOption machine);

/// Reads toolpaths as the options of a command state.
class ToolpathReader {
 public:
  /// Errors: those of understand, load_machine and read_tool_lengths; usage, for a length that is none, or for facts of a
  /// machine without --machine.
  [[nodiscard]] static Result<ToolpathReader> make(const ProgramReading& arguments);

  /// Keeps what a writer needs to rewrite moves (Toolpath::origins).
  void keep_origins() { options_.keeps_origins = true; }
  /// Reads a file, and the programs beside it that it calls.
  [[nodiscard]] ReadOutcome read(const std::string& file) const;

  /// Null: no machine is stated.
  [[nodiscard]] const Machine* machine() const { return machine_ ? &*machine_ : nullptr; }
  [[nodiscard]] const std::optional<double>& tool_length_mm() const { return tool_length_mm_; }

 private:
  ToolpathReader() = default;
  std::optional<Diagnostic> take_tool_length(const ProgramReading& arguments);
  /// Loads the machine, and sets what the smoothing of its control may cause.
  std::optional<Diagnostic> set_machine(StatedMachine stated, const StatedTolerances& tolerances);

  ReadOptions options_;
  std::optional<Machine> machine_;
  std::optional<double> tool_length_mm_;
  std::uint64_t max_bytes_ = 0;
};

}  // namespace gouge
