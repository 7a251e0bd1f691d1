#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "lib/certify/check.h"
#include "lib/check/scene_sides.h"
#include "lib/motion/motion.h"

namespace gouge {

/// Number of bounds one step of a correction may compute. Bounds are counted, not time, so that a step ends alike on
/// every machine and at any number of threads. Of one thread.
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

/// Every check of a single motion, at once. It covers cutter, shank, holder and the bodies that move with the tool,
/// against parts and fixtures. It also decides whether tool or head lies inside a solid. No step of a correction checks
/// less.
///
/// It examines one motion, not the path that leads to it. With an open mesh only that path can show inside from
/// outside. There a motion that meets no surface passes here, and the check of the whole written path decides.
class MotionChecker {
 public:
  /// The objects that `setup` refers to must outlive it.
  explicit MotionChecker(const CheckSetup& setup);
  ~MotionChecker();

  /// Returns the same checker for one step of a correction. Its work is charged to `budget`, which must outlive it.
  /// Once the budget is spent nothing more is certified: check and measure give not_certified, head_excess gives
  /// infinity.
  [[nodiscard]] MotionChecker within(WorkBudget& budget) const;
  [[nodiscard]] bool is_out_of_budget() const { return budget_ != nullptr && budget_->is_spent(); }
  /// For bounds that a step computes elsewhere.
  void charge(std::uint64_t bounds) const;

  /// Requires motion.is_defined(). The flag `is_start_outside` is set where the caller knows that, which saves a test.
  [[nodiscard]] MoveVerdict check(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                  const CheckOptions& options, bool is_start_outside = false) const;
  [[nodiscard]] bool is_clean(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                              const CheckOptions& options, bool is_start_outside = false) const;

  /// Measures the true depth, with tolerance 0. Does not test whether the tool is inside a solid.
  [[nodiscard]] MoveVerdict measure(const Pose& pose, MoveKind kind, const ToolVariants& tool) const;

  /// Returns how much deeper than `allowed_mm` the heads are at a pose, as HeadChecker::excess_at; 0 where there are
  /// none.
  [[nodiscard]] double head_excess(const Pose& pose, double allowed_mm, double accuracy_mm) const;

  /// Returns where the middle of the cutter is.
  [[nodiscard]] Side side_of(const Pose& pose, const ToolVariants& tool) const;

  [[nodiscard]] const PreparedScene& scene() const { return scene_; }
  [[nodiscard]] const CheckOptions& options() const { return options_; }  ///< as the path is checked

 private:
  friend class ShiftCheck;

  /// Does check_move, charged to the budget and within its rest.
  [[nodiscard]] MoveVerdict check_tool(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                       const CheckOptions& options) const;

  const PreparedScene& scene_;
  const CheckOptions& options_;
  std::shared_ptr<const HeadChecker> heads_;  // null: there are no heads
  WorkBudget* budget_ = nullptr;              // null: as much as the options allow
};

}  // namespace gouge
