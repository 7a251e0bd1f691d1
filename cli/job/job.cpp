#include "cli/job/job.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>

#include "cli/job/read_inputs.h"
#include "cli/machine/joint_laws.h"
#include "cli/machine/machine_choice.h"
#include "cli/machine/machine_facts.h"
#include "cli/machine/program_machine.h"
#include "cli/machine/rate_notes.h"
#include "cli/options/joint_options.h"
#include "cli/options/length_rule.h"
#include "cli/terminal/length_text.h"
#include "cli/tools/head_facts.h"
#include "cli/tools/identities.h"
#include "cli/tools/resolve_tools.h"
#include "lib/base/units.h"
#include "lib/check/scene_reach.h"
#include "lib/geom/pose.h"
#include "lib/machine/joint_reach.h"
#include "lib/machine/linuxcnc_ini.h"
#include "lib/mesh/chord_error.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/report/remedies.h"
#include "postproc/report/report_model.h"
#include "postproc/report/report_text.h"
#include "toolmodels/assembly.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

// Estimates for each event the chord error of its part at the triangle of the worst move; 0 for other events.
std::vector<double> chord_errors_mm(const std::vector<IndexedMesh>& parts, const CheckResult& result) {
  std::vector<double> errors(result.events.size(), 0);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    std::vector<std::uint32_t> triangles;
    std::vector<std::size_t> events;
    for (std::size_t i = 0; i < result.events.size(); ++i) {
      const Event& event = result.events[i];
      const Boxed<Witness>& witness = result.verdicts[event.worst_move].witness;
      const bool is_in_part = event.state == MoveState::gouge && event.against == Against::part && witness;
      if (!is_in_part || witness->mesh != part) continue;
      triangles.push_back(witness->triangle);
      events.push_back(i);
    }
    if (triangles.empty()) continue;
    const std::vector<double> found = estimate_chord_errors_mm(parts[part], triangles);
    for (std::size_t k = 0; k < events.size(); ++k) errors[events[k]] = found[k];
  }
  return errors;
}

class JobLoader {
 public:
  JobLoader(const JobArguments& arguments, const JobOptions& options, Progress& progress)
      : arguments_(arguments), progress_(progress) {
    job_.options = options;
  }

  LoadedJob run(const SceneSource& scenes) {
    LoadedJob loaded;
    const bool has_path = read_path() && read_machine();
    read_scene(scenes);
    if (has_path && errors_.empty()) read_tools();
    if (errors_.empty()) assume_inputs();
    loaded.errors = errors_;
    loaded.searches = job_.searches;
    if (errors_.empty()) loaded.job = std::move(job_);
    return loaded;
  }

 private:
  /// Chooses the machine, which a program of a control needs to be read.
  [[nodiscard]] StatedMachine stated_machine() const {
    const JobArguments& a = arguments_;
    StatedMachine stated = {
        a.machine, a.feed_law, a.rapid_law,     job_.options.tool_length_mm, job_.options.tool_length_slack_mm,
        a.joints,  a.zero,     !a.heads.empty()};
    stated.joint_rapid_law = a.joint_rapid_law;
    return stated;
  }

  /// Returns what the options state about the control of a program without a machine.
  [[nodiscard]] ControlFacts control_facts() const {
    const JobArguments& a = arguments_;
    const MotionTube& tube = job_.options.check.tube;
    ControlFacts facts;
    facts.joint_rapid_law = turn_law_called(a.joint_rapid_law);
    if (!(job_.options.tool_length_slack_mm > 0)) facts.tool_length_mm = job_.options.tool_length_mm;
    if (!a.tip_tolerance.empty()) facts.tip_tolerance_mm = tube.tip_mm;
    if (!a.axis_tolerance.empty()) facts.axis_tolerance_rad = tube.axis_rad;
    return facts;
  }

  /// Adds the machine and the lengths of tools to the set-up of a program.
  bool complete_program(const std::optional<ChosenMachine>& chosen) {
    const JobArguments& a = arguments_;
    std::string bytes;
    if (auto error = read_tool_lengths(a.reading, a.input.max_bytes, job_.options.reading, bytes)) {
      errors_.push_back(std::move(*error));
      return false;
    }
    if (!a.reading.tool_lengths.empty()) lengths_input_ = describe_input("tool-lengths", a.reading.tool_lengths, bytes);
    if (!chosen) {
      if (job_.options.reading.program)
        job_.options.reading.program = with_control(job_.options.reading.program, control_facts());
      return true;
    }
    const double tip_mm =
        a.tip_tolerance.empty() ? chosen->machine.control.tip_tolerance_mm : job_.options.check.tube.tip_mm;
    const double axis_rad =
        a.axis_tolerance.empty() ? chosen->machine.control.axis_tolerance_rad : job_.options.check.tube.axis_rad;
    job_.options.reading.program = with_machine(job_.options.reading.program, chosen->machine, stated_machine(),
                                                chosen->laws, stated_tolerance(tip_mm), stated_tolerance(axis_rad));
    return true;
  }

