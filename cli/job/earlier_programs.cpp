#include "cli/job/earlier_programs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cli/job/read_inputs.h"
#include "cli/machine/joint_laws.h"
#include "cli/machine/machine_choice.h"
#include "cli/machine/program_machine.h"
#include "cli/terminal/length_text.h"
#include "cli/tools/resolve_tools.h"
#include "cli/tools/stock_tools.h"
#include "lib/path/place_path.h"

namespace gouge {
namespace {

class ProgramReader {
 public:
  ProgramReader(const JobArguments& arguments, Job& job, Progress& progress, Diagnostics& errors)
      : arguments_(arguments), job_(job), progress_(progress), errors_(errors) {}

  std::optional<EarlierPrograms> run() {
    for (const std::string& typed : arguments_.before) {
      if (!read(split_before(typed))) return std::nullopt;
    }
    return std::move(read_);
  }

 private:
  bool read(const BeforeText& stated) {
    ReadOptions reading = job_.options.reading;
    reading.keeps_origins = false;
    std::optional<Toolpath> path = read_path_file(stated.path, "before", arguments_.input.max_bytes, reading, progress_,
                                                  job_.inputs, job_.searches, errors_);
    if (!path) return false;
    add_notes(path->notes);
    EarlierProgram& program = read_.programs.emplace_back();
    program.path = std::move(*path);
    program.law = job_.options.check.law;
    if (job_.machine) {
      if (auto error = add_joint_laws(*job_.machine, job_.laws, job_.options.tool_length_mm,
                                      job_.options.tool_length_slack_mm, program.path, program.law))
        return fail(*error);
    }
    return place(stated, program) && add_tools(stated, program);
  }

  /// Moves the program. A law of a machine depends on the place of the path on it, which is another one then.
  bool place(const BeforeText& stated, EarlierProgram& program) {
    Toolpath& path = program.path;
    if (stated.place.empty()) {
      if (const auto other = find_other_offset(path, job_.toolpath)) return fail(*other);
      if (job_.machine)
        add_notes(choose_joints_of(*job_.machine, program.law, job_.options.tool_length_mm,
                                   needs_turn(job_.laws, false), path));
      return true;
    }
    const Result<RigidTransform> to_path = understand_place("--before", stated.place);
    if (!to_path) return fail(to_path.error());
    const MotionLaw& law = program.law;
    if (!law.is_great_circle() || law.rapid() == RapidMode::dogleg)
      return fail(make_error("before-place",
                             "the motion between its positions depends on the place of the program on the machine, so "
                             "place= cannot move it; expected a program in the coordinates of the toolpath, or the "
                             "great circle with straight rapids",
                             stated.path));
    place_path(*to_path, path);
    return true;
  }

  bool add_tools(const BeforeText& stated, EarlierProgram& program) {
    std::optional<ToolLibrary> library;
    const std::string& file = stated.tools.empty() ? arguments_.tools_file : stated.tools;
    if (!file.empty()) {
      Result<ToolLibrary> read =
          read_tool_file(file, "before-tools", arguments_.input.max_bytes, job_.inputs, job_.searches);
      if (!read) return fail(read.error());
      if (!stated.tools.empty()) add_notes(read->notes);
      library = std::move(*read);
    }
    const std::vector<std::string> no_names;
    Result<ResolvedTools> resolved =
        resolve_tools(program.path, library ? &*library : nullptr, no_names, arguments_.holder, ToolUse::removes_stock);
    if (!resolved) return fail(resolved.error());
    if (std::ranges::none_of(resolved->assemblies, [](const auto& assembly) { return assembly.has_value(); }))
      return fail(make_error("no-tool",
                             "no tool of this program is defined, so what it removed is not known; expected CUTTER or "
                             "TLDATA in the file, or a library that has the tool: " +
                                 stated.path + ",tools=LIB.json",
                             stated.path));
    add_notes(resolved->notes);
    for (const Assumptions* facts : {&program.path.assumptions, &resolved->assumptions})
      std::ranges::move(facts_of_program(stated.path, *facts), std::back_inserter(job_.basis.inputs));
    Result<std::vector<StockTool>> tools = make_stock_tools(resolved->assemblies, read_.tools);
    if (!tools) return fail(tools.error());
    program.tools = std::move(*tools);
    return true;
  }

  void add_notes(const Diagnostics& notes) { job_.notes.insert(job_.notes.end(), notes.begin(), notes.end()); }

  bool fail(const Diagnostic& error) {
    errors_.push_back(error);
    return false;
  }

  const JobArguments& arguments_;
  Job& job_;
  Progress& progress_;
  Diagnostics& errors_;
  EarlierPrograms read_;
};

}  // namespace

std::optional<EarlierPrograms> read_earlier_programs(const JobArguments& arguments, Job& job, Progress& progress,
                                                     Diagnostics& errors) {
  return ProgramReader(arguments, job, progress, errors).run();
}

}  // namespace gouge
