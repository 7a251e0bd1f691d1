#include "lib/certify/stock_at_moves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/certify/check.h"
#include "lib/stock/stock_search.h"

namespace gouge {

namespace {

// Number of pieces of a brief examination. Most motions that are clear need fewer.
constexpr std::uint64_t kBriefBudget = 500;
constexpr double kAimShare = 0.8;         // share of the tolerance, as in the other searches of a correction
constexpr std::uint64_t kBudget = 4'000;  // pieces for a motion: a search tries many
constexpr double kBlindStep_mm = 0.5;     // step where it is not known how deep the stock is
constexpr double kMargin_mm = 1e-3;       // beyond the highest stock

}  // namespace

StockAtMoves::StockAtMoves(std::shared_ptr<const Toolpath> path, std::vector<std::size_t> first,
                           std::vector<bool> meets_stock, const CheckSetup& setup)
    : stock_(*setup.stock),
      law_(setup.options.law),
      options_(setup.stock->options),
      path_(std::move(path)),
      first_(std::move(first)),
      meets_stock_(std::move(meets_stock)),
      history_(*path_, setup.options.law, *setup.stock) {
  options_.tolerance_mm *= kAimShare;
  options_.budget_per_move = std::min(options_.budget_per_move, kBudget);
  if (!(stock_.roomy_mm > 0)) return;
  for (const StockHead& head : stock_.heads) roomy_heads_.push_back(head.grown(stock_.roomy_mm));
}

StockPlace StockAtMoves::place_of(std::size_t i, bool is_after) const {
  const std::size_t tool = first_[i] < path_->moves.size() ? std::size_t{path_->moves[first_[i]].tool} : kNone;
  return {tool, first_[i + (is_after ? 1 : 0)]};
}

const CompiledTool* StockAtMoves::body_of(const StockPlace& place) const {
  if (place.tool >= stock_.tools.size() || stock_.tools[place.tool].tool == nullptr) return nullptr;
  const ToolVariants& tool = *stock_.tools[place.tool].tool;
  if (!place.is_whole && stock_.tools[place.tool].cuts)
    return tool.non_cutting.elements.empty() ? nullptr : &tool.non_cutting;
  const bool has_roomy = place.tool < stock_.roomy.size() && stock_.roomy[place.tool] != nullptr;
  return place.keeps_room && has_roomy ? stock_.roomy[place.tool] : &tool.bare;
}

std::vector<StockQuestion> StockAtMoves::questions(const StockPlace& place) const {
  std::vector<StockQuestion> all;
  if (place.tool >= stock_.tools.size() || stock_.tools[place.tool].tool == nullptr) return all;
  const std::uint64_t budget = place.is_brief ? kBriefBudget : options_.budget_per_move;
  const auto add = [&](const CompiledTool& body, const StockHead* head) {
    StockQuestion about{history_.of_path(), stock_.solid, options_, body, place.before, budget, false};
    about.is_clear_alone = place.is_brief;
    about.head = head;
    all.push_back(about);
  };
  if (const CompiledTool* const body = body_of(place)) add(*body, nullptr);
  for (const StockHead& head : place.keeps_room && !roomy_heads_.empty() ? roomy_heads_ : stock_.heads)
    add(head.around(), &head);
  return all;
}

MoveVerdict StockAtMoves::check(const Motion& motion, const StockPlace& place, const MoveVerdict& free,
                                bool is_depth_wanted, std::uint64_t& examined) const {
  std::optional<MoveVerdict> worst;
  for (const StockQuestion& about : questions(place)) {
    std::optional<MoveVerdict> found = find_stock_in(about, place.tool, motion, is_depth_wanted, examined);
    if (!found) continue;
    if (!worst || found->depth_mm > worst->depth_mm) worst = std::move(found);
    if (!is_depth_wanted) break;
  }
  return worst.value_or(free);
}

std::optional<MoveVerdict> StockAtMoves::find_stock_in(const StockQuestion& about, std::size_t tool,
                                                       const Motion& motion, bool is_depth_wanted,
                                                       std::uint64_t& examined) const {
  const double tolerance = options_.tolerance_mm;
  const bool is_head = about.head != nullptr;
  MoveVerdict verdict;
  verdict.state = MoveState::not_certified;
  verdict.reason.kind = Reason::Kind::stock_touched;
  if (is_head) verdict.reason.body = Body::head;
  if (is_head && !(has_known_turn(motion) && about.history.departure_from(motion).is_none())) return verdict;
  const StockAnswer answer = find_stock(about, motion, deep_pieces(about.body, tolerance), 0, 1, tolerance);
  examined += answer.examined;
  if (answer.is_clear) return std::nullopt;
  if (!answer.witness) return verdict;
  StockDepth depth{*answer.witness, about.body.r_max_mm};
  if (is_depth_wanted) depth = find_depth(about, motion, depth.witness, depth.upper_mm);
  verdict = {};
  verdict.state = MoveState::gouge;
  verdict.depth_mm = depth.witness.depth_mm;
  verdict.depth_upper_mm = depth.upper_mm;
  if (is_head) {
    verdict.witness = stock_witness(depth.witness, *about.head, motion);
    return verdict;
  }
  const Body of = body_at(stock_.tools[tool].tool->bare, about.body, motion.at(depth.witness.t), depth.witness.point);
  verdict.witness = stock_witness(depth.witness, of, about.body, motion);
  return verdict;
}

double StockAtMoves::excess_mm(const Pose& pose, const StockPlace& place, std::uint64_t& examined) const {
  const Motion rest = law_.at(pose);
  double excess = 0;
  for (const StockQuestion& about : questions(place)) excess = std::max(excess, excess_mm(about, rest, examined));
  return excess;
}

double StockAtMoves::excess_mm(const StockQuestion& about, const Motion& rest, std::uint64_t& examined) const {
  if (about.head != nullptr && !(has_known_turn(rest) && about.history.departure_from(rest).is_none()))
    return kBlindStep_mm;
  double excess = 0;
  for (double depth = options_.tolerance_mm;;) {
    const StockAnswer answer = find_stock(about, rest, deep_pieces(about.body, depth), 0, 1, depth);
    examined += answer.examined;
    if (answer.is_clear) return excess;
    if (!answer.witness) return std::max(excess, kBlindStep_mm);
    excess = std::max(answer.witness->depth_mm - options_.tolerance_mm, options_.resolution_mm);
    depth = 2 * answer.witness->depth_mm;
  }
}

double StockAtMoves::lift_over_mm(const Pose& pose, const StockPlace& place) const {
  if (place.tool >= stock_.tools.size() || stock_.tools[place.tool].tool == nullptr) return 0;
  const double top = highest_along(pose.axis, Box3(stock_.solid.low(), stock_.solid.high()));
  double lowest = stock_.tools[place.tool].tool->bare.z_min_mm;
  for (const StockHead& head : stock_.heads) lowest = std::min(lowest, head.around().z_min_mm);
  const double bottom = pose.tip.dot(pose.axis) + lowest;
  return std::max(0.0, top + stock_.roomy_mm + kMargin_mm - bottom);
}

double StockAtMoves::size_mm() const { return (stock_.solid.high() - stock_.solid.low()).norm(); }

}  // namespace gouge
