#include "cli/path_command.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <utility>

#include "cli/exit_code.h"
#include "cli/path_info_text.h"
#include "lib/base/files.h"
#include "postproc/cldata/read_toolpath.h"

namespace gouge {
namespace {

int refuse(const Diagnostics& errors, std::ostream& err) {
  for (const Diagnostic& error : errors) err << to_text(error) << "\n";
  return kExitInput;
}

}  // namespace

void add_path_options(CLI::App& command, PathArguments& arguments) {
  command.require_subcommand(1);
  command.footer("Example:\n  gougecheck path info finish.apt");
  CLI::App* info = command.add_subcommand(
      "info", "Tell dialect, unit, tools, operations, moves, box, orientations and what is not understood");
  info->add_option("PATH", arguments.path, "toolpath: APT CL text or NX CLSF; the content tells which")
      ->required();
  info->add_option("--json", arguments.json_file, "write the same as JSON; - for standard output");
  info->footer(
      "Example:\n  gougecheck path info finish.apt --json -\n\n"
      "Lengths are in the file's unit. Exit status: 0 read, 2 wrong command line, 3 input unreadable or "
      "invalid.");
}

int run_path(const PathArguments& arguments, std::ostream& out, std::ostream& err) {
  Result<std::string> bytes = read_file(arguments.path);
  if (!bytes) return refuse({bytes.error()}, err);
  const ReadOutcome outcome = read_toolpath(arguments.path, std::move(*bytes));
  if (!outcome.toolpath) return refuse(outcome.errors, err);
  const Toolpath& path = *outcome.toolpath;
  const PathInfo info = describe_path(path);
  if (arguments.json_file == "-") {
    out << path_info_json(path, info);
  } else {
    out << path_info_text(path, info);
  }
  for (const Diagnostic& note : path.notes) err << to_text(note) << "\n";
  if (!arguments.json_file.empty() && arguments.json_file != "-") {
    const Outcome written = write_file(arguments.json_file, path_info_json(path, info));
    if (!written) return refuse({written.error()}, err);
  }
  return kExitClean;
}

}  // namespace gouge
