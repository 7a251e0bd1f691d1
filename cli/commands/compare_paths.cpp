#include "cli/commands/compare_paths.h"

#include <ostream>

#include "cli/commands/reading_of_new.h"
#include "cli/output/output_file.h"
#include "lib/base/exit_code.h"
#include "postproc/compare/path_comparison.h"

namespace gouge {
namespace {

/// Returns an error for each path that holds no feed to compare, with the reason of the first move that is not checked.
Diagnostics find_nothing_to_compare(const std::vector<Toolpath>& paths) {
  Diagnostics errors;
  for (const Toolpath& path : paths) {
    const MovesLeftOut out = count_left_out(path);
    if (out.feeds > 0) continue;
    const std::size_t first = out.first_unchecked_feed != kNone ? out.first_unchecked_feed : out.first_unchecked;
    Diagnostic error =
        make_error("path-no-motion", "holds no feed that is checked, so nothing can be compared", path.file);
    if (first == kNone) {
      error.message += ": all its moves are rapids";
    } else {
      error.message += "; the first reason: " + std::string(path.moves[first].not_checked_reason);
      error.line = path.moves[first].line;
    }
    errors.push_back(std::move(error));
  }
  return errors;
}

/// Rewrites an error of NEW on its unit. An option that holds for both files may be right for OLD alone.
void explain_unit_of_new(const CompareArguments& arguments, Diagnostic& error) {
  const bool is_of_both = !arguments.reading.units.empty() && arguments.of_new.reading.units.empty();
  if (is_of_both)
    error.message += "; it is given for both files: give --new-path-units with the unit of this one too";
  else
    error = with_options_of_new(error);
}

/// Reads OLD and NEW into `paths`, and prints their notes. Returns the errors.
Diagnostics read_both(const CompareArguments& arguments, std::ostream& err, std::vector<Toolpath>& paths) {
  const ProgramReading facts_of_new = reading_of_new(arguments, arguments.of_new);
  const Result<ToolpathReader> old_reader = ToolpathReader::make(arguments);
  if (!old_reader) return {old_reader.error()};
  const Result<ToolpathReader> new_reader = ToolpathReader::make(facts_of_new);
  if (!new_reader) return {with_options_of_new(new_reader.error())};
  const bool is_control_stated = !facts_of_new.reading.control.empty() || !facts_of_new.stated.machine.empty();
  for (const bool is_new : {false, true}) {
    ReadOutcome outcome = (is_new ? *new_reader : *old_reader).read(is_new ? arguments.after : arguments.before);
    if (!outcome.toolpath) {
      for (Diagnostic& error : outcome.errors)
        if (is_new && error.code == "path-unit")
          explain_unit_of_new(arguments, error);
        else if (is_new && is_control_stated && error.code == "gcode-control")
          error = with_options_of_new(error);
      return outcome.errors;
    }
    print(err, outcome.toolpath->notes);
    paths.push_back(std::move(*outcome.toolpath));
  }
  return {};
}

}  // namespace

int run_compare_paths(const CompareArguments& arguments, double same_within_mm, std::ostream& out, std::ostream& err) {
  const OutputTable outputs = asked_for({{"--json", arguments.json_file}});
  const Result<bool> taken = is_stdout_taken(outputs);
  if (const auto status =
          refuse_outputs({{"the old toolpath", arguments.before}, {"the new toolpath", arguments.after}}, outputs, err))
    return *status;
  std::vector<Toolpath> paths;
  if (const Diagnostics errors = read_both(arguments, err, paths); !errors.empty()) return fail(err, errors);
  if (const Diagnostics errors = find_nothing_to_compare(paths); !errors.empty()) return fail(err, errors);
  const auto measure = [&](const Toolpath& path, const Toolpath& other) {
    return measure_difference(path, other, PathComparison::kHeight_mm, same_within_mm).value_or(PathDifference{});
  };
  PathComparison comparison{&paths[0],
                            &paths[1],
                            measure(paths[0], paths[1]),
                            measure(paths[1], paths[0]),
                            count_left_out(paths[0]),
                            count_left_out(paths[1]),
                            compare_order(paths[0], paths[1], same_within_mm),
                            same_within_mm};
  if (comparison.tip_mm() > same_within_mm) comparison.relation = find_relation(paths[0], paths[1], same_within_mm);
  if (!arguments.json_file.empty()) {
    if (const Outcome written = write_output(arguments.json_file, comparison_json(comparison), out); !written)
      return fail(err, {written.error()}, kExitInternal);
  }
  if (!arguments.is_quiet && !*taken) out << comparison_text(comparison);
  return comparison.exit_status();
}

}  // namespace gouge
