#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lib/correct/correct_path.h"
#include "lib/correct/link.h"
#include "lib/path/run_kind.h"

namespace gouge {

/// A search for positions of a path of straight moves, and of unchanged arcs and splines.
///
/// A change affects the motions on both sides of its position. A change that would make one of them worse is withdrawn,
/// together with the changes that rely on it. This is repeated until no move is worse.
class PathCorrector {
 public:
  /// Prepares the corrector. All objects must outlive it. `tools` has the meaning of check_path. `origin` has for each
  /// move the move of which it is a piece, as the stock of the checker counts them; null: the move itself.
  PathCorrector(const Toolpath& path, const CheckResult& result, const std::vector<const ToolVariants*>& tools,
                const MotionChecker& checker, const CorrectOptions& correct,
                const std::vector<std::size_t>* origin = nullptr);

  /// Keeps this move unchanged: both its positions and the motion between them.
  void keep(std::size_t move, const std::string& reason);

  [[nodiscard]] Correction propose(const ProgressCall& progress);

 private:
  struct PositionWork {
    bool is_wanted = false, is_worked = false;
    std::optional<CorrectedPose> corrected;
    std::string failure;  ///< reason why it stays although it is too deep
    double depth_before_mm = 0, depth_after_mm = 0;
  };
  struct MoveWork {
    bool is_wanted = false, is_dirty = false, is_kept = false;
    std::vector<LinkPose> inserted;
    bool is_failed = false;         ///< the move still gouges
    bool is_refused = false;        ///< the change would make the move worse
    bool is_out_of_budget = false;  ///< the budget ran out before a path was found
    bool keeps_start = false;  ///< a rapid that begins at its programmed start, to which the feed before it returns
    std::string kept_reason;
  };

  [[nodiscard]] std::size_t origin_of(std::size_t i) const { return origin_ != nullptr ? (*origin_)[i] : i; }
  /// Returns whether the whole tool must be clear of stock.
  [[nodiscard]] bool is_whole(std::size_t i) const { return !removes_stock(path_.moves[i]); }
  [[nodiscard]] MotionChecker checker_of(std::size_t i) const;
  [[nodiscard]] bool is_end_in_stock(std::size_t i) const;
  [[nodiscard]] bool is_plunge(std::size_t i) const;
  [[nodiscard]] std::optional<std::vector<LinkPose>> link_with(std::size_t i, const MotionChecker& checker) const;
  [[nodiscard]] std::optional<std::vector<LinkPose>> link_as(std::size_t i, const MotionChecker& checker,
                                                             Strategy strategy) const;
  void keep_position(std::size_t i, const std::string& reason);
  void mark_moves_at(std::size_t i);
  [[nodiscard]] bool is_chained(std::size_t i) const;
  [[nodiscard]] std::string reason_to_leave(std::size_t i) const;
  [[nodiscard]] Pose end_of(std::size_t i) const;
  [[nodiscard]] Pose start_of(std::size_t i) const;
  [[nodiscard]] bool has_new_end(std::size_t i) const;
  void choose_positions();
  void correct_position(std::size_t i);
  [[nodiscard]] Strategy strategy_of(std::size_t i) const;
  [[nodiscard]] Strategy strategy_at(std::size_t i) const;
  void choose_moves();
  void link_move(std::size_t i);
  [[nodiscard]] PoseLimits limits_for(const ToolVariants& tool) const;
  [[nodiscard]] LinkTask task_of(std::size_t i) const;
  [[nodiscard]] bool take_back();
  [[nodiscard]] double depth_at(const Pose& pose, std::size_t i) const;
  void work(std::string_view stage, const std::vector<std::size_t>& wanted, const ProgressCall& progress,
            const std::function<void(std::size_t)>& what);
  [[nodiscard]] std::string out_of_budget() const;
  // stay_as_programmed.cpp
  void stay_as_programmed(std::size_t i);
  [[nodiscard]] bool is_free(std::size_t i) const;
  [[nodiscard]] bool is_free_with(std::size_t i, const MotionChecker& checker) const;
  [[nodiscard]] bool is_shift_lawful(std::size_t i, const Pose& from, const Pose& to) const;
  [[nodiscard]] bool may_return(std::size_t i) const;
  [[nodiscard]] std::optional<std::vector<LinkPose>> programmed_again(std::size_t i, bool keeps_start) const;
  [[nodiscard]] MoveVerdict verdict_before(std::size_t i) const;
  // gather_correction.cpp
  [[nodiscard]] Correction gather() const;
  [[nodiscard]] bool returns_to_end(std::size_t i) const;
  [[nodiscard]] std::vector<LinkPose> stops_of(std::size_t i) const;
  [[nodiscard]] std::string reason_of(std::size_t i) const;
  void gather_records(std::size_t i, Correction& correction) const;
  void gather_failure(std::size_t i, Correction& correction) const;

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  const MotionChecker& checker_;
  const CheckOptions& options_;
  const CorrectOptions& correct_;
  const std::vector<std::size_t>* origin_;
  std::uint64_t step_budget_;  // maximum number of bounds for one position or one move
  PoseLimits limits_;          // limits without those of a tool, see limits_for
  std::vector<PositionWork> positions_;
  std::vector<MoveWork> moves_;
};

/// Returns whether a move is a single straight motion.
[[nodiscard]] inline bool is_straight(const Move& move) {
  return move.kind == MoveKind::feed || move.kind == MoveKind::rapid;
}

/// Returns the usual reason why a gouge, a buried or an uncertain move of this kind stays, if no other reason is known.
[[nodiscard]] std::string usual_reason(const Move& move, const MoveVerdict& verdict, double max_shift_mm);

}  // namespace gouge
