#include "lib/correct/measure_stock.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/correct/laws.h"
#include "lib/correct/plan_holes.h"
#include "lib/motion/motion_law.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

// Budget of all stretches together, about a tenth of a CPU second: a report on a correction must not cost more than the
// correction.
constexpr std::size_t kMaxWork = 1'400'000, kWorkPerMove = 14;

class Measurer {
 public:
  Measurer(const Toolpath& path, const Correction& correction, const Toolpath& after, const CheckSetup& setup)
      : path_(path), setup_(setup), is_changed_(changed(path, correction)) {
    CutterSweep all;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      if (is_changed_[i]) add(path, i, all);
    }
    all.index();
    for (std::size_t i = 0; i < after.moves.size(); ++i) {
      const Move& move = after.moves[i];
      if (!cuts(after, i) || all.is_empty()) continue;
      // No tip of the move is farther from the middle between its ends than half of its length.
      const CompiledTool& cutter = setup.tools[move.tool]->cutting;
      const double reach =
          0.5 * move_length_mm(after, i) + cutter.r_max_mm + std::max(cutter.z_max_mm, -cutter.z_min_mm) + kMaxStock_mm;
      const Vec3 middle = 0.5 * (after.start_of(i).tip + move.end.tip);
      if (SweepHint none; all.distance(middle, reach, reach + 1, none) <= reach) add(after, i, after_);
    }
    after_.index();
  }

  [[nodiscard]] std::vector<StockStretch> measure(double allowed_mm) const {
    std::vector<StockStretch> left;
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < is_changed_.size(); ++i) {
      if (!is_changed_[i]) continue;
      if (i == 0 || !is_changed_[i - 1]) stretches.push_back({i, i});
      stretches.back().second = i;
    }
    const CheckOptions& options = setup_.options;
    StockLimits limits{options.tolerance_mm, options.tolerance_mm + allowed_mm, kMaxStock_mm};
    limits.are_solids = setup_.scene.is_workpiece_solid();
    limits.max_work = (kMaxWork + kWorkPerMove * path_.moves.size()) / std::max<std::size_t>(1, stretches.size());
    std::vector<std::optional<LeftStock>> most(stretches.size());
    for_each_chunk(stretches.size(), 1, options.threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) most[k] = max_left(stretches[k], limits);
    });
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      if (most[k])
        left.push_back({.first_move = stretches[k].first, .last_move = stretches[k].second, .most = *most[k]});
    }
    return left;
  }

 private:
  using Stretch = std::pair<std::size_t, std::size_t>;  ///< the first and the last of neighbouring changed moves

  [[nodiscard]] std::optional<LeftStock> max_left(const Stretch& stretch, const StockLimits& limits) const {
    CutterSweep before;
    for (std::size_t i = stretch.first; i <= stretch.second; ++i) add(path_, i, before);
    before.index();
    if (before.is_empty()) return std::nullopt;
    return find_left_stock(setup_.scene.workpiece_tree(), before, {&after_, nullptr}, limits);
  }

  static std::vector<bool> changed(const Toolpath& path, const Correction& correction) {
    std::vector<bool> is_changed(path.moves.size() + 1, false);
    for (const PathChange& change : correction.changes) {
      const std::size_t last = change.hole_shift_mm ? end_of_hole(path, change.move) : change.move + 1;
      for (std::size_t i = change.move; i < last; ++i) is_changed[i] = true;
      if (change.new_end || change.hole_shift_mm) is_changed[last] = true;
    }
    is_changed.resize(path.moves.size());
    for (const Uncut& uncut : correction.uncut) {
      for (std::size_t i = uncut.first_move; i <= uncut.last_move; ++i) is_changed[i] = false;
    }
    return is_changed;
  }

  [[nodiscard]] bool cuts(const Toolpath& path, std::size_t i) const {
    const Move& move = path.moves[i];
    return removes_stock(move) && move.tool != kNone && setup_.tools[move.tool] != nullptr &&
           !setup_.tools[move.tool]->cutting.elements.empty();
  }

  void add(const Toolpath& path, std::size_t i, CutterSweep& sweep) const {
    if (!cuts(path, i)) return;
    const Motion motion = setup_.options.law.of(path, i);
    if (motion.is_defined()) sweep.add(motion, setup_.tools[path.moves[i].tool]->cutting, i);
  }

  const Toolpath& path_;
  const CheckSetup& setup_;
  std::vector<bool> is_changed_;
  CutterSweep after_;
};

}  // namespace

std::vector<StockStretch> measure_stock(const Toolpath& path, const Correction& correction, const Toolpath& after,
                                        const CheckSetup& setup, const CorrectOptions& correct) {
  if (correction.changes.empty()) return {};
  const double allowed_mm = std::min(correct.tilt.max_stock_mm, TiltOptions{}.max_stock_mm);
  return Measurer(path, correction, after, setup).measure(allowed_mm);
}

}  // namespace gouge
