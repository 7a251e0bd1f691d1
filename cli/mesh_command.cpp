#include "cli/mesh_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "cli/exit_code.h"
#include "cli/mesh_info_text.h"
#include "cli/output_file.h"
#include "cli/overwriting.h"
#include "lib/base/files.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/repair_mesh.h"

namespace gouge {
namespace {

int tell(std::ostream& err, const Diagnostic& diagnostic, int status) {
  err << to_text(diagnostic) << "\n";
  return status;
}

int status_of(const MeshValidation& judged) {
  if (judged.is_sound()) return kExitClean;
  return judged.trouble.empty() ? kExitGouges : kExitNotChecked;
}

// The repair asked for, written when it is an improvement. Returns the exit status if it failed.
std::optional<int> repair(const MeshArguments& arguments, const LoadedMesh& loaded, MeshInfo& info,
                          std::ostream& err) {
  RepairOptions options;
  options.fills_holes = arguments.fills_holes;
  options.unit = info.unit;
  Result<MeshRepair> repaired = repair_mesh(loaded.mesh, info.judged, options);
  if (!repaired) return tell(err, repaired.error(), kExitGouges);
  info.repair = std::move(*repaired);
  if (!info.repair->is_better()) return std::nullopt;
  const Outcome written = write_file(arguments.repair_file, info.repair->stl_bytes);
  if (!written) return tell(err, written.error(), kExitInternal);
  info.written_file = arguments.repair_file;
  return std::nullopt;
}

bool deliver(const MeshArguments& arguments, const MeshInfo& info, std::ostream& out, std::ostream& err) {
  if (arguments.json_file == "-") {
    out << mesh_info_json(info);
    return true;
  }
  out << mesh_info_text(info);
  if (arguments.json_file.empty()) return true;
  const Outcome written = write_file(arguments.json_file, mesh_info_json(info));
  if (!written) tell(err, written.error(), kExitInternal);
  return written.has_value();
}

}  // namespace

void add_mesh_options(CLI::App& command, MeshArguments& arguments) {
  command.add_option("PART", arguments.file, "STL file, binary or ASCII")->required();
  command.add_option("--stl-units", arguments.stl_units, "Unit of the STL's numbers")
      ->check(CLI::IsMember({"mm", "inch"}))
      ->capture_default_str();
  CLI::Option* repair = command.add_option("--repair", arguments.repair_file,
                                           "Write a repaired binary STL here, if it has fewer defects");
  command
      .add_flag("--fill-holes", arguments.fills_holes,
                "Let the repair add triangles where surface is missing")
      ->needs(repair);
  command.add_option("--json", arguments.json_file, "Write the same as JSON; - for standard output");
  command.footer(
      "Examples:\n  gougecheck mesh part.stl\n  gougecheck mesh part.stl --repair mended.stl --fill-holes\n\n"
      "A repair moves no vertex (what is written has single precision, as binary STL has) and resolves no "
      "self-intersection. Exit status: 0 the mesh (after a repair: the repaired one) is sound, 1 it has "
      "defects, 2 wrong command line, 3 unreadable, 4 not wholly decided, 5 output unwritable.");
}

int run_mesh(const MeshArguments& arguments, std::ostream& out, std::ostream& err) {
  MeshInfo info;
  info.unit = arguments.stl_units == "inch" ? LengthUnit::inch : LengthUnit::mm;
  if (const auto error = find_overwriting({{"the mesh", arguments.file}},
                                          {{"--repair", arguments.repair_file}, {"--json", arguments.json_file}}))
    return tell(err, *error, kExitUsage);
  if (arguments.repair_file == "-")
    return tell(err, make_error("usage", "--repair '-': expected a file; a mesh does not go to standard output"),
                kExitUsage);
  const Diagnostics unwritable = find_unwritable({arguments.repair_file, arguments.json_file});
  if (!unwritable.empty()) return tell(err, unwritable.front(), kExitInternal);
  const Result<LoadedMesh> loaded = load_mesh(arguments.file, {info.unit, {}});
  if (!loaded) return tell(err, loaded.error(), kExitInput);
  info.file = arguments.file;
  info.format = loaded->format;
  info.notes = loaded->notes;
  info.judged = validate_mesh(loaded->mesh, loaded->findings);
  std::optional<int> failed;
  if (!arguments.repair_file.empty()) failed = repair(arguments, *loaded, info, err);
  if (!deliver(arguments, info, out, err)) return kExitInternal;
  if (failed) return *failed;
  return status_of(info.written_file.empty() ? info.judged : info.repair->after);
}

}  // namespace gouge
