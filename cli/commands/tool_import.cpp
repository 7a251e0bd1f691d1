#include "cli/commands/tool_import.h"

#include <CLI/CLI.hpp>
#include <ostream>

#include "cli/commands/tool_command.h"
#include "cli/output/output_file.h"
#include "cli/output/overwriting.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/printable_text.h"
#include "toolmodels/import/collector.h"
#include "toolmodels/import/import_tools.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {
namespace {

Result<NamedHolder> find_holder(const ToolImportArguments& arguments) {
  if (arguments.holder.empty()) return NamedHolder{};
  if (arguments.tools_file.empty()) return make_error("usage", "--holder needs --tools, the library that holder is in");
  const Result<ReadTools> read = read_tools_file(arguments.tools_file, arguments.input.max_bytes);
  if (!read) return read.error();
  const ToolLibrary* const library = &read->library;
  std::optional<NamedHolder> holder = library->holder_called(arguments.holder);
  if (!holder)
    return make_error("usage", "--holder '" + arguments.holder + "': " + arguments.tools_file +
                                   " has no holder of that name; it has " + library->holder_names());
  return std::move(*holder);
}

std::optional<ImportFormat> format_called(const std::string& name) {
  if (name == "fusion") return ImportFormat::fusion;
  if (name == "freecad") return ImportFormat::freecad;
  if (name == "nx") return ImportFormat::nx;
  if (name == "camotics") return ImportFormat::camotics;
  if (name == "linuxcnc") return ImportFormat::linuxcnc;
  return std::nullopt;
}

void report_notes(const ImportedTools& made, std::ostream& out, std::ostream& err) {
  bool is_first = true;
  for (const Diagnostic& note : made.notes) {
    if (note.severity != Severity::note) {
      err << to_text(note) << "\n";
      continue;
    }
    if (is_first) out << "assumed or left out:\n";
    is_first = false;
    out << "  " << printable(note.message) << "\n";
  }
}

}  // namespace

void add_tool_import_options(CLI::App& command, ToolImportArguments& arguments, std::string& output) {
  command
      .add_option("file", arguments.file,
                  "Fusion .json or .tools, FreeCAD .fctb or .fctl, NX tool_database.dat or "
                  "holder_database.dat, CAMotics .json, LinuxCNC .tbl")
      ->type_name("FILE")
      ->required();
  command.add_option("-o,--output", output, "Tool library to write (JSON); - for standard output")
      ->type_name("FILE")
      ->required();
  command.add_option("--format", arguments.format, "Format of the file (auto: recognized by its content)")
      ->check(CLI::IsMember({"auto", "fusion", "freecad", "nx", "camotics", "linuxcnc"}));
  command.add_option("--holder", arguments.holder, "Holder for tools without one: its name in the library of --tools")
      ->type_name("NAME");
  command.add_option("--tools", arguments.tools_file, "Tool library with the holder of --holder")->type_name("FILE");
  command
      .add_option("--stickout", arguments.stickout, "Length from the tip to the holder, if the file does not state it")
      ->type_name("LENGTH");
  command.add_option("--unit", arguments.unit, "Unit of a file that does not state its unit (NX, LinuxCNC)")
      ->check(CLI::IsMember({"mm", "inch"}));
  add_input_limit(command, arguments.input);
  command.footer(
      "Example:\n"
      "  gougecheck tool import shop.tools -o shop.json\n\n"
      "Exit status: 0 done, also with warnings; 2 wrong command line; 3 file unreadable, or a tool was left out "
      "because its dimensions are impossible (the others are written); 5 output unwritable.");
}

int run_tool_import(const ToolImportArguments& arguments, const std::string& output, std::ostream& out,
                    std::ostream& err) {
  std::vector<InputOption> inputs = {{"the file to import", arguments.file}, {"--tools", arguments.tools_file}};
  const OutputTable outputs = {{"-o", output}};
  if (const auto status = refuse_outputs(inputs, outputs, err)) return *status;
  ImportOptions options;
  SearchLog searches;
  if (!arguments.stickout.empty()) {
    const Result<double> stickout = understand_length("--stickout", arguments.stickout, Minimum::above_zero);
    if (!stickout) return fail(err, {stickout.error()});
    options.stickout_mm = *stickout;
  }
  const Result<NamedHolder> holder = find_holder(arguments);
  if (!holder) return fail(err, {holder.error()});
  const Result<std::string> bytes = read_file(arguments.file, arguments.input.max_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  options.holder = holder->segments;
  options.holder_uncertainty = uncertainty_of_owner(*holder);
  options.unit = unit_called(arguments.unit);
  options.read_beside = [&](const std::string& name) -> Result<std::string> {
    Result<BesideFile> beside = read_beside(arguments.file, name, arguments.input.max_bytes, searches);
    if (!beside) return beside.error();
    inputs.push_back({"a file of the library", beside->path});
    return std::move(beside->bytes);
  };
  const Result<ImportedTools> made = import_tools(arguments.file, *bytes, format_called(arguments.format), options);
  if (!made) return fail(err, {made.error()});
  if (const auto error = find_overwriting(inputs, outputs)) return fail(err, {*error});
  std::ostream& reported = output == "-" ? err : out;
  const bool is_empty = made->library.tools.empty() && made->library.holders.empty();
  if (!is_empty) {
    const Outcome written = write_output(output, write_tool_library(made->library), out);
    if (!written) {
      return fail(err, {written.error()}, kExitInternal);
    }
    reported << tool_list_text(made->library);
  }
  report_notes(*made, reported, err);
  return has_error(made->notes) ? kExitInput : kExitClean;
}

}  // namespace gouge