  bool read_path() {
    chosen_ = choose_machine(stated_machine(), job_.options.check.law.rapid(), arguments_.input.max_bytes);
    if (*chosen_ && !complete_program(**chosen_)) return false;
    std::optional<Toolpath> path = read_path_file(arguments_.path, "toolpath", arguments_.input.max_bytes,
                                                  job_.options.reading, progress_, job_.inputs, job_.searches, errors_);
    if (lengths_input_) job_.inputs.push_back(*lengths_input_);
    if (!path) {
      const bool is_for_machine = !errors_.empty() && errors_.back().code.starts_with("gcode-");
      if (!*chosen_ && is_for_machine) errors_ = {chosen_->error()};
      return false;
    }
    job_.toolpath = std::move(*path);
    add_notes(job_.toolpath.notes);
    if (job_.toolpath.unit == LengthUnit::inch && !arguments_.lengths_in_mm.empty())
      job_.notes.push_back(describe_lengths_in_mm(arguments_.lengths_in_mm, "the toolpath"));
    return true;
  }

  bool read_machine() {
    const JobArguments& a = arguments_;
    Result<std::optional<ChosenMachine>>& chosen = *chosen_;
    if (!chosen) {
      errors_.push_back(chosen.error());
      return false;
    }
    if (!*chosen) return true;
    ChosenMachine& machine = **chosen;
    if (!a.machine.starts_with(kMachinePreset))
      job_.inputs.push_back(describe_input("machine", a.machine, machine.bytes));
    if (auto error = add_joint_laws(machine.machine, machine.laws, job_.options.tool_length_mm,
                                    job_.options.tool_length_slack_mm, job_.toolpath, machine.law)) {
      errors_.push_back(std::move(*error));
      return false;
    }
    job_.options.check.law = std::move(machine.law);
    job_.basis.law_evidence = std::move(machine.law_evidence);
    job_.machine = std::move(machine.machine);
    job_.laws = machine.laws;
    if (!take_tube(job_.machine->control, machine.tip_slack_mm)) return false;
    add_notes(describe_missing_axes(*job_.machine, a.machine));
    add_notes(choose_joints_of(*job_.machine, job_.options.check.law, job_.options.tool_length_mm,
                               needs_turn(job_.laws, !a.heads.empty()), job_.toolpath));
    add_notes(describe_rate_excesses(*job_.machine, job_.laws.feeds, job_.toolpath));
    return true;
  }

  /// Takes the tolerances of a control that no option states, and what intervals add to them.
  bool take_tube(const Control& control, double tip_slack_mm) {
    MotionTube& tube = job_.options.check.tube;
    if (arguments_.tip_tolerance.empty()) tube.tip_mm = control.tip_tolerance_mm;
    if (arguments_.axis_tolerance.empty()) tube.axis_rad = control.axis_tolerance_rad;
    tube.tip_mm += tip_slack_mm;
    if (tube.is_empty() || arguments_.heads.empty()) return true;
    if (tip_slack_mm > 0) {
      errors_.push_back(make_error("usage",
                                   "intervals of --machine and --tool-length cover the tool, not the bodies of "
                                   "--head; give single values, or leave out --head"));
      return false;
    }
    errors_.push_back(make_error("usage",
                                 "the tolerances of the control of --machine cover the tool, not the bodies of --head; "
                                 "give --tip-tolerance 0 and --axis-tolerance 0, or leave out --head"));
    return false;
  }

  [[nodiscard]] LengthUnit stl_unit() const { return job_.stl_unit(arguments_); }

  void read_scene(const SceneSource& scenes) {
    const JobArguments& a = arguments_;
    job_.files = scenes({a.parts, a.fixtures, a.heads, stl_unit(), job_.options.place, a.place, a.input.max_bytes,
                         job_.options.check.threads, nullptr, job_.options.limits},
                        progress_);
    errors_.insert(errors_.end(), job_.files->errors.begin(), job_.files->errors.end());
    job_.inputs.insert(job_.inputs.end(), job_.files->inputs.begin(), job_.files->inputs.end());
    add_notes(job_.files->notes);
  }

