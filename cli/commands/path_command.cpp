#include "cli/commands/path_command.h"

#include <CLI/CLI.hpp>
#include <ostream>
#include <utility>

#include "cli/commands/path_info_text.h"
#include "cli/job/scene_files.h"
#include "cli/options/job_options.h"
#include "cli/output/output_file.h"
#include "cli/output/picture_file.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/progress.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "postproc/cldata/writing/write_toolpath.h"
#include "postproc/image/path_plot.h"

namespace gouge {
namespace {

int run_info(const PathArguments& arguments, const Toolpath& path, std::ostream& out, std::ostream& err) {
  const PathInfo info = describe_path(path);
  const Dialect dialect = dialect_called(path.dialect).value_or(Dialect{});
  const std::string title(dialect.title);
  Outcome written = Done{};
  if (!arguments.json_file.empty()) written = write_output(arguments.json_file, path_info_json(path, info), out);
  if (arguments.json_file != "-") out << path_info_text(path, info, title);
  print(err, path.notes);
  return written ? kExitClean : fail(err, {written.error()}, kExitInternal);
}

int run_convert(const PathArguments& arguments, const Toolpath& path, std::ostream& out, std::ostream& err) {
  Result<WrittenToolpath> written = WrittenToolpath{std::string(path.source.view()), {}};
  if (!arguments.to.empty()) written = write_toolpath(path, *dialect_called(arguments.to));
  if (!written) return fail(err, {written.error()});
  print(err, path.notes);
  print(err, written->notes);
  const Outcome outcome = write_output(arguments.output, written->bytes, out);
  return outcome ? kExitClean : fail(err, {outcome.error()}, kExitInternal);
}

int run_plot(const PathArguments& arguments, const RigidTransform& place, const Toolpath& path, bool is_svg,
             std::ostream& err) {
  print(err, path.notes);
  const LengthUnit unit = unit_called(arguments.stl_units).value_or(path.unit);
  Progress progress(err, ProgressMode::automatic);
  const auto scene =
      load_scene({arguments.parts, {}, {}, unit, place, arguments.place, arguments.input.most_bytes, 0}, progress);
  progress.end();
  if (!scene->errors.empty()) return fail(err, scene->errors);
  if (!is_svg) print(err, find_missing_letters(path));
  const Result<std::string> picture = plot_path(path, scene->scene.parts, is_svg);
  if (!picture) return fail(err, {picture.error()}, kExitInternal);
  const Outcome outcome = write_file(arguments.output, *picture);
  return outcome ? kExitClean : fail(err, {outcome.error()}, kExitInternal);
}

constexpr const char* kStatus =
    "Exit status: 0 done, 2 wrong command line, 3 input unreadable or invalid, 5 output unwritable.";

CLI::App& add_command(CLI::App& command, PathArguments& arguments, const char* name, const char* what) {
  CLI::App* added = command.add_subcommand(name, what);
  added->add_option("PATH", arguments.path, "Toolpath: CL data of any dialect, recognized by its content")
      ->type_name("FILE")
      ->required();
  add_reading_options(*added, arguments.reading);
  add_input_limit(*added, arguments.input);
  return *added;
}

}  // namespace

void add_path_options(CLI::App& command, PathArguments& arguments) {
  command.require_subcommand(1);
  command.footer("Example:\n  gougecheck path info finish.apt\n\nDialects: " + dialect_names());
  CLI::App& info =
      add_command(command, arguments, "info",
                  "Show dialect, unit, tools, operations, moves, box, orientations and what is not understood");
  info.add_option("--json", arguments.json_file, "Write the same as JSON; - for standard output")->type_name("FILE");
  info.footer("Example:\n  gougecheck path info finish.apt --json -\n\nLengths are in the file's unit. " +
              std::string(kStatus));
  info.callback([&] { arguments.is_info = true; });

  CLI::App& convert =
      add_command(command, arguments, "convert", "Write the toolpath in another dialect, and report what is lost");
  convert.add_option("-o,--output", arguments.output, "The file to write; - for standard output")
      ->type_name("FILE")
      ->required();
  convert
      .add_option("--to", arguments.to, "Dialect to write (default: the file's own, byte for byte): " + dialect_names())
      ->type_name("DIALECT")
      ->check([](const std::string& id) {
        return dialect_called(id) ? std::string() : "expected one of " + dialect_names();
      });
  convert.footer(
      "Example:\n  gougecheck path convert finish.cls -o finish.apt --to apt-creo\n\n"
      "Motions, tools, feeds, CUTCOM and names of operations are carried over; spindle, coolant and comments are not. "
      "mastercam-nci is only read. Positions are written in part coordinates.\n\n" +
      std::string(kStatus));
  convert.callback([&] { arguments.is_convert = true; });

  CLI::App& plot = add_command(command, arguments, "plot", "Draw the toolpath from the front, from above and askew");
  plot.add_option("-o,--output", arguments.output, "The picture: .png or .svg")->type_name("FILE")->required();
  plot.add_option("--part", arguments.parts, "Draw this part behind the path (STL; repeatable)")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_placement_options(plot, arguments.place, arguments.stl_units);
  plot.footer("Example:\n  gougecheck path plot finish.apt --part part.stl -o finish.png\n\n" + std::string(kStatus));
}

int run_path(const PathArguments& arguments, std::ostream& out, std::ostream& err) {
  const Result<ReadOptions> options = understand(arguments.reading);
  if (!options) return fail(err, {options.error()});
  const bool is_plot = !arguments.is_info && !arguments.is_convert;
  const Result<bool> is_svg = is_plot ? is_svg_file(arguments.output) : false;
  if (!is_svg) return fail(err, {is_svg.error()});
  const Result<RigidTransform> place =
      arguments.place.empty() ? RigidTransform{} : understand_place("--place", arguments.place);
  if (!place) return fail(err, {place.error()});
  std::vector<InputOption> inputs = {{"the toolpath", arguments.path}};
  for (const std::string& part : arguments.parts) inputs.push_back({"--part", part});
  if (const auto status =
          refuse_outputs(inputs, asked_for({{"-o", arguments.output}, {"--json", arguments.json_file}}), err))
    return *status;
  Result<std::string> bytes = read_file(arguments.path, arguments.input.most_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  const ReadOutcome outcome = read_toolpath(arguments.path, std::move(*bytes), *options);
  if (!outcome.toolpath) return fail(err, outcome.errors);
  if (arguments.is_info) return run_info(arguments, *outcome.toolpath, out, err);
  if (arguments.is_convert) return run_convert(arguments, *outcome.toolpath, out, err);
  return run_plot(arguments, *place, *outcome.toolpath, *is_svg, err);
}

}  // namespace gouge
