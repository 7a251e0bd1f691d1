#include "cli/library/checked_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cli/library/path_stock.h"
#include "cli/library/program_machine_key.h"
#include "cli/machine/joint_laws.h"
#include "cli/machine/machine_facts.h"
#include "cli/machine/rate_notes.h"
#include "cli/tools/identities.h"
#include "cli/tools/resolve_tools.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/check/check_options.h"
#include "lib/check/reach.h"
#include "lib/machine/linuxcnc_ini.h"
#include "postproc/gcode/running/program_setup.h"
#include "toolmodels/compile_tool.h"

namespace gougecheck {
namespace {

const std::vector<gouge::HeadBody>& no_heads() {
  static const std::vector<gouge::HeadBody> kNone;
  return kNone;
}

double length(const char* name, double value, double least = 0) {
  if (value >= least && value <= gouge::kFarthest_mm) return value;
  const std::string found = std::isfinite(value) ? gouge::exact_text(value) : std::string("no number");
  raise(gouge::make_error(
      "usage", std::string(name) + ": " + found + "; expected " + gouge::exact_text(least) + " to 100000 mm"));
}

gouge::ToolFacts facts_of(const gouge::ToolAssembly& tool) {
  gouge::ToolFacts facts;
  facts.name = gouge::label(tool);
  facts.defined_in = "memory";
  facts.description = gouge::shape_name(tool.cutter);
  facts.has_holder = !tool.holder.empty();
  gouge::identify_tool(tool, false, facts);
  return facts;
}

/// Returns the unit in which all meshes of files were read; mm if there are several units, or no files.
gouge::LengthUnit unit_of_files(const Scene& scene) {
  std::optional<gouge::LengthUnit> unit;
  for (const auto& meshes : {scene.parts(), scene.fixtures()}) {
    for (const Mesh& mesh : meshes) {
      if (mesh.content().file.name.empty()) continue;
      if (unit && *unit != mesh.content().unit) return gouge::LengthUnit::mm;
      unit = mesh.content().unit;
    }
  }
  return unit.value_or(gouge::LengthUnit::mm);
}

/// Returns the basis of the set-up: vouched facts and strictness as requested, and whether each mesh is solid.
gouge::SetupBasis basis_of(const Scene& scene, const PathTools& tools, const CheckOptions& options) {
  gouge::SetupBasis basis;
  basis.inputs = tools.assumptions;
  basis.is_strict = options.strict;
  for (const std::string& text : options.assume) {
    const std::optional<gouge::Vouched> vouched = gouge::parse_vouched(text);
    if (!vouched)
      raise(gouge::make_error(
          "usage", "assume '" + text + "': expected one of " + gouge::subject_names() + ", or such as tool=T3"));
    basis.vouched.push_back(*vouched);
  }
  bool are_units_known = true;
  for (const auto& meshes : {scene.parts(), scene.fixtures()}) {
    for (const Mesh& mesh : meshes) {
      basis.inputs.push_back(gouge::assume_solid(mesh.name(), mesh.content().findings));
      are_units_known = are_units_known && !mesh.content().has_unknown_unit;
    }
  }
  if (are_units_known) basis.mesh_unit = unit_of_files(scene);
  return basis;
}

/// Returns a length, or the interval "low..high" about it.
std::string length_range_text(double middle_mm, double half_mm) {
  const std::string low = gouge::exact_text(middle_mm - half_mm) + "mm";
  return half_mm > 0 ? low + ".." + gouge::exact_text(middle_mm + half_mm) + "mm" : low;
}

/// Returns the machine that the options name; null: none.
std::shared_ptr<const PathMachine> machine_of(const CheckOptions& options) {
  if (options.tool_length && !(*options.tool_length >= 0 && std::isfinite(*options.tool_length)))
    raise(gouge::make_error("usage", "tool_length: expected a length of at least 0 mm"));
  const gouge::StatedMachine stated = {options.machine,
                                       options.feed_law,
                                       options.rapid_law,
                                       options.tool_length,
                                       length("tool_length_slack", options.tool_length_slack),
                                       {options.joint_limits, options.joint_points, options.joint_rates},
                                       options.zero};
  std::optional<gouge::ChosenMachine> chosen =
      value_or_raise(gouge::choose_machine(stated, static_cast<gouge::RapidMode>(options.rapids), gouge::kMaxInputBytes,
                                           {"machine",
                                            "feed_law",
                                            "rapid_law",
                                            "rapids",
                                            "tool_length",
                                            {"joint_limits", "joint_points", "joint_rates"},
                                            "zero"}));
  if (!chosen) return nullptr;
  PathMachine made{std::move(*chosen), {{"machine", stated.machine}}};
  made.key = machine_key(stated);
  if (!stated.feed_law.empty()) made.options.push_back({"feed-law", stated.feed_law});
  if (!stated.rapid_law.empty()) made.options.push_back({"rapid-law", stated.rapid_law});
  if (stated.tool_length_mm) {
    const std::string key = gouge::MachineOptionNames().tool_length.substr(2);  // without its dashes
    made.options.push_back({key, length_range_text(*stated.tool_length_mm, stated.tool_length_slack_mm)});
  }
  if (!options.zero.empty()) made.options.push_back({"zero", options.zero});
  for (const std::string& text : options.joint_limits) made.options.push_back({"joint-limit", text});
  for (const std::string& text : options.joint_points) made.options.push_back({"joint-point", text});
  for (const std::string& text : options.joint_rates) made.options.push_back({"joint-rate", text});
  if (!stated.machine.starts_with(gouge::kMachinePreset))
    made.file = gouge::describe_input("machine", stated.machine, made.chosen.bytes);
  return std::make_shared<const PathMachine>(std::move(made));
}

/// Options with the machine that they name.
struct UnderstoodCheck {
  gouge::CheckOptions options;
  gouge::MotionTube stated_tube;               // without the addition for intervals
  std::shared_ptr<const PathMachine> machine;  // null: none
};

/// Throws if a program was read with another machine than that of its check: its joints would be those of the other.
void require_same_machine(const Path& path, const UnderstoodCheck& understood) {
  const gouge::Toolpath& program = path.content().path;
  if (program.joints == nullptr || program.dialect != gouge::kProgramDialect) return;
  const std::string of_check = understood.machine == nullptr ? "" : understood.machine->key;
  if (of_check.empty() || of_check != path.content().program.machine)
    raise(gouge::make_error("gcode-machine",
                            "the program was read with another machine than that of the check; expected the same "
                            "machine, joints, zero and tool length in both",
                            path.name()));
}

UnderstoodCheck understand(const CheckOptions& options) {
  UnderstoodCheck understood{to_check_options(options), {}, machine_of(options)};
  gouge::MotionTube& tube = understood.options.tube;
  if (understood.machine != nullptr) {
    const gouge::ChosenMachine& chosen = understood.machine->chosen;
    understood.options.law = chosen.law;
    if (!(options.tip_tolerance > 0)) tube.tip_mm = chosen.machine.control.tip_tolerance_mm;
    if (!(options.axis_tolerance > 0)) tube.axis_rad = chosen.machine.control.axis_tolerance_rad;
  }
  understood.stated_tube = tube;
  if (understood.machine != nullptr) tube.tip_mm += understood.machine->chosen.tip_slack_mm;
  return understood;
}

/// Returns the path with the joints of a machine.
Path with_joints(const Path& path, const PathMachine& machine) {
  return PathAccess::with_origin_of(path, joints_added(path.content().path, machine));
}

gouge::ToolUse use_of_tools(const CheckOptions& options) {
  return options.stock ? gouge::ToolUse::removes_stock : gouge::ToolUse::finds_gouges;
}

gouge::GaugeLength length_of_tool(const CheckOptions& options) {
  return {options.tool_length, options.tool_length_slack};
}

CheckedPath completed(Path path, const Scene& scene, std::shared_ptr<const PathTools> tools,
                      const CheckOptions& options, UnderstoodCheck understood) {
  gouge::SetupBasis basis = basis_of(scene, *tools, options);
  Scene taken = scene_in(scene, path.content().path.unit);
  require_same_machine(path, understood);
  if (understood.machine != nullptr) {
    const gouge::ChosenMachine& chosen = understood.machine->chosen;
    gouge::TurnLaws laws = chosen.laws;
    if (const auto law = gouge::turn_law_called(path.content().program.joint_rapid_law)) laws.joint_rapids = law;
    if (auto error = gouge::add_joint_laws(chosen.machine, laws, chosen.tool_length_mm, options.tool_length_slack,
                                           path.content().path, understood.options.law))
      raise(*error);
    basis.law_evidence = chosen.law_evidence;
    path = with_joints(path, *understood.machine);
  }
  const gouge::Machine* const machine = understood.machine == nullptr ? nullptr : &understood.machine->chosen.machine;
  const bool has_tolerances = options.tip_tolerance > 0 || options.axis_tolerance > 0;
  std::ranges::move(
      gouge::machine_facts(machine, {options.machine, understood.options.tube, has_tolerances}, path.content().path),
      std::back_inserter(basis.inputs));
  if (auto fact = gouge::rapid_fact(path.content().path, understood.options.law, machine))
    basis.inputs.push_back(std::move(*fact));
  std::shared_ptr<const PathStock> stock =
      make_path_stock(options, understood.options, path.content().path, taken.content().index->scene().parts,
                      tools->assemblies, understood.machine.get());
  if (stock != nullptr) basis.inputs.insert(basis.inputs.end(), stock->facts.begin(), stock->facts.end());
  return {std::move(path),
          std::move(taken),
          std::move(tools),
          std::move(understood.options),
          understood.stated_tube,
          std::move(basis),
          std::move(understood.machine),
          std::move(stock)};
}

}  // namespace

Path with_every_tool_named(const Path& path) {
  const gouge::Moves& moves = path.content().path.moves;
  const auto is_unnamed = [](const gouge::Move& move) { return move.tool == gouge::kNone; };
  if (std::none_of(moves.begin(), moves.end(), is_unnamed)) return path;
  gouge::Toolpath named = path.content().path;
  const std::size_t tool = named.tools.size();
  named.tools.emplace_back().name = "tool";
  for (gouge::Move& move : named.moves) {
    if (is_unnamed(move)) move.tool = tool;
  }
  return PathAccess::with_origin_of(path, std::move(named));
}

gouge::Toolpath joints_added(gouge::Toolpath path, const PathMachine& machine) {
  const gouge::ChosenMachine& chosen = machine.chosen;
  gouge::Diagnostics notes = gouge::describe_missing_axes(chosen.machine, machine.options.front().value);
  std::ranges::move(gouge::choose_joints_of(chosen.machine, chosen.law, chosen.tool_length_mm,
                                            gouge::needs_turn(chosen.laws, false), path),
                    std::back_inserter(notes));
  std::ranges::move(gouge::describe_rate_excesses(chosen.machine, chosen.laws.feeds, path), std::back_inserter(notes));
  std::ranges::move(notes, std::back_inserter(path.notes));
  return path;
}

std::vector<const gouge::ToolVariants*> PathTools::pointers() const {
  std::vector<const gouge::ToolVariants*> all;
  for (const auto& form : variants) all.push_back(form ? &*form : nullptr);
  return all;
}

gouge::CheckOptions to_check_options(const CheckOptions& options) {
  gouge::CheckOptions result;
  result.tolerance_mm = length("tolerance", options.tolerance);
  result.resolution_mm = length("resolution", options.resolution, gouge::kFinestResolution_mm);
  result.stock_to_leave_mm = length("stock_to_leave", options.stock_to_leave);
  result.shank_clearance_mm = length("shank_clearance", options.shank_clearance);
  result.holder_clearance_mm = length("holder_clearance", options.holder_clearance);
  result.near_miss_mm = length("near_miss", options.near_miss);
  result.law = static_cast<gouge::RapidMode>(options.rapids);
  result.tube.tip_mm = length("tip_tolerance", options.tip_tolerance);
  if (!(options.axis_tolerance >= 0 && options.axis_tolerance <= gouge::kMaxAxisTolerance_deg))
    raise(gouge::make_error("usage", "axis_tolerance: expected degrees from 0 to 10"));
  result.tube.axis_rad = options.axis_tolerance * gouge::kDegree_rad;
  result.threads = std::min(options.threads, gouge::kMaxThreads);
  return result;
}

gouge::ToolVariants compile(const gouge::ToolAssembly& tool, const gouge::CheckOptions& options, bool has_wide) {
  return value_or_raise(gouge::make_tool_variants(tool, options.stock_to_leave_mm, options.shank_clearance_mm,
                                                  options.holder_clearance_mm, has_wide, options.tube));
}

CheckedPath prepare(const Path& path, const Scene& scene, const Tool& tool, const CheckOptions& options) {
  Path named = with_every_tool_named(path);
  const gouge::Toolpath& toolpath = named.content().path;
  const std::vector<bool> is_used = gouge::used_tools(toolpath);
  const auto used = std::count(is_used.begin(), is_used.end(), true);
  if (used > 1) {
    raise(gouge::make_error("tool-ambiguous",
                            "the path calls " + std::to_string(used) +
                                " tools and one was given; expected a library that has them by number or name",
                            toolpath.file));
  }
  const gouge::ToolAssembly& assembly = tool.content().assembly;
  UnderstoodCheck understood = understand(options);
  auto tools = std::make_shared<PathTools>();
  const bool has_wide = std::ranges::any_of(toolpath.moves, &gouge::Move::needs_wide_tool);
  tools->variants.assign(toolpath.tools.size(), compile(assembly, understood.options, has_wide));
  tools->facts.assign(toolpath.tools.size(), facts_of(assembly));
  tools->assemblies.assign(toolpath.tools.size(), assembly);
  tools->assumptions =
      value_or_raise(gouge::resolve_given(toolpath, assembly, use_of_tools(options), length_of_tool(options)))
          .assumptions;
  return completed(std::move(named), scene, std::move(tools), options, std::move(understood));
}

CheckedPath prepare(const Path& path, const Scene& scene, const ToolLibrary& library, const CheckOptions& options) {
  const gouge::Toolpath& toolpath = path.content().path;
  UnderstoodCheck understood = understand(options);
  const gouge::ToolLibrary* const given =
      library.content().library.tools.empty() ? nullptr : &library.content().library;
  gouge::ResolvedTools resolved =
      value_or_raise(gouge::resolve_tools(toolpath, given, {}, {}, use_of_tools(options), length_of_tool(options)));
  auto tools = std::make_shared<PathTools>();
  for (const auto& assembly : resolved.assemblies) {
    tools->variants.emplace_back();
    const std::size_t index = tools->variants.size() - 1;
    if (assembly) tools->variants.back() = compile(*assembly, understood.options, needs_wide_tool(toolpath, index));
  }
  if (std::ranges::none_of(tools->variants, [](const auto& form) { return form.has_value(); })) {
    raise(gouge::make_error("no-tool",
                            "no tool of the path is defined, so nothing can be checked; expected one of its number or "
                            "name in the library, or CUTTER or TLDATA in the path",
                            toolpath.file));
  }
  tools->facts = std::move(resolved.facts);
  tools->notes = std::move(resolved.notes);
  tools->assumptions = std::move(resolved.assumptions);
  tools->assemblies = std::move(resolved.assemblies);
  for (std::size_t i = 0; i < tools->assemblies.size(); ++i)
    if (tools->assemblies[i]) gouge::identify_tool(*tools->assemblies[i], false, tools->facts[i]);
  tools->files = library.content().files;
  tools->is_by_facts = library.content().is_by_facts;
  return completed(path, scene, std::move(tools), options, std::move(understood));
}

gouge::CheckSetup CheckedPath::setup() const {
  return {.tools = tools->pointers(),
          .heads = no_heads(),
          .scene = scene.content().index->prepared(options.threads),
          .options = options,
          .basis = basis,
          .stock = stock == nullptr ? nullptr : &*stock->setup};
}

}  // namespace gougecheck