  void read_tools() {
    progress_.begin("reading the tools");
    std::optional<ToolLibrary> library;
    if (!arguments_.tools_file.empty()) {
      Result<ToolLibrary> read =
          read_tool_file(arguments_.tools_file, "tools", arguments_.input.max_bytes, job_.inputs, job_.searches);
      if (!read) return errors_.push_back(read.error());
      library = std::move(*read);
      add_notes(library->notes);
    }
    Result<ResolvedTools> resolved =
        resolve_tools(job_.toolpath, library ? &*library : nullptr, arguments_.tool_names, arguments_.holder,
                      arguments_.stock.empty() ? ToolUse::finds_gouges : ToolUse::removes_stock,
                      {job_.options.tool_length_mm, job_.options.tool_length_slack_mm});
    if (!resolved) return errors_.push_back(resolved.error());
    const bool is_any_defined =
        std::ranges::any_of(resolved->assemblies, [](const auto& assembly) { return assembly.has_value(); });
    if (!is_any_defined) {
      if (library) errors_.insert(errors_.end(), library->notes.begin(), library->notes.end());
      return errors_.push_back(describe_missing_tools(job_.toolpath, arguments_.tools_file));
    }
    add_notes(resolved->notes);
    job_.tool_facts = std::move(resolved->facts);
    job_.basis.inputs = std::move(resolved->assumptions);
    job_.assemblies = std::move(resolved->assemblies);
    identify_tools();
    for (const auto& assembly : job_.assemblies) {
      job_.variants.emplace_back();
      if (!assembly) continue;
      const CheckOptions& c = job_.options.check;
      Result<ToolVariants> variants =
          make_tool_variants(arguments_.is_extended_up ? job_.without_end(*assembly) : *assembly, c.stock_to_leave_mm,
                             c.shank_clearance_mm, c.holder_clearance_mm,
                             needs_wide_tool(job_.toolpath, job_.variants.size() - 1), c.tube);
      if (!variants) return errors_.push_back(variants.error());
      job_.variants.back() = std::move(*variants);
    }
  }

  void identify_tools() {
    for (std::size_t i = 0; i < job_.assemblies.size(); ++i) {
      if (job_.assemblies[i]) identify_tool(*job_.assemblies[i], arguments_.is_extended_up, job_.tool_facts[i]);
    }
  }

  // Collects the facts stated on the command line, in the project file and by the files.
  void assume_inputs() {
    SetupBasis& basis = job_.basis;
    const bool has_tolerances = !arguments_.tip_tolerance.empty() || !arguments_.axis_tolerance.empty();
    const Machine* const machine = job_.machine ? &*job_.machine : nullptr;
    std::ranges::move(
        machine_facts(machine, {arguments_.machine, job_.options.check.tube, has_tolerances}, job_.toolpath),
        std::back_inserter(basis.inputs));
    if (auto fact = rapid_fact(job_.toolpath, job_.options.check.law, machine))
      basis.inputs.push_back(std::move(*fact));
    if (!job_.heads().empty())
      std::ranges::move(head_facts(job_.toolpath, job_.assemblies, job_.machine ? job_.machine->name : ""),
                        std::back_inserter(basis.inputs));
    for (const MeshFacts* mesh : meshes()) basis.inputs.push_back(mesh->solid);
    if (!arguments_.stl_units.empty()) basis.mesh_unit = stl_unit();
    basis.place = arguments_.place;
    basis.vouched = job_.options.vouched;
    basis.is_strict = arguments_.is_strict;
  }

  [[nodiscard]] std::vector<const MeshFacts*> meshes() const {
    std::vector<const MeshFacts*> all;
    for (const auto* facts : {&job_.files->parts, &job_.files->fixtures, &job_.files->head_facts}) {
      for (const MeshFacts& mesh : *facts) all.push_back(&mesh);
    }
    return all;
  }

  void add_notes(const Diagnostics& notes) { job_.notes.insert(job_.notes.end(), notes.begin(), notes.end()); }

  const JobArguments& arguments_;
  Progress& progress_;
  Job job_;
  Diagnostics errors_;
  std::optional<Result<std::optional<ChosenMachine>>> chosen_;
  std::optional<InputFile> lengths_input_;
};

}  // namespace

std::vector<const ToolVariants*> Job::tools() const {
  std::vector<const ToolVariants*> all;
  for (const auto& form : variants) all.push_back(form ? &*form : nullptr);
  return all;
}

