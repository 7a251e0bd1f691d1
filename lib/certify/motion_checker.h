#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "lib/certify/check.h"
#include "lib/certify/stock_at_moves.h"
#include "lib/check/scene_sides.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Number of bounds that one step of a correction may compute. Bounds are counted, not time, so that a step ends in the
/// same way on every machine and at any number of threads. A budget belongs to one thread.
class WorkBudget {
 public:
  explicit WorkBudget(std::uint64_t most) : max_(most) {}

  [[nodiscard]] std::uint64_t most() const { return max_; }
  [[nodiscard]] std::uint64_t left() const { return max_ - std::min(max_, spent_); }
  [[nodiscard]] bool is_spent() const { return spent_ >= max_; }
  void charge(std::uint64_t bounds) { spent_ += bounds; }

 private:
  std::uint64_t max_, spent_ = 0;
};

class HeadChecker;

/// Every check of a single motion, combined. It covers cutter, shank, holder and the bodies that move with the tool,
/// against parts and fixtures. It also decides whether tool or head lies inside a solid. No step of a correction checks
/// less.
///
/// It examines one motion, not the path that leads to it. With an open mesh, only that path can distinguish inside from
/// outside. There a motion that meets no surface passes here, and the check of the whole written path decides.
class MotionChecker {
 public:
  /// Prepares the checks. The objects that `setup` refers to must outlive the checker.
  explicit MotionChecker(const CheckSetup& setup);
  ~MotionChecker();

  /// Returns the same checker for one step of a correction. Its work is charged to `budget`, which must outlive it.
  /// Once the budget is spent, nothing more is certified: check and measure return not_certified, head_excess returns
  /// infinity.
  [[nodiscard]] MotionChecker within(WorkBudget& budget) const;
  [[nodiscard]] bool is_out_of_budget() const { return budget_ != nullptr && budget_->is_spent(); }
  /// Returns the same checker with remaining stock, which is examined only in the places of for_move.
  [[nodiscard]] MotionChecker with_stock(std::shared_ptr<const StockAtMoves> stock) const;
  /// Returns the same checker for motions in place of a move, with the material that is left before it. `is_whole`: the
  /// whole tool must not meet it, not only shank and holder. That holds for every rapid too.
  [[nodiscard]] MotionChecker for_move(std::size_t move, bool is_whole) const;
  /// Returns the same checker for a tool at rest after a move.
  [[nodiscard]] MotionChecker after_move(std::size_t move, bool is_whole) const;
  /// Returns whether a move is known to meet stock.
  [[nodiscard]] bool meets_stock(std::size_t move) const { return stock_ != nullptr && stock_->meets_stock(move); }
  /// Returns the same checker for rapids that keep a distance from stock.
  [[nodiscard]] MotionChecker keeping_room() const;
  /// Returns the same checker for a search over many motions: it examines few pieces for each, and certifies fewer.
  [[nodiscard]] MotionChecker searching() const;
  /// Returns the same checker without stock.
  [[nodiscard]] MotionChecker without_stock() const;
  [[nodiscard]] bool has_stock() const { return stock_ != nullptr && place_.tool != kNone; }
  /// Charges bounds that a step computes elsewhere to the budget.
  void charge(std::uint64_t bounds) const;

  /// Checks one motion. Requires motion.is_defined(). The caller sets `is_start_outside` if it knows that the start is
  /// outside, which saves a test.
  [[nodiscard]] MoveVerdict check(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                  const CheckOptions& options, bool is_start_outside = false) const;
  [[nodiscard]] bool is_clean(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                              const CheckOptions& options, bool is_start_outside = false) const;

  /// Measures the true depth, with tolerance 0. It does not test whether the tool is inside a solid.
  [[nodiscard]] MoveVerdict measure(const Pose& pose, MoveKind kind, const ToolVariants& tool) const;

  /// Returns how much deeper than `allowed_mm` the heads are at a pose, computed by HeadChecker::excess_at; 0 without
  /// heads.
  [[nodiscard]] double head_excess(const Pose& pose, double allowed_mm, double accuracy_mm) const;

  /// Returns StockAtMoves::excess_mm at the place of for_move; 0 without stock.
  [[nodiscard]] double stock_excess(const Pose& pose) const;
  /// Returns the lift along the tool axes that takes the tool above all stock at both poses and between them. Requires
  /// has_stock().
  [[nodiscard]] double lift_over_stock_mm(const Pose& from, const Pose& to) const;

  /// Returns the side on which the middle of the cutter lies.
  [[nodiscard]] Side side_of(const Pose& pose, const ToolVariants& tool) const;

  [[nodiscard]] const PreparedScene& scene() const { return scene_; }
  [[nodiscard]] const CheckOptions& options() const { return options_; }  ///< the options of the path's check

 private:
  friend class ShiftCheck;

  /// Runs check_move within the rest of the budget, and charges it to the budget.
  [[nodiscard]] MoveVerdict check_tool(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                       const CheckOptions& options) const;
  /// Completes a verdict that part and fixtures leave free.
  [[nodiscard]] MoveVerdict with_stock_of(const Motion& motion, MoveKind kind, const CheckOptions& options,
                                          MoveVerdict verdict) const;
  [[nodiscard]] MotionChecker at_place(std::size_t move, bool is_whole, bool is_after) const;

  const PreparedScene& scene_;
  const CheckOptions& options_;
  std::shared_ptr<const HeadChecker> heads_;   // null: there are no heads
  WorkBudget* budget_ = nullptr;               // null: the work is limited only by the options
  std::shared_ptr<const StockAtMoves> stock_;  // null: there is no stock
  StockPlace place_;                           // no tool: stock is not examined
};

}  // namespace gouge
