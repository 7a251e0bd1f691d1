#include "cli/commands/machine_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <ostream>
#include <vector>

#include "cli/commands/machine_check.h"
#include "cli/commands/machine_words.h"
#include "cli/machine/machine_choice.h"
#include "cli/options/joint_options.h"
#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "lib/base/units.h"
#include "lib/machine/draw_machine.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/machine/machine.h"
#include "lib/machine/read_machine.h"
#include "postproc/image/render_drawing.h"

namespace gouge {
namespace {

std::string list_text() {
  std::string text;
  for (const MachinePreset& preset : machine_presets())
    text += padded("preset:" + std::string(preset.name), 28) + std::string(preset.title) + "\n";
  return text;
}

std::string bound_text(const std::optional<double>& bound, double scale) {
  return bound ? display_text(*bound * scale, 4) : "?";
}

std::string joint_text(const Joint& joint) {
  const bool is_rotary = joint.type == JointType::rotary;
  const double scale = is_rotary ? 1 / kDegree_rad : 1;
  const std::string unit = is_rotary ? "deg" : "mm";
  const Vec3& d = joint.direction;
  std::string text = std::string(joint.side == JointSide::table ? "table" : "head") + ", about (" +
                     display_text(d.x(), 4) + ", " + display_text(d.y(), 4) + ", " + display_text(d.z(), 4) + ")";
  if (!is_rotary) text.replace(text.find("about"), 5, "along");
  if (is_rotary && joint.has_point)
    text += " through (" + display_text(joint.point.x(), 4) + ", " + display_text(joint.point.y(), 4) + ", " +
            display_text(joint.point.z(), 4) + ") mm" +
            (joint.point_slack_mm > 0 ? ", to within " + display_text(joint.point_slack_mm, 4) + " mm" : "");
  text += joint.is_continuous
              ? ", turns without end"
              : ", from " + bound_text(joint.min, scale) + " to " + bound_text(joint.max, scale) + " " + unit;
  if (joint.rate) text += ", " + display_text(*joint.rate * scale, 1) + " " + unit + "/min";
  return text;
}

std::string law_text(const std::optional<TurnLaw>& law) { return law ? turn_law_name(*law) : "not given"; }

std::string machine_text(const Machine& machine, const StatedJoints& stated) {
  std::string text = machine_row("machine", machine.name) +
                     machine_row("source", machine.source.empty() ? "not given" : machine.source);
  for (const Joint& joint : machine.joints) text += machine_row("joint " + joint.name, joint_text(joint));
  for (const std::string& fact : stated_texts(stated, {})) text += machine_row("stated on the command line", fact);
  text += machine_row("control", machine.control.name.empty() ? "not given" : machine.control.name);
  text += machine_row("law of feeds", law_text(machine.control.feed_law)) +
          machine_row("law of rapids", law_text(machine.control.rapid_law));
  if (const double tip_mm = machine.control.tip_tolerance_mm; tip_mm > 0)
    text += machine_row("tip tolerance", display_text(tip_mm, 6) + " mm");
  if (const double axis_rad = machine.control.axis_tolerance_rad; axis_rad > 0)
    text += machine_row("axis tolerance", display_text(axis_rad / kDegree_rad, 6) + " deg");
  if (!machine.control.source.empty()) text += machine_row("source of the laws", machine.control.source);
  return text;
}

void add_machine_input(CLI::App& command, MachineArguments& arguments) {
  command.add_option("MACHINE", arguments.stated.machine, kMachineHelp)->type_name("FILE")->required();
  add_joint_options(command, arguments.stated.joints);
  add_input_limit(command, arguments.input);
}

void add_law_options(CLI::App& command, MachineArguments& arguments) {
  const std::vector<std::string> laws(kTurnLawNames.begin(), kTurnLawNames.end());
  command.add_option("--feed-law", arguments.stated.feed_law, "Law of feed moves (default: that of the control)")
      ->check(CLI::IsMember(std::vector<std::string>(laws.begin(), laws.begin() + kFeedLaws)));
  command.add_option("--rapid-law", arguments.stated.rapid_law, "Law of rapid moves (default: that of the control)")
      ->check(CLI::IsMember(laws));
  command
      .add_option("--tool-length", arguments.tool_length,
                  "Length from the gauge point to the tool tip, or an interval: 120..120.1")
      ->type_name("LENGTH");
}

}  // namespace

void add_machine_commands(CLI::App& command, MachineArguments& arguments) {
  command.require_subcommand(1);
  command.footer("Example:\n  gougecheck machine show preset:linuxcnc-xyzac-trt");
  CLI::App* list = command.add_subcommand("list", "List the built-in machines");
  list->footer(std::string("Example:\n  gougecheck machine list\n\n") + kMachineExits);
  list->callback([&] { arguments.action = MachineArguments::Action::list; });
  CLI::App* show = command.add_subcommand("show", "Show joints, limits and laws of a machine, each with its source");
  add_machine_input(*show, arguments);
  show->footer(std::string("Example:\n  gougecheck machine show shop/dmu50.json\n\n") + kMachineExits);
  show->callback([&] { arguments.action = MachineArguments::Action::show; });
  CLI::App* check = command.add_subcommand("check", "Report which laws of motion the data of a machine permit");
  add_machine_input(*check, arguments);
  add_law_options(*check, arguments);
  check->footer(
      std::string("Example:\n  gougecheck machine check shop/dmu50.json --tool-length 150\n\n"
                  "For each law and kind of motion it prints whether the law can be used, and which facts are missing. "
                  "Warnings and notes name doubts about the data.\n\n") +
      "Exit status: 0 the laws in force for feeds and rapids can be used, 4 one of them cannot be used or is not given, "
      "2 wrong command line, 3 input unreadable or invalid.");
  check->callback([&] { arguments.action = MachineArguments::Action::check; });
  CLI::App* draw = command.add_subcommand("draw", "Draw the joints of a machine with their senses, limits and places");
  add_machine_input(*draw, arguments);
  draw->add_option("-o,--output", arguments.picture, "Picture file, .png or .svg")->type_name("FILE")->required();
  draw->footer(std::string("Example:\n  gougecheck machine draw shop/dmu50.json -o dmu50.svg\n\n") + kMachineExits);
  draw->callback([&] { arguments.action = MachineArguments::Action::draw; });
}

namespace {

int run_machine_check(const MachineArguments& arguments, std::ostream& out, std::ostream& err) {
  StatedMachine stated = arguments.stated;
  if (!arguments.tool_length.empty()) {
    const Result<LengthRange> length = understand_length_range("--tool-length", arguments.tool_length);
    if (!length) return fail(err, {length.error()});
    stated.tool_length_mm = length->middle_mm;
    stated.tool_length_slack_mm = length->half_mm;
  }
  return check_machine(stated, arguments.input.max_bytes, out, err);
}

int draw_picture(const Machine& machine, const MachineArguments& arguments, std::ostream& err) {
  const Result<bool> is_svg = is_svg_file(arguments.picture);
  if (!is_svg) return fail(err, {is_svg.error()});
  if (const auto status = refuse_outputs({{"the machine", arguments.stated.machine}}, {{"-o", arguments.picture}}, err))
    return *status;
  const Drawing drawing = draw_machine(machine);
  const Result<std::string> bytes = *is_svg ? Result<std::string>(render_svg(drawing)) : render_png(drawing);
  if (!bytes) return fail(err, {bytes.error()}, kExitInternal);
  const Outcome written = write_file(arguments.picture, *bytes);
  return written ? kExitClean : fail(err, {written.error()}, kExitInternal);
}

}  // namespace

int run_machine(const MachineArguments& arguments, std::ostream& out, std::ostream& err) {
  if (arguments.action == MachineArguments::Action::list) {
    out << list_text();
    return kExitClean;
  }
  if (arguments.action == MachineArguments::Action::check) return run_machine_check(arguments, out, err);
  std::string bytes;
  const Result<Machine> machine = load_machine(arguments.stated, arguments.input.max_bytes, bytes);
  if (!machine) return fail(err, {machine.error()});
  print(err, describe_missing_axes(*machine, arguments.stated.machine));
  if (arguments.action == MachineArguments::Action::draw) return draw_picture(*machine, arguments, err);
  out << machine_text(*machine, arguments.stated.joints);
  return kExitClean;
}

}  // namespace gouge
