#include "cli/commands/compare_paths.h"

#include <algorithm>
#include <ostream>

#include "cli/commands/machine_words.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/units.h"
#include "lib/path/path_difference.h"

namespace gouge {
namespace {

// An angle between tool axes counts as the distance that it makes at this height above the tip.
constexpr double kHeight_mm = 100;
constexpr int kDistanceDecimals = 6;

std::string place_text(const Toolpath& path, std::size_t move) {
  return path.file + ":" + std::to_string(std::size_t{path.moves[move].line});
}

std::string difference_text(const char* which, const PathDifference& of, const Toolpath& path, const Toolpath& other) {
  const std::string to = " at " + place_text(path, of.tip_move) + ", nearest " + place_text(other, of.tip_other);
  const std::string axis_to = " at " + place_text(path, of.axis_move) + ", nearest " + place_text(other, of.axis_other);
  return machine_row(which, count_text(of.positions, "feed")) +
         machine_row("  largest distance of a tip", display_text(of.tip_mm, kDistanceDecimals) + " mm" + to) +
         machine_row("  largest angle of an axis",
                     display_text(of.axis_rad / kDegree_rad, kDistanceDecimals) + " deg" + axis_to);
}

std::size_t count_unchecked(const Toolpath& path) {
  return static_cast<std::size_t>(
      std::ranges::count_if(path.moves, [](const Move& move) { return !move.not_checked_reason.empty(); }));
}

}  // namespace

int run_compare_paths(const CompareArguments& arguments, double same_within_mm, std::ostream& out, std::ostream& err) {
  const Result<ToolpathReader> reader = ToolpathReader::make(arguments);
  if (!reader) return fail(err, {reader.error()});
  std::vector<Toolpath> paths;
  for (const std::string& file : {arguments.before, arguments.after}) {
    ReadOutcome outcome = reader->read(file);
    if (!outcome.toolpath) return fail(err, outcome.errors);
    print(err, outcome.toolpath->notes);
    paths.push_back(std::move(*outcome.toolpath));
  }
  const auto forward = measure_difference(paths[0], paths[1], kHeight_mm),
             backward = measure_difference(paths[1], paths[0], kHeight_mm);
  if (!forward || !backward)
    return fail(err, {make_error("path-no-motion", "holds no feed that is checked, so nothing can be compared",
                                 paths[forward ? 1 : 0].file)});
  const std::size_t unchecked = count_unchecked(paths[0]) + count_unchecked(paths[1]);
  if (!arguments.is_quiet) {
    out << difference_text("OLD against NEW", *forward, paths[0], paths[1])
        << difference_text("NEW against OLD", *backward, paths[1], paths[0]);
    if (unchecked > 0) out << machine_row("moves not checked, not compared", std::to_string(unchecked));
  }
  const double farthest = std::max(forward->tip_mm, backward->tip_mm),
               widest = std::max(forward->axis_rad, backward->axis_rad) * kHeight_mm;
  if (std::max(farthest, widest) > same_within_mm) return kExitGouges;
  return unchecked > 0 ? kExitNotChecked : kExitClean;
}

}  // namespace gouge