ToolAssembly Job::without_end(const ToolAssembly& tool) const {
  const Result<Profile> profile = make_profile(tool);
  if (!profile) return tool;
  return extended_up(tool, reach_mm(toolpath, scene()) + compile_tool("", *profile).r_max_mm);
}

CheckSetup Job::setup(const PreparedScene& prepared) const {
  return {tools(), heads(), prepared, options.check, nullptr, basis};
}

namespace {

/// Returns the options in force that are not in CheckOptions, as they were typed.
std::vector<OptionText> options_in_force(const JobArguments& arguments) {
  std::vector<OptionText> options = recorded_options(arguments.reading, reading_options());
  std::ranges::move(recorded_options(arguments, job_options()), std::back_inserter(options));
  std::ranges::move(recorded_options(arguments.joints, joint_options()), std::back_inserter(options));
  std::ranges::move(recorded_options(arguments, stock_options()), std::back_inserter(options));
  std::ranges::move(recorded_options(arguments, left_stock_options()), std::back_inserter(options));
  for (const auto& [file, limits] : arguments.part_limits) options.push_back({"part", file + "," + limits});
  for (const auto& [file, limits] : arguments.fixture_limits) options.push_back({"fixture", file + "," + limits});
  return options;
}

}  // namespace

ReportModel Job::report(const JobArguments& arguments, const Toolpath& path, const CheckResult& result,
                        ReportParts parts) const {
  ReportModel model;
  model.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  model.sign_off = {options.date, arguments.command, arguments.project, arguments.reviewer, arguments.batch_job};
  model.inputs = inputs;
  if (arguments.project_file) model.inputs.push_back(arguments.project_file->input);
  model.options = options.check;
  model.placement = placement_identity(options.place, stl_unit(arguments));
  model.more_options = options_in_force(arguments);
  model.toolpath = &path;
  model.result = &result;
  model.parts = files->parts;
  model.fixtures = files->fixtures;
  model.heads = files->head_facts;
  model.tools = tool_facts;
  model.notes = notes;
  if (arguments.project_file)
    model.notes.push_back(make_note(kProjectFile, arguments.project_file->summary, arguments.project_file->input.name));
  const Diagnostics open = open_warnings(result.assumptions);
  model.notes.insert(model.notes.end(), open.begin(), open.end());
  std::ranges::move(describe_unused(basis.vouched, result.assumptions, path.file), std::back_inserter(model.notes));
  model.notes.insert(model.notes.end(), parts.notes.begin(), parts.notes.end());
  std::ranges::move(parts.more_options, std::back_inserter(model.more_options));
  model.has_correction = parts.correction.has_value();
  if (parts.correction) model.correction = std::move(*parts.correction);
  model.stickout_options = parts.stickout_options;
  model.stickouts = std::move(parts.stickouts);
  model.cure_options = parts.cure_options;
  model.cures = std::move(parts.cures);
  model.chord_errors_mm = chord_errors_mm(scene().parts, result);
  model.laws = std::move(parts.laws);
  model.certificate_bytes = parts.certificate_bytes;
  model.stock_left = std::move(parts.stock_left);
  model.shown_stock = parts.shown_stock;
  return model;
}

std::shared_ptr<const PoseReach> Job::reach() const {
  if (!machine) return nullptr;
  return std::make_shared<const JointReach>(*machine, toolpath, options.tool_length_mm);
}

LengthUnit Job::stl_unit(const JobArguments& arguments) const {
  if (arguments.stl_units.empty()) return toolpath.unit;
  return unit_called(arguments.stl_units).value_or(LengthUnit::mm);
}

LoadedJob load_job(const JobArguments& arguments, const JobOptions& options, Progress& progress,
                   const SceneSource& scenes) {
  return JobLoader(arguments, options, progress).run(scenes);
}

Result<Toolpath> read_again(const Job& job, const std::string& file, std::string bytes) {
  ReadOptions reading = job.options.reading;
  reading.dialect = dialect_called(job.toolpath.dialect);
  reading.keeps_origins = false;
  ReadOutcome outcome = read_toolpath(file, std::move(bytes), reading);
  if (!outcome.toolpath) return outcome.errors.front();
  if (job.machine)
    static_cast<void>(choose_joints_of(*job.machine, job.options.check.law, job.options.tool_length_mm,
                                       needs_turn(job.laws, !job.heads().empty()), *outcome.toolpath));
  // The dialect was given in this call. The report must state how the dialect of the first file is known.
  copy_facts(Subject::dialect, job.toolpath.assumptions, outcome.toolpath->assumptions);
  return std::move(*outcome.toolpath);
}

}  // namespace gouge
