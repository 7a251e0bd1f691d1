#include "cli/commands/compare_paths.h"

#include <algorithm>
#include <ostream>

#include "cli/output/output_file.h"
#include "lib/base/exit_code.h"
#include "postproc/compare/path_comparison.h"

namespace gouge {
namespace {

std::size_t count_unchecked(const Toolpath& path) {
  return static_cast<std::size_t>(
      std::ranges::count_if(path.moves, [](const Move& move) { return !move.not_checked_reason.empty(); }));
}

}  // namespace

int run_compare_paths(const CompareArguments& arguments, double same_within_mm, std::ostream& out, std::ostream& err) {
  const OutputTable outputs = asked_for({{"--json", arguments.json_file}});
  const Result<bool> taken = is_stdout_taken(outputs);
  if (const auto status =
          refuse_outputs({{"the old toolpath", arguments.before}, {"the new toolpath", arguments.after}}, outputs, err))
    return *status;
  const Result<ToolpathReader> reader = ToolpathReader::make(arguments);
  if (!reader) return fail(err, {reader.error()});
  std::vector<Toolpath> paths;
  for (const std::string& file : {arguments.before, arguments.after}) {
    ReadOutcome outcome = reader->read(file);
    if (!outcome.toolpath) return fail(err, outcome.errors);
    print(err, outcome.toolpath->notes);
    paths.push_back(std::move(*outcome.toolpath));
  }
  const auto forward = measure_difference(paths[0], paths[1], PathComparison::kHeight_mm),
             backward = measure_difference(paths[1], paths[0], PathComparison::kHeight_mm);
  if (!forward || !backward)
    return fail(err, {make_error("path-no-motion", "holds no feed that is checked, so nothing can be compared",
                                 paths[forward ? 1 : 0].file)});
  PathComparison comparison{
      &paths[0], &paths[1], *forward, *backward, count_unchecked(paths[0]) + count_unchecked(paths[1]), same_within_mm};
  if (comparison.tip_mm() > same_within_mm) comparison.relation = find_relation(paths[0], paths[1], same_within_mm);
  if (!arguments.json_file.empty()) {
    if (const Outcome written = write_output(arguments.json_file, comparison_json(comparison), out); !written)
      return fail(err, {written.error()}, kExitInternal);
  }
  if (!arguments.is_quiet && !*taken) out << comparison_text(comparison);
  return comparison.exit_status();
}

}  // namespace gouge
