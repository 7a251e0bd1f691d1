#include "cli/commands/clash_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "cli/commands/clash_report.h"
#include "cli/options/length_rule.h"
#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/check/scene_reach.h"
#include "lib/mesh/load_mesh.h"

namespace gouge {
namespace {

/// Returns the parsed options. Errors (code usage) name the option, the typed text and the expected one.
Result<std::pair<ClashOptions, RigidTransform>> understand(const ClashArguments& a) {
  std::pair<ClashOptions, RigidTransform> understood;
  const Result<double> tolerance = understand_length("--tolerance", a.tolerance, Minimum::zero);
  if (!tolerance) return tolerance.error();
  const Result<double> resolution = understand_length("--resolution", a.resolution, Minimum::finest_resolution);
  if (!resolution) return resolution.error();
  if (const auto error = find_contradiction(a)) return *error;
  understood.first.tolerance_mm = *tolerance;
  understood.first.resolution_mm = understood.first.gap_mm = *resolution;
  if (a.place_b.empty()) return understood;
  const Result<RigidTransform> place = understand_place("--place-b", a.place_b);
  if (!place) return place.error();
  understood.second = *place;
  return understood;
}

Result<LoadedMesh> load(const std::string& file, const ClashArguments& arguments, const RigidTransform& place) {
  const LengthUnit unit = unit_called(arguments.stl_units).value_or(LengthUnit::mm);
  Result<LoadedMesh> loaded = load_mesh(file, {unit, place}, arguments.input.max_bytes);
  if (!loaded) return loaded;
  if (auto error = find_too_far(loaded->mesh, "body", "--stl-units and --place-b")) return *std::move(error);
  return loaded;
}

int clash_status(ClashState state) {
  if (state == ClashState::penetrating) return kExitGouges;
  return state == ClashState::not_certified ? kExitNotChecked : kExitClean;
}

}  // namespace

void add_clash_options(CLI::App& command, ClashArguments& arguments) {
  command.add_option("A", arguments.a, "STL file of the body that stays in place")->type_name("FILE")->required();
  command.add_option("B", arguments.b, "STL file of the body that a shift would move away from A")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--place-b", arguments.place_b,
                  "Placement of B in the coordinates of A, x,y,z[,rx,ry,rz]: lengths in mm or with a unit (0.5in), "
                  "then angles in degrees about the fixed axes X, Y, Z")
      ->type_name("X,Y,Z");
  command.add_option("--stl-units", arguments.stl_units, "Unit of the coordinates in the STL files")
      ->check(CLI::IsMember(unit_words()))
      ->capture_default_str();
  command.add_option("--tolerance", arguments.tolerance, "Maximum depth of bodies that touch without penetration")
      ->type_name("LENGTH")
      ->capture_default_str();
  command.add_option("--resolution", arguments.resolution, "Certified gap between the depth and its upper bound")
      ->type_name("LENGTH")
      ->capture_default_str();
  command
      .add_option("--json", arguments.json_file, "Write the result as JSON (- for standard output, without other text)")
      ->type_name("FILE");
  add_input_limit(command, arguments.input);
  add_verbosity(command, arguments, "Print notes of both files and the effort of the search");
  command.footer(
      "Examples:\n"
      "  gougecheck clash part.stl jaw.stl\n"
      "  gougecheck clash vise.stl part.stl --place-b 0,0,12.5,0,0,90 --json clash.json\n\n"
      "The depth is the largest distance to the surface of A or of B, over all points that lie in both bodies, "
      "not only vertices. Bodies without a common point are free. A body wholly inside the other is never free. "
      "The reported shift is proved to free B. A shorter shift may exist.\n\n"
      "Exit status: 0 proved free, or touching within tolerance + resolution; 1 the bodies penetrate; 2 wrong "
      "command line; 3 input unreadable; 4 not certified (a mesh is open, or the search reached its budget); 5 "
      "internal failure or output unwritable.");
}

int run_clash(const ClashArguments& arguments, std::ostream& out, std::ostream& err) {
  const auto understood = understand(arguments);
  if (!understood) return fail(err, {understood.error()});
  const OutputTable outputs = asked_for({{"--json", arguments.json_file}});
  if (const auto status = refuse_outputs({{"a mesh", arguments.a}, {"a mesh", arguments.b}}, outputs, err))
    return *status;
  if (unit_called(arguments.stl_units) == LengthUnit::inch && !arguments.lengths_in_mm.empty() && !arguments.is_quiet)
    print(err, {describe_lengths_in_mm(arguments.lengths_in_mm, "an STL file")});
  Result<LoadedMesh> a = load(arguments.a, arguments, {}), b = load(arguments.b, arguments, understood->second);
  for (const Result<LoadedMesh>* loaded : {&a, &b}) {
    if (!*loaded) return fail(err, {loaded->error()});
    print_notes(err, (*loaded)->notes, arguments);
  }
  const Surface surface_a(std::move(a->mesh)), surface_b(std::move(b->mesh));
  const ClashBody body_a(surface_a), body_b(surface_b);
  ClashReport report{arguments.a,       arguments.b, unit_called(arguments.stl_units).value_or(LengthUnit::mm),
                     understood->first, {},          {}};
  report.clash = find_clash(body_a, body_b, Vec3::Zero(), report.options);
  if (report.clash.state == ClashState::penetrating)
    report.shift = find_free_shift(body_a, body_b, report.clash, report.options);
  if (arguments.is_verbose) err << "spent: " << report.clash.bounds << " bounds\n";
  if (!arguments.json_file.empty()) {
    if (const Outcome written = write_output(arguments.json_file, clash_json(report), out); !written)
      return fail(err, {written.error()}, kExitInternal);
  }
  if (!arguments.is_quiet && arguments.json_file != "-") out << clash_text(report);
  return clash_status(report.clash.state);
}

}  // namespace gouge
