#include "cli/commands/mesh_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "cli/commands/mesh_info_text.h"
#include "cli/options/job_options.h"
#include "cli/options/length_rule.h"
#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/progress.h"
#include "lib/base/exit_code.h"
#include "lib/mesh/join_vertices.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"

namespace gouge {
namespace {

int mesh_status(const MeshValidation& judged) {
  if (judged.is_sound()) return kExitClean;
  return judged.trouble.empty() ? kExitGouges : kExitNotChecked;
}

OutputTable outputs_of(const MeshArguments& arguments) {
  return asked_for({{"--repair", arguments.repair_file}, {"--json", arguments.json_file}});
}

// Runs the requested repair. Keeps the result for output if it is an improvement. Returns the exit status if the repair
// failed.
std::optional<int> repair(const MeshArguments& arguments, const IndexedMesh& mesh, MeshInfo& info,
                          PendingOutputs& outputs, Progress& progress, std::ostream& err) {
  RepairOptions options;
  options.fills_holes = arguments.fills_holes;
  options.unit = info.unit;
  progress.begin("repairing the mesh");
  Result<MeshRepair> repaired = repair_mesh(mesh, info.judged, options, progress.call());
  progress.end();
  if (!repaired) return fail(err, {repaired.error()}, kExitGouges);
  info.repair = std::move(*repaired);
  if (!info.repair->is_better()) return std::nullopt;
  const Outcome written = outputs.add(arguments.repair_file, info.repair->stl_bytes);
  if (!written) return fail(err, {written.error()}, kExitInternal);
  info.written_file = arguments.repair_file;
  return std::nullopt;
}

// Writes the files first, then prints to the terminal.
bool deliver(const MeshArguments& arguments, const MeshInfo& info, PendingOutputs& outputs, std::ostream& out,
             std::ostream& err) {
  Outcome written = arguments.json_file.empty() ? Done{} : outputs.add(arguments.json_file, mesh_info_json(info));
  if (written) written = outputs.commit(out);
  if (!written) print(err, {written.error()});
  if (written && arguments.json_file != "-") out << mesh_info_text(info);
  return written.has_value();
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshArguments& arguments) {
  command.add_option("PART", arguments.file, "STL file, binary or ASCII")->type_name("FILE")->required();
  command.add_option("--stl-units", arguments.stl_units, "Unit of the coordinates in the STL file")
      ->check(CLI::IsMember(unit_words()))
      ->capture_default_str();
  command
      .add_option("--weld", arguments.weld,
                  "Join vertices at most this far apart, and validate the result. No vertex moves farther than "
                  "that. With --repair the joined mesh is repaired and written")
      ->type_name("LENGTH");
  CLI::Option* repair = command
                            .add_option("--repair", arguments.repair_file,
                                        "File for the repaired mesh (binary STL), written only if it has fewer defects")
                            ->type_name("FILE");
  command.add_flag("--fill-holes", arguments.fills_holes, "Fill holes of the surface with triangles")->needs(repair);
  command.add_option("--json", arguments.json_file, "Write the result as JSON; - for standard output")
      ->type_name("FILE");
  add_threads_option(command, arguments.threads);
  add_progress_option(command, arguments.progress);
  add_input_limit(command, arguments.input);
  command.footer(
      "Examples:\n"
      "  gougecheck mesh part.stl\n"
      "  gougecheck mesh part.stl --repair repaired.stl --fill-holes\n"
      "  gougecheck mesh part.stl --weld 0.002 --repair welded.stl\n\n"
      "A repair moves only the vertices that --weld joins. It resolves no self-intersection. The written file "
      "has the single precision of binary STL.\n\n"
      "Exit status: 0 the mesh is sound, 1 it has defects, 2 wrong command line, 3 input unreadable, 4 not fully "
      "decided, 5 output unwritable. If a mesh was written, the status is that of the written mesh.");
}

int run_mesh(const MeshArguments& arguments, std::ostream& out, std::ostream& err) {
  MeshInfo info;
  info.unit = unit_called(arguments.stl_units).value_or(LengthUnit::mm);
  Result<double> weld_mm = 0.0;
  if (!arguments.weld.empty()) weld_mm = understand_length("--weld", arguments.weld, Minimum::above_zero);
  if (!weld_mm) return fail(err, {weld_mm.error()});
  if (arguments.repair_file == "-")
    return fail(err, {usage_error("--repair", "-", "a file; a mesh does not go to standard output")});
  if (const auto status = refuse_outputs({{"the mesh", arguments.file}}, outputs_of(arguments), err)) return *status;
  Progress progress(err, understand_progress(arguments.progress));
  progress.begin("reading " + arguments.file);
  Result<LoadedMesh> loaded = load_mesh(arguments.file, {info.unit, {}}, arguments.input.max_bytes, progress.call());
  progress.end();
  if (!loaded) return fail(err, {loaded.error()});
  info.file = arguments.file;
  info.format = loaded->format;
  info.notes = loaded->notes;
  if (info.unit == LengthUnit::inch && !arguments.lengths_in_mm.empty())
    info.notes.push_back(describe_lengths_in_mm(arguments.lengths_in_mm, "the STL file"));
  progress.begin("validating the mesh");
  info.judged = validate_mesh(loaded->mesh, loaded->findings, progress.call());
  IndexedMesh mesh = std::move(loaded->mesh);
  if (*weld_mm > 0) {
    progress.begin("joining vertices");
    Result<JoinedMesh> joined = join_near_vertices(mesh, *weld_mm);
    progress.end();
    if (!joined) return fail(err, {joined.error()}, kExitUsage);
    info.weld = MeshWeld{*weld_mm, joined->vertices_joined, joined->largest_shift_mm, joined->triangles_collapsed,
                         validate_mesh(joined->mesh, joined->findings, progress.call())};
    mesh = std::move(joined->mesh);
  }
  progress.end();
  std::optional<int> failed;
  PendingOutputs outputs;
  if (!arguments.repair_file.empty()) failed = repair(arguments, mesh, info, outputs, progress, err);
  if (failed == kExitInternal || !deliver(arguments, info, outputs, out, err)) return kExitInternal;
  if (failed) return *failed;
  return mesh_status(info.written_file.empty() ? info.judged : info.repair->after);
}

}  // namespace gouge
