#include "postproc/compare/judge_absence.h"

#include <algorithm>

#include "lib/path/toolpath.h"
#include "postproc/compare/contact_depth.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

std::size_t count_of(const StoredResult& result, std::string_view role) {
  return static_cast<std::size_t>(
      std::ranges::count_if(result.record.inputs, [&](const InputFile& input) { return input.role == role; }));
}

bool has_option(const StoredResult& result, std::string_view name) {
  return std::ranges::any_of(result.record.options.more, [&](const auto& option) { return option.first == name; });
}

class AbsenceJudge {
 public:
  AbsenceJudge(const StoredResult& before, const StoredResult& after, const MotionAlignment& motions,
               const EventRecord& finding)
      : before_(before), after_(after), motions_(motions), finding_(finding) {}

  [[nodiscard]] std::optional<std::string> run() const {
    if (auto why = without_body()) return why;
    if (auto why = without_counterpart()) return why;
    if (auto why = less_strictly()) return why;
    for (const MoveRecord* move : before_.moves_of(finding_)) {
      if (auto why = without_motion(*move)) return why;
    }
    return std::nullopt;
  }

 private:
  using Why = std::optional<std::string>;

  [[nodiscard]] Why without_body() const {
    if (finding_.body == Body::head) {
      if (count_of(after_, "head") < count_of(before_, "head")) return "fewer heads are given";
      return std::nullopt;
    }
    bool has_tool = false;
    for (const ToolRecord& tool : after_.record.tools) {
      if (tool.key != finding_.tool) continue;
      has_tool = true;
      if (tool.identity && std::ranges::find(tool.bodies, finding_.body) == tool.bodies.end())
        return stored_tool_label(finding_.tool) + " has no " + body_name(finding_.body);
    }
    // If another tool runs the same motion, that motion is checked with the other tool.
    if (!has_tool && !has_every_motion()) return "the path has no " + stored_tool_label(finding_.tool);
    return std::nullopt;
  }

  [[nodiscard]] Why without_counterpart() const {
    if (finding_.against == Against::stock) return without_stock();
    const std::string against = against_name(finding_.against);
    if (count_of(after_, against) >= count_of(before_, against)) return std::nullopt;
    return "fewer " + against + "s are given";
  }

  [[nodiscard]] std::string from_to(double old_mm, double now_mm) const {
    const LengthUnit unit = after_.record.unit;
    return length_text(now_mm, unit) + ", " + length_text(old_mm, unit) + " before";
  }

  [[nodiscard]] Why without_stock() const {
    if (!before_.record.stock) return std::nullopt;
    if (!after_.record.stock) return "no stock is given";
    const StockRecord &old = *before_.record.stock, &now = *after_.record.stock;
    if (now.tolerance_mm > old.tolerance_mm)
      return "the tolerance of the stock is " + from_to(old.tolerance_mm, now.tolerance_mm);
    if (now.resolution_mm > old.resolution_mm)
      return "the resolution of the stock is " + from_to(old.resolution_mm, now.resolution_mm);
    return std::nullopt;
  }

  [[nodiscard]] Why less_strictly() const {
    const StoredOptions &old = before_.options, &now = after_.options;
    if (now.tolerance_mm > old.tolerance_mm) return "the tolerance is " + from_to(old.tolerance_mm, now.tolerance_mm);
    if (has_option(before_, "extend-up") && !has_option(after_, "extend-up")) return "--extend-up is not given";
    if (now.limits != old.limits) return "the limits of single files are others";
    if (now.law != old.law) return "the machine, or its law of motion, is another one";
    if (now.resolution_mm > old.resolution_mm)
      return "the resolution is " + from_to(old.resolution_mm, now.resolution_mm);
    if (finding_.body == Body::cutter && now.stock_to_leave_mm < old.stock_to_leave_mm)
      return "the stock to leave is " + from_to(old.stock_to_leave_mm, now.stock_to_leave_mm);
    if (finding_.body == Body::shank && now.shank_clearance_mm < old.shank_clearance_mm)
      return "the shank's clearance is " + from_to(old.shank_clearance_mm, now.shank_clearance_mm);
    if ((finding_.body == Body::holder || finding_.body == Body::head) &&
        now.holder_clearance_mm < old.holder_clearance_mm)
      return "the holder's clearance is " + from_to(old.holder_clearance_mm, now.holder_clearance_mm);
    return std::nullopt;
  }

  [[nodiscard]] bool has_every_motion() const {
    return std::ranges::all_of(before_.moves_of(finding_),
                               [&](const MoveRecord* move) { return motions_.before_to_after[move->move] != kNone; });
  }

  [[nodiscard]] Why without_motion(const MoveRecord& move) const {
    const std::size_t now = motions_.before_to_after[move.move];
    if (now != kNone) return if_open(now);
    const std::vector<std::size_t>& kept = motions_.before_to_after;
    // the nearest kept motions around it; `to` is kept.size() if there is none
    std::size_t from = move.move, to = move.move;
    while (from > 0 && kept[from] == kNone) --from;
    while (to < kept.size() && kept[to] == kNone) ++to;
    const bool is_begun = kept[from] != kNone, is_ended = to < kept.size();
    if (!is_begun && !is_ended) return "the new path has no motion of the old one, so nothing says that it runs there";
    const std::size_t first = is_begun ? kept[from] + 1 : 0, end = is_ended ? kept[to] : after_.record.listed_motions();
    for (std::size_t k = first; k < end; ++k) {
      if (Why why = if_open(k)) return why;
    }
    // Moves that replace the motion must have its operation and tool, and at least half as many moves.
    const RunRecord& run = before_.run_of(move.move);
    const std::size_t old_moves = before_.moves_like(run, is_begun ? from + 1 : 0, to);
    if (2 * after_.moves_like(run, first, end) < old_moves) return "its motion is not in the new path";
    return std::nullopt;
  }

  [[nodiscard]] Why if_open(std::size_t move) const {
    const MoveRecord* found = after_.find_move(move);
    if (found == nullptr || found->state == MoveState::near_miss) return std::nullopt;
    const std::string line = "line " + std::to_string(found->line) + " of the new path ";
    if (found->state == MoveState::not_checked || found->state == MoveState::not_certified)
      return line + "is " + (found->state == MoveState::not_checked ? "not checked: " : "not certified: ") +
             found->reason;
    if (found->state != MoveState::gouge || !found->witness) return line + "is buried now, which may hide it";
    if (found->witness->body == finding_.body && found->witness->against == finding_.against) return std::nullopt;
    // Of a move that gouges a part or a fixture, no depth in stock is stated.
    if (finding_.against == Against::stock) return line + "now gouges with another body, which may hide it";
    const std::optional<DepthBounds> still = contact_depth(*found, finding_.body, finding_.against);
    if (!still || still->high_mm <= before_.options.tolerance_mm) return std::nullopt;
    return line + (still->low_mm > 0 ? "gouges with it too, below" : "may gouge with it too, below") +
           " a deeper gouge of another body or obstacle";
  }

  const StoredResult& before_;
  const StoredResult& after_;
  const MotionAlignment& motions_;
  const EventRecord& finding_;
};

}  // namespace

std::optional<std::string> why_not_gone(const StoredResult& before, const StoredResult& after,
                                        const MotionAlignment& motions, const EventRecord& finding) {
  return AbsenceJudge(before, after, motions, finding).run();
}

}  // namespace gouge
