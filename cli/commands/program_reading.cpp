#include "cli/commands/program_reading.h"

#include <CLI/CLI.hpp>
#include <utility>

#include "cli/machine/program_files.h"
#include "cli/machine/program_machine.h"
#include "cli/options/joint_options.h"
#include "cli/options/tube_options.h"
#include "cli/terminal/length_text.h"
#include "lib/base/files.h"

namespace gouge {
namespace {

void warn_of_unknown_unit(Toolpath& path) {
  for (const Assumption& fact : path.assumptions) {
    if (fact.subject != Subject::path_unit || fact.basis != Basis::unknown) continue;
    path.notes.push_back(make_warning(fact.code, fact.evidence + "; " + fact.remedy, path.file, fact.line));
  }
}

Result<StatedTolerances> understand_tolerances(const ProgramReading& arguments) {
  const Result<MotionTube> tube = understand_tube(arguments.tip_tolerance, arguments.axis_tolerance, false);
  if (!tube) return tube.error();
  StatedTolerances stated;
  if (!arguments.tip_tolerance.empty()) stated.tip_mm = tube->tip_mm;
  if (!arguments.axis_tolerance.empty()) stated.axis_rad = tube->axis_rad;
  return stated;
}

}  // namespace

void add_program_reading(CLI::App& command, ProgramReading& arguments, MachineOption machine) {
  const std::string usual_group = command.option_defaults()->get_group();
  CLI::Option* const chosen =
      command.add_option("--machine", arguments.stated.machine, kMachineHelp)->type_name("FILE")->group(kMachineGroup);
  if (machine == MachineOption::required) chosen->required();
  add_joint_options(command, arguments.stated.joints);
  command.add_option("--joint-rapid-law", arguments.stated.joint_rapid_law, kJointRapidLawHelp)
      ->type_name("joint|independent")
      ->group(kMachineGroup);
  command
      .add_option("--tool-length", arguments.tool_length,
                  "Length from the gauge point of --machine to the tool tip; a rotary head requires it")
      ->type_name("LENGTH")
      ->group(kMachineGroup);
  command
      .add_option("--tip-tolerance", arguments.tip_tolerance,
                  "Maximum distance of the tool tip from its path that the smoothing of the control may cause (G64 P)")
      ->type_name("LENGTH")
      ->group(kMachineGroup);
  command
      .add_option("--axis-tolerance", arguments.axis_tolerance,
                  "Maximum angle by which the smoothing of the control may turn the tool axis")
      ->type_name("DEG")
      ->group(kMachineGroup);
  command.add_option("--zero", arguments.stated.zero, kZeroHelp)->type_name("X,Y,Z")->group(kMachineGroup);
  add_options(command, arguments.reading, reading_options());
  command.option_defaults()->group(usual_group);
  add_input_limit(command, arguments.input);
}

Result<ToolpathReader> ToolpathReader::make(const ProgramReading& arguments) {
  ToolpathReader reader;
  reader.max_bytes_ = arguments.input.max_bytes;
  Result<ReadOptions> options = understand(arguments.reading);
  if (!options) return options.error();
  reader.options_ = std::move(*options);
  std::string bytes;
  if (auto error = read_tool_lengths(arguments.reading, reader.max_bytes_, reader.options_, bytes)) return *error;
  if (auto error = reader.take_tool_length(arguments)) return *error;
  const Result<StatedTolerances> tolerances = understand_tolerances(arguments);
  if (!tolerances) return tolerances.error();
  if (auto error = find_wrong_machine_fact(arguments.stated)) return *error;
  if (arguments.stated.machine.empty()) {
    reader.options_.program =
        with_control(reader.options_.program, {turn_law_called(arguments.stated.joint_rapid_law),
                                               reader.tool_length_mm_, stated_tolerance(tolerances->tip_mm.value_or(0)),
                                               stated_tolerance(tolerances->axis_rad.value_or(0))});
    return reader;
  }
  if (auto error = reader.set_machine(arguments.stated, *tolerances)) return *error;
  return reader;
}

std::optional<Diagnostic> ToolpathReader::take_tool_length(const ProgramReading& arguments) {
  if (arguments.tool_length.empty()) return std::nullopt;
  const Result<double> length = understand_length("--tool-length", arguments.tool_length, Minimum::zero);
  if (!length) return length.error();
  tool_length_mm_ = *length;
  return std::nullopt;
}

std::optional<Diagnostic> ToolpathReader::set_machine(StatedMachine stated, const StatedTolerances& tolerances) {
  stated.tool_length_mm = tool_length_mm_;
  std::string bytes;
  Result<Machine> machine = load_machine(stated, max_bytes_, bytes);
  if (!machine) return machine.error();
  Control& control = machine->control;
  if (const auto law = turn_law_called(stated.joint_rapid_law)) control.joint_rapid_law = law;
  options_.program = with_machine(options_.program, *machine, stated, std::nullopt,
                                  stated_tolerance(tolerances.tip_mm.value_or(control.tip_tolerance_mm)),
                                  stated_tolerance(tolerances.axis_rad.value_or(control.axis_tolerance_rad)));
  machine_ = std::move(*machine);
  return std::nullopt;
}

ReadOutcome ToolpathReader::read(const std::string& file) const {
  Result<PagedVector<char>> bytes = read_long_file(file, max_bytes_);
  if (!bytes) {
    ReadOutcome unreadable;
    unreadable.errors.push_back(bytes.error());
    return unreadable;
  }
  ReadOptions options = options_;
  SearchLog searches;
  std::optional<Diagnostic> unreadable;
  options.program = with_files_beside(options.program, file, max_bytes_, searches,
                                      [&unreadable](const std::string&, const Result<std::string>& beside) {
                                        if (!beside && !unreadable) unreadable = beside.error();
                                      });
  ReadOutcome outcome = read_toolpath(file, std::move(*bytes), options);
  if (unreadable) {
    outcome.errors.push_back(*unreadable);
    outcome.toolpath.reset();
  }
  if (outcome.toolpath) warn_of_unknown_unit(*outcome.toolpath);
  return outcome;
}

}  // namespace gouge
