#include "lib/correct/straighten.h"

#include <algorithm>

#include "lib/path/chords.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

/// The curves that a correction may have to change.
class CurveChoice {
 public:
  CurveChoice(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
              const MotionChecker& checker, const std::vector<bool>& others)
      : path_(path),
        result_(result),
        tools_(tools),
        checker_(checker),
        options_(checker.options()),
        others_(others),
        is_chosen_(path.moves.size(), false) {
    options_.tolerance_mm *= kSurelyStays;
    options_.near_miss_mm = 0;
  }

  // Returns the curves that must become straight. A correction of a gouging move may move its end and the end of the
  // move before it, if these are themselves too deep. Both are also ends of neighbouring curves.
  std::vector<bool> run() {
    const std::size_t count = path_.moves.size();
    for (std::size_t i = 0; i < others_.size(); ++i) {
      if (others_[i]) choose(i);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (result_.verdicts[i].state != MoveState::gouge) continue;
      choose(i);
      if (is_curve_at(i + 1) && path_.moves[i + 1].has_start && may_move(i)) choose(i + 1);
      if (i > 0 && is_curve_at(i - 1) && path_.moves[i].has_start && may_move(i - 1)) choose(i - 1);
    }
    // Positions of one statement share the arc that describes them.
    for (std::size_t i = 1; i < count; ++i) {
      if (is_chosen_[i - 1] && path_.moves[i].statement == path_.moves[i - 1].statement) choose(i);
    }
    for (std::size_t i = count; i-- > 1;) {
      if (is_chosen_[i] && path_.moves[i].statement == path_.moves[i - 1].statement) choose(i - 1);
    }
    return is_chosen_;
  }

 private:
  // Share of the tolerance: a position that is no deeper certainly stays, because a correction leaves even deeper ones
  // alone.
  static constexpr double kSurelyStays = 0.7;

  [[nodiscard]] bool is_curve_at(std::size_t i) const { return i < path_.moves.size() && is_curve(path_.moves[i]); }
  void choose(std::size_t i) {
    if (is_curve_at(i)) is_chosen_[i] = true;
  }
  [[nodiscard]] bool may_move(std::size_t i) const {
    const Move& move = path_.moves[i];
    return checker_.for_move(i, !removes_stock(move))
               .check(options_.law.at(move.end), run_kind(move), *tools_[move.tool], options_, true)
               .state != MoveState::clean;
  }

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  const MotionChecker& checker_;
  CheckOptions options_;
  const std::vector<bool>& others_;
  std::vector<bool> is_chosen_;
};

}  // namespace

std::optional<ReworkedPath> straighten(const Toolpath& path, const CheckResult& result,
                                       const std::vector<const ToolVariants*>& tools, const MotionChecker& checker,
                                       const std::vector<bool>& others) {
  const CheckOptions& options = checker.options();
  const std::vector<bool> is_chosen = CurveChoice(path, result, tools, checker, others).run();
  if (std::none_of(is_chosen.begin(), is_chosen.end(), [](bool chosen) { return chosen; })) return std::nullopt;
  const double error = std::max(kChordShare * options.tolerance_mm, kMinChordError_mm);
  ReworkedPath straight;
  straight.path = without_moves(path);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_chosen[i]) {
      straight.add(path.moves[i], i, false, result.verdicts[i]);
      continue;
    }
    Pose from = path.start_of(i);
    for (const Pose& to : chords_of(path, i, error)) {
      Move chord = path.moves[i];
      chord.kind = MoveKind::feed;
      chord.curve_kind = CurveKind::none;
      chord.end = to;
      const Motion motion = options.law.straight(from, to);
      from = to;
      const MotionChecker in_place = checker.meets_stock(i) ? checker.for_move(i, !removes_stock(chord)) : checker;
      straight.add(chord, i, false, in_place.check(motion, run_kind(chord), *tools[chord.tool], options, true));
    }
  }
  return straight;
}

}  // namespace gouge
