#include "cli/path_misfit.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "postproc/cldata/interpreting/motion_records.h"

namespace gouge {
namespace {

std::string percent(double share) { return std::to_string(static_cast<int>(std::floor(100 * share + 1e-9))) + " %"; }

std::string percent(std::size_t some, std::size_t all) {
  return percent(all == 0 ? 0.0 : static_cast<double>(some) / static_cast<double>(all));
}

std::string misfit_finding(const PathFit& fit) {
  const std::string positions = std::to_string(fit.positions) + " cutting positions";
  if (fit.kind == PathFit::Kind::too_deep) {
    return percent(fit.deep, fit.positions) + " of the " + positions +
           " are as deep in it as the cutter's radius, or the tool is inside it";
  }
  if (fit.kind == PathFit::Kind::apart) return "the tool hardly touches it where it cuts";
  return percent(fit.gouging, fit.positions) + " of the " + positions + " gouge it by far more than they touch it";
}

// The file's I, J, K are not the part's.
bool has_turned_frame(const Toolpath& path) {
  const MotionRecords records = read_motion_records(path);
  return std::any_of(records.frames.begin(), records.frames.end(),
                     [](const MotionFrame& frame) { return !frame.to_part.rotation.isIdentity(1e-6); });
}

}  // namespace

std::optional<Diagnostic> describe_misfit(const Toolpath& path, const PathFit& fit) {
  if (fit.kind == PathFit::Kind::fits) return std::nullopt;
  std::string message =
      "the path does not fit the part: " + misfit_finding(fit) + "; check units, placement, axis sign";
  if (fit.explanation) {
    message += ": with " + fit.explanation->text + " " + percent(fit.explanation->share) +
               (fit.explanation->is_of_all ? " of the positions touch the part"
                                           : " of the positions it concerns touch the part");
    if (has_turned_frame(path)) message += " (in part coordinates, which the file's frame turns)";
  }
  return make_warning("path-misfit", message, path.file);
}

bool is_beyond_correction(const PathFit& fit) {
  return fit.kind == PathFit::Kind::too_deep || fit.kind == PathFit::Kind::mistaken;
}

}  // namespace gouge
