#include "cli/program.h"

#include "cli/build_facts.h"
#include "cli/commands/correct_command.h"
#include "cli/config_command.h"
#include "cli/options/help_text.h"
#include "cli/project_use.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

void describe_program(CLI::App& app, const HelpColumns& columns) {
  app.name(kProgramName);
  app.formatter(make_help_formatter(columns));
  app.description(
      "Certified gouge check and correction of 5-axis toolpaths.\n"
      "The usual job, which writes a report beside the toolpath:\n"
      "  gougecheck PATH PART.stl [TOOLS] [OPTIONS of check]\n\n"
      "The program reads the CL data of NX, CATIA, Creo, SolidWorks CAM, Fusion, NCCS, Mastercam (NCI) and plain APT, "
      "and programs of LinuxCNC, Haas, Fanuc, Siemens and Heidenhain. It checks cutter, shank and holder against STL "
      "parts and fixtures, over the whole motion of every move. It corrects moves that gouge, and reports every "
      "finding with evidence.");
  const std::string name = std::string(kProgramName) + " " + kProgramVersion;
  app.add_flag_callback(
      "-V", [name] { throw CLI::CallForVersion(name, 0); }, "Print only the version, in one line");
  app.set_version_flag(
      "--version", [name] { return name + "\n" + build_facts_text(); },
      "Print the version and the details of the build");
  app.require_subcommand(1);
  app.footer("Help of a command: gougecheck help check");
}

// Adds --color to every command that runs. Commands that only group others print nothing.
void add_colour_below(CLI::App& app, std::string& colour) {
  for (CLI::App* command : app.get_subcommands({})) {
    if (command->get_subcommands({}).empty()) add_colour_option(*command, colour);
    add_colour_below(*command, colour);
  }
}

}  // namespace

Program::Program(const HelpColumns& columns) {
  Arguments& a = arguments;
  describe_program(app, columns);
  add_check_options(*app.add_subcommand("check", "Check a toolpath for gouges and report them"), a.check);
  add_correct_options(*app.add_subcommand("correct", "Write a corrected toolpath and check it again"), a.correct);
  add_batch_options(
      *app.add_subcommand("batch", "Check or correct many toolpaths; an interrupted batch can be resumed"), a.batch);
  add_clash_options(*app.add_subcommand("clash", "Test whether two bodies of a set-up penetrate, and how deep"),
                    a.clash);
  add_compare_options(*app.add_subcommand("compare", "Compare two results and state the changes"), a.compare);
  add_accept_options(
      *app.add_subcommand("accept", "Accept findings, so that a check with --baseline lists them separately"),
      a.accept);
  add_merge_options(*app.add_subcommand("merge", "Join the results of the shards of a batch"), a.merge);
  add_machine_commands(*app.add_subcommand("machine", "List, show, check and draw machines"), a.machine);
  add_mesh_options(*app.add_subcommand("mesh", "Validate an STL file and repair it"), a.mesh);
  add_path_options(*app.add_subcommand("path", "Describe, convert and draw toolpath files"), a.path);
  add_tool_options(*app.add_subcommand("tool", "List, show and draw the tools of a library, and import libraries"),
                   a.tool);
  add_verify_options(*app.add_subcommand("verify", "Verify the result of a check by independent means"), a.verify);
  for (const char* command : {"check", "correct"})
    add_no_config_option(*app.get_subcommand(command), a.is_without_project);
  add_config_commands(app);
  add_self_commands(app, a.self);
  add_colour_below(app, a.colour);
}

std::string Program::colour() const {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  const CLI::Option* option = command->get_option_no_throw("--color");
  return option == nullptr || option->results().empty() ? "auto" : option->results().back();
}

bool Program::parse_incomplete(const std::vector<std::string>& words) {
  for (CLI::App* command : app.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) option->required(false);
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error&) {
    return false;
  }
  return true;
}

}  // namespace gouge
