#include "lib/correct/low_rapids.h"

#include <algorithm>

#include "lib/correct/laws.h"
#include "lib/correct/plan_holes.h"
#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

constexpr double kAsMuch_mm = 1e-3;                           // a smaller difference does not count as a change of a
                                                              // rapid's distance
constexpr double kCertifiedShares[] = {0.99, 0.9, 0.5, 0.1};  // shares of a found distance for which a certificate is
                                                              // tried

class RapidMeasurer {
 public:
  RapidMeasurer(const CheckSetup& setup, double clearance_mm)
      : setup_(setup), checker_(setup), options_(setup.options), clearance_mm_(clearance_mm) {
    options_.tolerance_mm = 0;
  }

  /// Returns the distance that a rapid keeps from everything, up to the clearance; if negative, its maximum depth.
  [[nodiscard]] double keeps_mm(const Toolpath& path, std::size_t move) const {
    const Motion motion = options_.law.of(path, move);
    if (!motion.is_defined() || path.moves[move].tool == kNone) return clearance_mm_;
    const ToolVariants* const tool = setup_.tools[path.moves[move].tool];
    if (tool == nullptr || keeps(motion, *tool, clearance_mm_)) return clearance_mm_;
    CheckOptions near = options_;
    near.near_miss_mm = clearance_mm_;
    const MoveVerdict verdict = checker_.check(motion, MoveKind::rapid, *tool, near, true);
    const double found = verdict.state == MoveState::near_miss ? verdict.clearance_mm.value_or(0) : 0;
    for (const double share : kCertifiedShares) {
      if (found > 0 && keeps(motion, *tool, share * found)) return share * found;
    }
    return -verdict.depth_upper_mm;
  }

 private:
  [[nodiscard]] bool keeps(const Motion& motion, const ToolVariants& tool, double distance_mm) const {
    CheckOptions near = options_;
    near.near_miss_mm = distance_mm;
    return checker_.is_clean(motion, MoveKind::rapid, tool, near, true);
  }

  const CheckSetup& setup_;
  MotionChecker checker_;
  CheckOptions options_;
  double clearance_mm_;
};

/// Returns the moves that a change rewrote, and those that begin at a changed end.
std::vector<bool> rewritten(const Toolpath& path, const Correction& correction) {
  std::vector<bool> is_rewritten(path.moves.size() + 1, false);
  for (const PathChange& change : correction.changes) {
    const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
    for (std::size_t i = change.move; i < last; ++i) is_rewritten[i] = true;
    if (change.new_end || change.hole_shift_mm) is_rewritten[last] = true;
  }
  return is_rewritten;
}

}  // namespace

std::vector<LowRapid> find_low_rapids(const Toolpath& path, const Correction& correction, const Toolpath& after,
                                      const CheckSetup& setup, const CorrectOptions& correct) {
  std::vector<LowRapid> low;
  if (correction.changes.empty() || !(correct.rapid_clearance_mm > 0)) return low;
  const RapidMeasurer measurer(setup, correct.rapid_clearance_mm);
  const std::vector<bool> is_rewritten = rewritten(path, correction);
  const std::vector<MovesAfter> spans = moves_after(path.moves.size(), correction.changes);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_rewritten[i]) continue;
    double least = correct.rapid_clearance_mm;
    for (std::size_t k = spans[i].first; k < spans[i].last; ++k) {
      if (after.moves[k].kind == MoveKind::rapid && after.moves[k].not_checked_reason.empty())
        least = std::min(least, measurer.keeps_mm(after, k));
    }
    if (!(least < correct.rapid_clearance_mm)) continue;
    const bool is_programmed = path.moves[i].kind == MoveKind::rapid && spans[i].last - spans[i].first == 1;
    if (is_programmed && least >= measurer.keeps_mm(path, i) - kAsMuch_mm) continue;
    low.push_back({i, path.moves[i].line, least});
  }
  return low;
}

}  // namespace gouge
