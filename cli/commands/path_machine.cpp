#include "cli/commands/path_machine.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>
#include <vector>

#include "cli/commands/machine_words.h"
#include "cli/machine/rate_notes.h"
#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/machine/rotary_law.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"
#include "postproc/formats/read_toolpath.h"

namespace gouge {
namespace {

std::string degrees(double rad, int decimals = 3) { return display_text(rad / kDegree_rad, decimals) + " deg"; }

struct Gap {
  std::size_t move = 0;
  double rad = 0;
};

bool has_opposite_axes(const Toolpath& path, std::size_t move) {
  constexpr double kOpposite_rad = std::numbers::pi - 1e-6;  // no great circle beyond, as in a check
  const Move& to = path.moves[move];
  return to.has_start && angle_between_rad(path.start_of(move).axis, to.end.axis) > kOpposite_rad;
}

/// Returns a warning with the first move whose axes are opposite, and the number of these moves.
Diagnostics describe_opposite_axes(const Toolpath& path) {
  std::size_t count = 0, first = 0;
  for (std::size_t i = path.moves.size(); i-- > 0;) {
    if (!has_opposite_axes(path, i)) continue;
    ++count;
    first = i;
  }
  if (count == 0) return {};
  return {make_warning("machine-opposite",
                       "the tool axis turns to its opposite in " + count_text(count, "move") +
                           ", for which the law vector states no motion; add a position between",
                       path.file, path.moves[first].line)};
}

/// Returns the gaps of all moves, rapid or not, in which a rotary joint moves.
std::vector<Gap> gaps_of(const Machine& machine, const Toolpath& path, const JointPath& joints, bool is_rapid) {
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (runs_rapid(path.moves[i]) != is_rapid || !joints.start[i] || !joints.end[i]) continue;
    const RotaryAngles &from = *joints.start[i], &to = *joints.end[i];
    if (!(std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]) > 0)) continue;
    if (has_opposite_axes(path, i)) continue;
    gaps.push_back({i, largest_gap_rad(machine, from, to)});
  }
  return gaps;
}

std::string gaps_text(const Toolpath& path, std::vector<Gap> gaps, const std::string& kind, double height_mm) {
  constexpr double kDiffers_mm = 0.01;
  std::string text = machine_row(kind + " that turn", std::to_string(gaps.size()));
  if (gaps.empty()) return text;
  std::ranges::sort(gaps, {}, &Gap::rad);
  const auto at_height = [&](double rad) { return display_text(2 * height_mm * std::sin(0.5 * rad), 4) + " mm"; };
  const std::string height = " at " + display_text(height_mm, 3) + " mm";
  const Gap& largest = gaps.back();
  text += machine_row("  maximum gap", degrees(largest.rad, 4) + ", " + at_height(largest.rad) + height + ", line " +
                                           std::to_string(path.moves[largest.move].line));
  const Gap& most = gaps[static_cast<std::size_t>(0.99 * static_cast<double>(gaps.size() - 1))];
  text += machine_row("  99 % within", degrees(most.rad, 4) + ", " + at_height(most.rad) + height);
  const auto differing = std::ranges::count_if(
      gaps, [&](const Gap& gap) { return 2 * height_mm * std::sin(0.5 * gap.rad) > kDiffers_mm; });
  return text + machine_row("  more than 0.01 mm" + height, std::to_string(differing));
}

std::string joints_csv(const Machine& machine, const Toolpath& path, const JointPath& joints, double length_mm) {
  std::string text = "move,line,kind";
  for (const Joint& joint : machine.joints) text += "," + joint.name;
  text += "\n";
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    text += std::to_string(i) + "," + std::to_string(move.line) + "," + kind_name(move.kind);
    std::optional<JointValues> values;
    if (joints.end[i]) values = inverse(machine, move.end.tip, *joints.end[i], length_mm);
    for (std::size_t k = 0; k < machine.joints.size(); ++k) {
      const double scale = machine.joints[k].type == JointType::rotary ? 1 / kDegree_rad : 1;
      text += "," + (values ? fixed_text((*values)[k] * scale, 6) : std::string());
    }
    text += "\n";
  }
  return text;
}

void add_common(CLI::App& command, PathMachineArguments& arguments) {
  command.add_option("PATH", arguments.path, "Toolpath: CL data of any dialect, recognized by its content")
      ->type_name("FILE")
      ->required();
  add_program_reading(command, arguments, MachineOption::required);
}

}  // namespace

void add_path_laws_options(CLI::App& command, PathMachineArguments& arguments) {
  add_common(command, arguments);
  command.add_option("--height", arguments.height, "Distance above the tip at which the gap is given as a length")
      ->type_name("LENGTH")
      ->capture_default_str();
  command.footer(
      std::string("Example:\n"
                  "  gougecheck path laws finish.apt --machine preset:haas-umc750\n\n"
                  "The gap of a move is the largest angle between two tool axes: one turns on the great circle, "
                  "the other results from rotary joints that run at constant rates.\n\n") +
      kMachineExits);
}

void add_path_joints_options(CLI::App& command, PathMachineArguments& arguments) {
  add_common(command, arguments);
  command
      .add_option(
          "--csv", arguments.csv_file,
          "Write the joint values of every record as CSV, in mm and degrees also for a path in inches; - for standard "
          "output")
      ->type_name("FILE")
      ->required();
  command.footer(
      std::string("Example:\n"
                  "  gougecheck path joints op10.apt --machine preset:haas-umc750 --csv joints.csv\n\n"
                  "Joints are chosen in the way of a post-processor: the nearest solution within the limits. "
                  "Exceeded limits, flips and turns back are reported as warnings.\n\n") +
      kMachineExits);
}

int run_path_machine(const PathMachineArguments& arguments, std::ostream& out, std::ostream& err) {
  const Result<ToolpathReader> reader = ToolpathReader::make(arguments);
  if (!reader) return fail(err, {reader.error()});
  const Machine& machine = *reader->machine();
  const std::optional<double>& tool_length_mm = reader->tool_length_mm();
  if (arguments.is_joints && !tool_length_mm && depends_on_tool_length(machine))
    return fail(err, {make_error("usage", "--tool-length is missing; the motion of the linear joints depends on it")});
  const Result<double> height = understand_length("--height", arguments.height, Minimum::zero);
  if (!height) return fail(err, {height.error()});
  if (const auto status = refuse_outputs({{"the toolpath", arguments.path}, {"--machine", arguments.stated.machine}},
                                         asked_for({{"--csv", arguments.csv_file}}), err))
    return *status;
  ReadOutcome outcome = reader->read(arguments.path);
  if (!outcome.toolpath) return fail(err, outcome.errors);
  Toolpath& path = *outcome.toolpath;
  print(err, path.notes);
  print(err, describe_missing_axes(machine, arguments.stated.machine));
  print(err, choose_joints_of(machine, MotionLaw(), tool_length_mm, false, path));
  if (arguments.is_joints) print(err, describe_rate_excesses(machine, machine.control.feed_law, path));
  print(err, describe_opposite_axes(path));
  const JointPath& joints = *path.joints;
  if (arguments.is_joints) {
    const Outcome written =
        write_output(arguments.csv_file, joints_csv(machine, path, joints, tool_length_mm.value_or(0)), out);
    return written ? kExitClean : fail(err, {written.error()}, kExitInternal);
  }
  out << machine_row("file", path.file) << machine_row("machine", machine.name)
      << gaps_text(path, gaps_of(machine, path, joints, false), "feeds", *height)
      << gaps_text(path, gaps_of(machine, path, joints, true), "rapids", *height);
  return kExitClean;
}

}  // namespace gouge
