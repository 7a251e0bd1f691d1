#include "lib/certify/motion_checker.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "lib/base/best_first_search.h"
#include "lib/base/tolerance.h"
#include "lib/check/check_move.h"
#include "lib/head/check_heads.h"

namespace gouge {
namespace {

constexpr std::uint64_t kBoundsPerPiece = 8;  // a piece of a question about stock takes as long as so many bounds

/// Makes a clean verdict uncertain: a motion whose heads and sides were not checked is not clean.
MoveVerdict uncertain_if_clean(MoveVerdict verdict, std::uint64_t budget) {
  if (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss) return verdict;
  verdict.state = MoveState::not_certified;
  verdict.reason = {Reason::Kind::out_of_budget, Body::cutter, static_cast<double>(budget)};
  return verdict;
}

}  // namespace

MotionChecker::MotionChecker(const CheckSetup& setup) : scene_(setup.scene), options_(setup.options) {
  if (!setup.heads.empty() && scene_.is_within_reach) heads_ = std::make_shared<const HeadChecker>(setup.heads, scene_);
}

MotionChecker::~MotionChecker() = default;

MotionChecker MotionChecker::within(WorkBudget& budget) const {
  MotionChecker limited = *this;
  limited.budget_ = &budget;
  return limited;
}

MotionChecker MotionChecker::with_stock(std::shared_ptr<const StockAtMoves> stock) const {
  MotionChecker checker = *this;
  checker.stock_ = std::move(stock);
  return checker;
}

MotionChecker MotionChecker::at_place(std::size_t move, bool is_whole, bool is_after) const {
  MotionChecker checker = *this;
  if (!stock_) return checker;
  checker.place_ = stock_->place_of(move, is_after);
  checker.place_.is_whole = is_whole;
  return checker;
}

MotionChecker MotionChecker::for_move(std::size_t move, bool is_whole) const { return at_place(move, is_whole, false); }
MotionChecker MotionChecker::after_move(std::size_t move, bool is_whole) const {
  return at_place(move, is_whole, true);
}

MotionChecker MotionChecker::keeping_room() const {
  MotionChecker checker = *this;
  checker.place_.keeps_room = true;
  return checker;
}

MotionChecker MotionChecker::searching() const {
  MotionChecker checker = *this;
  checker.place_.is_brief = true;
  return checker;
}

MotionChecker MotionChecker::without_stock() const { return with_stock(nullptr); }

void MotionChecker::charge(std::uint64_t bounds) const {
  if (budget_ != nullptr) budget_->charge(bounds);
}

MoveVerdict MotionChecker::check_tool(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                      const CheckOptions& options) const {
  if (budget_ == nullptr) return check_move(motion, kind, tool, scene_, options);
  MoveVerdict verdict;
  if (budget_->is_spent()) {
    verdict.state = MoveState::not_certified;
    verdict.reason = {Reason::Kind::out_of_budget, Body::cutter, static_cast<double>(budget_->most())};
    return verdict;
  }
  CheckOptions limited = options;
  limited.budget_per_move = std::min(options.budget_per_move, budget_->left());
  std::uint64_t bounds = 0;
  verdict = check_move(motion, kind, tool, scene_, limited, &bounds);
  budget_->charge(bounds + 1);
  return verdict;
}

MoveVerdict MotionChecker::check(const Motion& motion, MoveKind kind, const ToolVariants& tool,
                                 const CheckOptions& options, bool is_start_outside) const {
  MoveVerdict verdict = check_tool(motion, kind, tool, options);
  if (verdict.state == MoveState::not_checked) return verdict;
  if (is_out_of_budget()) return uncertain_if_clean(std::move(verdict), budget_->most());
  if (heads_) charge(heads_->check(motion, options, verdict));
  if (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss) return verdict;
  if (verdict.depth_upper_mm >= tool.bare.core_depth_mm) {
    verdict.state = MoveState::not_certified;
    verdict.reason = {Reason::Kind::body_too_thin, Body::cutter};
  } else if (!is_start_outside && side_of(motion.start(), tool) == Side::inside) {
    verdict.state = MoveState::buried;
    verdict.reason = {Reason::Kind::buried, Body::cutter};
  }
  return has_stock() ? with_stock_of(motion, kind, options, std::move(verdict)) : verdict;
}

MoveVerdict MotionChecker::with_stock_of(const Motion& motion, MoveKind kind, const CheckOptions& options,
                                         MoveVerdict verdict) const {
  if (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss) return verdict;
  if (is_out_of_budget()) return uncertain_if_clean(std::move(verdict), budget_->most());
  StockPlace place = place_;
  place.is_whole = place.is_whole || kind == MoveKind::rapid;
  std::uint64_t examined = 0;
  verdict = stock_->check(motion, place, verdict, options.is_depth_alone, examined);
  charge(kBoundsPerPiece * examined);
  return verdict;
}

bool MotionChecker::is_clean(const Motion& motion, MoveKind kind, const ToolVariants& tool, const CheckOptions& options,
                             bool is_start_outside) const {
  if (!motion.is_defined()) return false;
  CheckOptions quick = options;
  quick.gouge_gap_mm = kAnyGap_mm;
  return check(motion, kind, tool, quick, is_start_outside).state == MoveState::clean;
}

MoveVerdict MotionChecker::measure(const Pose& pose, MoveKind kind, const ToolVariants& tool) const {
  CheckOptions exact = options_;
  exact.tolerance_mm = 0;
  exact.near_miss_mm = 0;
  exact.is_depth_alone = true;
  return check(options().law.at(pose), kind, tool, exact, true);
}

double MotionChecker::head_excess(const Pose& pose, double allowed_mm, double accuracy_mm) const {
  if (!heads_) return 0;
  if (is_out_of_budget()) return std::numeric_limits<double>::infinity();
  std::uint64_t bounds = 0;
  const double excess = heads_->excess_at(pose, options().law, allowed_mm, accuracy_mm, bounds);
  charge(bounds);
  return excess;
}

double MotionChecker::stock_excess(const Pose& pose) const {
  if (!has_stock()) return 0;
  if (is_out_of_budget()) return std::numeric_limits<double>::infinity();
  std::uint64_t examined = 0;
  const double excess = stock_->excess_mm(pose, place_, examined);
  charge(kBoundsPerPiece * examined);
  return excess;
}

double MotionChecker::lift_over_stock_mm(const Pose& from, const Pose& to) const {
  const double lift = std::max(stock_->lift_over_mm(from, place_), stock_->lift_over_mm(to, place_));
  const bool is_turning = (from.axis - to.axis).norm() > Tolerance::kExactDirection;
  // Between two axes the tool may cross the edges of the stock.
  return is_turning ? lift + 2 * stock_->size_mm() : lift;
}

Side MotionChecker::side_of(const Pose& pose, const ToolVariants& tool) const {
  const Vec3 core = pose.tip + tool.bare.core.y() * pose.axis;
  return scene_.sides().side_of({{core}, {pose.axis}}).side;
}

}  // namespace gouge
