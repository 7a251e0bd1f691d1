#include "cli/options/job_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iterator>

#include "cli/machine/machine_choice.h"
#include "cli/options/joint_options.h"
#include "cli/options/length_rule.h"
#include "cli/options/tube_options.h"
#include "cli/terminal/length_text.h"
#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "lib/base/printable_text.h"
#include "postproc/export/write_scene.h"

namespace gouge {

namespace {

constexpr const char* kCheckGroup = "Check";

constexpr const char* kPlaceHelp =
    "Placement of the STL files, x,y,z[,rx,ry,rz]: lengths in mm or with a unit (0.5in), then angles in degrees "
    "about the fixed axes X, Y, Z";
constexpr const char* kStlUnitsHelp = "Unit of the STL files (default: the unit of the toolpath)";

void add_path(CLI::App& command, JobArguments& a) {
  command.add_option("PATH", a.path, "Toolpath: CL data of any dialect, recognized by its content")
      ->type_name("FILE")
      ->required();
}

OptionRows<JobArguments> input_rows() {
  using A = JobArguments;
  using Texts = std::vector<std::string>;
  return {
      {.name = "--part",
       .field = +[](A& a, const Texts& typed) { split_limits(typed, a.parts, a.part_limits); },
       .type = "FILE",
       .help = "Finished part that must not be cut into (STL; repeatable). A tolerance for this file is "
               "appended: part.stl,tolerance=0.002",
       .scope = Scope::project},
      {.name = "--fixture",
       .field = +[](A& a, const Texts& typed) { split_limits(typed, a.fixtures, a.fixture_limits); },
       .type = "FILE",
       .help = "Fixture that must not be touched (STL; repeatable). A clearance or tolerance for this file is "
               "appended: vise.stl,clearance=1",
       .scope = Scope::project},
      {.name = "--allow-overlap",
       .field = &A::allowed_overlaps,
       .type = "FIXTURE",
       .help = "Do not warn that this fixture penetrates a part: the overlap is intended (repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::shown},
      {.name = "--head",
       .field = &A::heads,
       .type = "FILE",
       .help = "Body that moves with the tool but is not in its profile: machine head, angle head, clamp (closed "
               "STL in the frame of the tool: tip at 0,0,0, z towards the spindle; repeatable)",
       .scope = Scope::project,
       .recorded = Recorded::shown},
      {.name = "--place",
       .field = &A::place,
       .type = "X,Y,Z",
       .help = kPlaceHelp,
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .result_text = with_units},
      {.name = "--stl-units",
       .field = &A::stl_units,
       .help = kStlUnitsHelp,
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = unit_words()},
      {.name = "--tools",
       .field = &A::tools_file,
       .type = "FILE",
       .help =
           "Tool library: JSON, or one of Fusion, FreeCAD, NX, CAMotics or LinuxCNC (.tbl). Tools that are not in it are read "
           "from CUTTER or TLDATA of the toolpath",
       .scope = Scope::project},
      {.name = "--tool",
       .field = &A::tool_names,
       .type = "N=NAME",
       .help =
           "Assignment of tools (repeatable). N=NAME: the tool N of the toolpath is the tool NAME of the library, each a "
           "number or a name. NAME alone: the tool of all moves for which the toolpath names no "
           "tool",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--holder",
       .field = &A::holder,
       .type = "NAME",
       .help = "Holder for tools without one: its name in the library",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--max-input",
       .field = +[](CLI::App& command, A& a) { add_input_limit(command, a.input); },
       .type = "SIZE",
       .scope = Scope::project},
      {.name = "--extend-up",
       .field = &A::is_extended_up,
       .help = "Extend the top body of every tool upwards without limit, so that the space above the described "
               "tool is checked too",
       .scope = Scope::project,
       .recorded = Recorded::repeated}};
}

OptionRows<JobArguments> check_rows() {
  using A = JobArguments;
  return {
      {.name = "--tolerance",
       .field = &A::tolerance,
       .type = "LENGTH",
       .group = kCheckGroup,
       .help = "Maximum depth that a move may have in parts and fixtures",
       .scope = Scope::project},
      {.name = "--stock-to-leave",
       .field = &A::stock_to_leave,
       .type = "LENGTH",
       .help = "Thickness by which the cutter grows against the part",
       .scope = Scope::project},
      {.name = "--clearance",
       .field = &A::clearance,
       .type = "BODY=LENGTH",
       .help = "Distance that shank and holder must keep from parts and fixtures: shank=0.5,holder=1 (in mm, or "
               "with a unit: holder=0.04in)",
       .scope = Scope::project},
      {.name = "--near-miss",
       .field = &A::near_miss,
       .type = "LENGTH",
       .help =
           "Report rapids, shanks and holders that come closer to a part or fixture than this, and cutters that come closer "
           "to a fixture; a cutter that feeds along the part is meant to be near (0: off)",
       .scope = Scope::project},
      {.name = "--resolution",
       .field = &A::resolution,
       .type = "LENGTH",
       .help = "Maximum depth above the tolerance that the check may miss (certified gap)",
       .scope = Scope::project},
      {.name = "--rapid",
       .field = &A::rapid,
       .help = "Path of rapid moves (skip: rapid moves are not checked)",
       .scope = Scope::project,
       .choices = {kRapidWords.begin(), kRapidWords.end()}},
      {.name = "--machine",
       .field = &A::machine,
       .type = "FILE",
       .group = kMachineGroup,
       .help = kMachineHelp,
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--feed-law",
       .field = &A::feed_law,
       .help =
           "Law of motion of feed moves. vector: the tool axis turns on the great circle. axis: both rotary "
           "joints run at constant rates. documented: the move must be clean by vector and by axis. any: it must be clean "
           "wherever the rotary joints are between their ends. joint: all joints run at constant rates, without tool "
           "centre point control (default: the law of the control of --machine, or documented if it promises none)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {kTurnLawNames.begin(), kTurnLawNames.begin() + kFeedLaws}},
      {.name = "--rapid-law",
       .field = &A::rapid_law,
       .help =
           "Law of motion of rapid moves, with the values and the default of --feed-law. independent: each joint runs at "
           "its own rate until it arrives",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {kTurnLawNames.begin(), kTurnLawNames.end()}},
      {.name = "--joint-rapid-law",
       .field = &A::joint_rapid_law,
       .help = kJointRapidLawHelp,
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .choices = {"joint", "independent"}},
      {.name = "--tool-length",
       .field = &A::tool_length,
       .type = "LENGTH",
       .help =
           "Length from the gauge point of --machine to the tool tip, or an interval: 120..120.1; the laws joint and "
           "independent require it for a rotary head",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--zero",
       .field = &A::zero,
       .type = "X,Y,Z",
       .help = kZeroHelp,
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--tip-tolerance",
       .field = &A::tip_tolerance,
       .type = "LENGTH",
       .help = "Maximum distance of the tool tip from its path that the smoothing of the control may cause "
               "(CYCLE832, G64 P; default: 0)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .result_text = with_units},
      {.name = "--axis-tolerance",
       .field = &A::axis_tolerance,
       .type = "DEG",
       .help = "Maximum angle by which the smoothing of the control may turn the tool axis away from the law of "
               "motion (OTOL, TA; default: 0)",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--assume",
       .field = &A::assumed,
       .type = "FACT[=OBJECT]",
       .group = kCheckGroup,
       .help = "State a fact that the inputs do not establish (repeatable): " + subject_names() +
               "; tool=T3 states it for one of several objects",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--strict",
       .field = &A::is_strict,
       .help = "Allow no defaults: a path is clean only if every fact is established",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--warnings-as-errors",
       .field = &A::has_warnings_as_errors,
       .help = "Allow no warnings: a path is clean only if the result has no warning, and otherwise the exit "
               "status is 4 instead of 0",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--threads", .field = +[](CLI::App& command, A& a) { add_threads_option(command, a.threads); }},
      {.name = "--project",
       .field = &A::project,
       .type = "NAME",
       .help = "Project, order or part number for the head of the report",
       .scope = Scope::project},
      {.name = "--reviewer",
       .field = &A::reviewer,
       .type = "NAME",
       .help = "Name of the reviewer, for the head and the signature line of the report",
       .scope = Scope::project}};
}

OptionRows<JobArguments> output_rows() {
  using A = JobArguments;
  return {
      {.name = "--report",
       .field = &A::report_folder,
       .type = "FOLDER",
       .group = kOutputGroup,
       .help = "Folder for the report: report.html, pictures, JSON and CSV. Only files of an older report are "
               "replaced"},
      {.name = "--json",
       .field = &A::json_file,
       .type = "FILE",
       .help = "Write the result as JSON (- for standard output, without other text)"},
      {.name = "--csv",
       .field = &A::csv_file,
       .type = "FILE",
       .help = "Write one row of CSV for every move (- for standard output, without other text)"},
      {.name = "--sarif", .field = &A::sarif_file, .type = "FILE", .help = "Write SARIF 2.1.0 for code review tools"},
      {.name = "--junit", .field = &A::junit_file, .type = "FILE", .help = "Write JUnit XML for build servers"},
      {.name = "--export",
       .field = &A::export_files,
       .type = "FILE",
       .help = "Write the part with depth and overcut at its vertices, the path and the tool for other 3D "
               "programs (repeatable). The ending selects the format: .glb (Blender), .vtp (ParaView), .ply "
               "(MeshLab)"}};
}

void add_output_options(CLI::App& command, JobArguments& a) {
  static const OptionRows<JobArguments> rows = output_rows();
  add_options(command, a, rows);
  add_listing_options(command, a.listing);
  add_progress_option(command, a.progress);
  add_verbosity(command, a,
                "Print under each finding its statement, and print notes of all inputs, effort and peak memory "
                "of the check (not with -q)",
                "Print no findings, only errors, warnings of facts that are not established, and the note of the "
                "project file");
}

}  // namespace

void add_placement_options(CLI::App& command, std::string& place, std::string& stl_units) {
  command.add_option("--place", place, kPlaceHelp)->type_name("X,Y,Z");
  command.add_option("--stl-units", stl_units, kStlUnitsHelp)->check(CLI::IsMember(unit_words()));
}

void add_threads_option(CLI::App& command, std::uint32_t& threads) {
  command
      .add_option("--threads", threads,
                  "Maximum number of threads, up to 1024 (0: as many as the machine has; 1: no additional thread)")
      ->capture_default_str();
}

void add_progress_option(CLI::App& command, std::string& progress) {
  command.add_option("--progress", progress, "Show progress on standard error (auto: if it is a terminal)")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str()
      ->group(kTerminalGroup);
}

const OptionRows<JobArguments>& job_options() {
  static const OptionRows<JobArguments> rows = [] {
    OptionRows<JobArguments> all = input_rows();
    std::ranges::move(check_rows(), std::back_inserter(all));
    return all;
  }();
  return rows;
}

void add_common_job_options(CLI::App& command, JobArguments& arguments, bool needs_part) {
  command.option_defaults()->group("Input");
  add_options(command, arguments.reading, reading_options());
  add_options(command, arguments, job_options());
  add_options(command, arguments.joints, joint_options());
  command.get_option("--part")->required(needs_part);
}

void add_job_options(CLI::App& command, JobArguments& arguments) {
  add_path(command, arguments);
  add_common_job_options(command, arguments, true);
  add_output_options(command, arguments);
}

namespace {

/// Requires that the tolerance is known.
std::optional<Diagnostic> add_limits(const JobArguments& a, JobOptions& options) {
  const double tolerance_mm = options.check.tolerance_mm;
  for (const Result<std::vector<MeshLimit>>& limits :
       {understand_limits("--part", Against::part, a.parts, a.part_limits, tolerance_mm),
        understand_limits("--fixture", Against::fixture, a.fixtures, a.fixture_limits, tolerance_mm)}) {
    if (!limits) return limits.error();
    options.limits.insert(options.limits.end(), limits->begin(), limits->end());
  }
  return std::nullopt;
}

}  // namespace

Result<JobOptions> understand(const JobArguments& a) {
  JobOptions options;
  const Result<ReadOptions> reading = understand(a.reading);
  if (!reading) return reading.error();
  // The command line knows the words; a result that `verify` repeats may have others.
  if (!a.stl_units.empty() && !unit_called(a.stl_units))
    return usage_error("--stl-units", a.stl_units, "one of " + listed(unit_words()));
  options.reading = *reading;
  for (const std::string& name : a.allowed_overlaps) {
    if (std::find(a.fixtures.begin(), a.fixtures.end(), name) == a.fixtures.end())
      return usage_error("--allow-overlap", name, "a file of --fixture, named as there");
  }
  for (const std::string& name : a.tool_names) {
    if (name.find('=') != std::string::npos) continue;
    if (!options.reading.unnamed_tool.empty()) {
      return usage_error(
          "--tool", name,
          "N=NAME, as --tool " + options.reading.unnamed_tool + " is already for moves that name no tool");
    }
    options.reading.unnamed_tool = name;
  }
  for (const std::string& text : a.assumed) {
    const std::optional<Vouched> vouched = parse_vouched(text);
    if (!vouched) return usage_error("--assume", text, "one of " + subject_names() + ", or such as tool=T3");
    options.vouched.push_back(*vouched);
  }
  const struct {
    const char* name;
    const std::string& text;
    double& value;
    Minimum least;
  } lengths[] = {{"--tolerance", a.tolerance, options.check.tolerance_mm, Minimum::zero},
                 {"--stock-to-leave", a.stock_to_leave, options.check.stock_to_leave_mm, Minimum::zero},
                 {"--near-miss", a.near_miss, options.check.near_miss_mm, Minimum::zero},
                 {"--resolution", a.resolution, options.check.resolution_mm, Minimum::finest_resolution}};
  for (const auto& length : lengths) {
    const Result<double> value = understand_length(length.name, length.text, length.least);
    if (!value) return value.error();
    length.value = *value;
  }
  if (!a.tool_length.empty()) {
    const Result<LengthRange> range = understand_length_range("--tool-length", a.tool_length);
    if (!range) return range.error();
    options.tool_length_mm = range->middle_mm;
    options.tool_length_slack_mm = range->half_mm;
  }
  if (const Result<FindingsView> view = understand(a.listing); !view) return view.error();
  if (const auto error = find_contradiction(a)) return *error;
  for (const std::string& file : a.export_files) {
    if (scene_format_of(file) == nullptr)
      return usage_error("--export", file, "a file whose name ends in .glb, .vtp or .ply");
  }
  if (a.report_folder == "-") return usage_error("--report", a.report_folder, "a folder");
  if (auto error = add_limits(a, options)) return *error;
  if (!a.clearance.empty()) {
    if (const auto wrong = parse_clearance(a.clearance, options.check)) {
      return make_error("usage", "--clearance: " + *wrong);
    }
  }
  if (!a.place.empty()) {
    const Result<RigidTransform> place = understand_place("--place", a.place);
    if (!place) return place.error();
    options.place = *place;
  }
  if (!a.zero.empty()) {
    if (const Result<RigidTransform> zero = understand_place("--zero", a.zero); !zero) return zero.error();
  }
  const Result<MotionTube> tube = understand_tube(a.tip_tolerance, a.axis_tolerance, !a.heads.empty());
  if (!tube) return tube.error();
  options.check.tube = *tube;
  options.check.law = rapid_called(a.rapid).value_or(RapidMode::straight);
  options.check.threads = static_cast<unsigned>(std::min<std::uint64_t>(a.threads, kMaxThreads));
  options.progress = understand_progress(a.progress);
  for (const auto& [option, typed] : {std::pair("--project", &a.project), std::pair("--reviewer", &a.reviewer)})
    if (!is_utf8(*typed)) return usage_error(option, *typed, "text in UTF-8");
  Result<std::string> date = date_of_report();
  if (!date) return date.error();
  options.date = std::move(*date);
  return options;
}

}  // namespace gouge
