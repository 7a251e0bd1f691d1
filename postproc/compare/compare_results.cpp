#include "postproc/compare/compare_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/check/reason.h"
#include "lib/path/toolpath.h"
#include "postproc/compare/contact_depth.h"
#include "postproc/compare/judge_absence.h"
#include "postproc/compare/match_findings.h"
#include "postproc/compare/setup_differences.h"
#include "postproc/report/report_text.h"
#include "postproc/result/stored_result.h"

namespace gouge {
namespace {

// Returns the facts that are open in the new run and not in the old one, a sentence each.
std::vector<std::string> newly_open_facts(const StoredResult& before, const StoredResult& after) {
  std::vector<std::string> all;
  for (const Assumption& fact : after.record.assumptions) {
    const auto was_open = [&](const Assumption& then) {
      return then.is_open && then.subject == fact.subject && then.object == fact.object;
    };
    if (!fact.is_open || std::ranges::any_of(before.record.assumptions, was_open)) continue;
    all.push_back("not established any more: " + std::string(subject_name(fact.subject)) +
                  (fact.object.empty() ? "" : " " + fact.object) + " (" + basis_name(fact.basis) +
                  "): " + fact.evidence);
  }
  return all;
}

/// Returns the depth of the body of a finding in its obstacle; 0 if the move states none.
DepthBounds depth_of(const MoveRecord& move, const EventRecord& finding) {
  return contact_depth(move, finding.body, finding.against).value_or(DepthBounds{});
}

/// Returns the overcut of the body of a finding, which is measured for the deepest body of a move alone.
DepthBounds overcut_of(const MoveRecord& move, const EventRecord& finding) {
  const bool is_of_it = move.witness && move.witness->body == finding.body && move.witness->against == finding.against;
  if (!move.overcut_mm || !is_of_it) return {0, kAnyDepth_mm};
  return {*move.overcut_mm, move.overcut_upper_mm.value_or(kAnyDepth_mm)};
}

/// Bounds of the depths and overcuts of several motions: the largest ones. They are those of the body and the obstacle
/// of one finding.
struct Largest {
  DepthBounds depth, overcut;

  void add(const MoveRecord& move, const EventRecord& finding) {
    const auto extend = [](DepthBounds& all, const DepthBounds& one) {
      all.low_mm = std::max(all.low_mm, one.low_mm);
      all.high_mm = std::max(all.high_mm, one.high_mm);
    };
    extend(depth, depth_of(move, finding));
    extend(overcut, overcut_of(move, finding));
  }
};

/// Returns "line 6 is 2.000 mm deep, 1.000 mm before".
std::string deepening_text(const MoveRecord& now, double before_mm, LengthUnit unit) {
  const std::string line = "line " + std::to_string(now.line), before = depth_text(before_mm, unit);
  if (now.state == MoveState::buried) return "in " + line + " the tool is buried, it was " + before + " deep before";
  return line + " is " + depth_text(now.depth_mm.value_or(0), unit) + " deep, " + before + " before";
}

/// Returns "the overcut is 6.000 mm, 5.000 mm before".
std::string overcut_change(double now_mm, double before_mm, LengthUnit unit) {
  return "the overcut is " + depth_text(now_mm, unit) + ", " + depth_text(before_mm, unit) + " before";
}

/// Numbers of the motions that make a finding wider.
struct Widening {
  std::size_t fresh = 0;    ///< the same motion did not gouge before
  std::size_t unknown = 0;  ///< the same motion was not decided before
  std::size_t buried = 0;   ///< the same motion gouged before, and the tool is buried now
  std::size_t stock = 0;    ///< the motion meets remaining stock too, or may meet it, which was not so before
  std::size_t bodies = 0;   ///< the same motion gouged before, with another body or in another obstacle
  std::size_t far = 0;      ///< other motions than before, whose deepest points are far from those before

  /// Returns the number to which a move belongs whose motion had another state before; `then` is null if it was clean.
  [[nodiscard]] std::size_t& of(const MoveRecord& now, const MoveRecord* then) {
    if (then == nullptr || then->state == MoveState::near_miss) return fresh;
    if (then->state == MoveState::gouge && now.state == MoveState::gouge) return bodies;
    return then->state == MoveState::gouge && now.state == MoveState::buried ? buried : unknown;
  }
  /// Returns a sentence for each kind; empty if there is none.
  [[nodiscard]] std::string text() const {
    std::string all;
    const auto add = [&all](const std::string& one) { all += (all.empty() ? "" : "; ") + one; };
    if (fresh > 0) add(count_text(fresh, "motion gouges", "motions gouge") + " where nothing gouged before");
    if (unknown > 0)
      add(count_text(unknown, "motion gouges", "motions gouge") + " that " + (unknown == 1 ? "was" : "were") +
          " not checked or not certified before");
    if (buried > 0) add("the tool is buried in " + count_text(buried, "motion") + " that gouged before");
    if (bodies > 0)
      add(count_text(bodies, "motion gouges", "motions gouge") +
          " with another body or in another obstacle than before");
    if (stock > 0)
      add(count_text(stock, "motion is", "motions are") +
          " in remaining stock too, or may be, which was not so before");
    if (far > 0)
      add("more motions gouge than before; " + std::to_string(far) + " of them " +
          (far == 1 ? "has its deepest point" : "have their deepest points") + " more than " +
          std::to_string(static_cast<int>(kSamePlace_mm)) + " mm from those before");
    return all;
  }
};

/// The moves of the new path between two neighbouring motions that the old path has too.
struct Stretch {
  std::size_t first = 0, end = 0;
  std::optional<bool> has_grown = {};  ///< none: not computed yet
};

class Comparer {
 public:
  Comparer(const StoredResult& before, const StoredResult& after, const CompareOptions& options)
      : before_(before),
        after_(after),
        options_(options),
        motions_(align_motions(before.record.motion_list(), after.record.motion_list())) {}

  Comparison run() {
    Comparison made;
    made.before = &before_;
    made.after = &after_;
    const auto matched = match_findings(before_, after_, motions_);
    std::vector<bool> is_matched(before_.findings.size(), false);
    for (std::size_t n = 0; n < matched.size(); ++n) {
      made.findings.push_back(judge(n, matched[n]));
      for (const std::size_t k : matched[n])
        if (is_alike(before_.findings[k], after_.findings[n])) is_matched[k] = true;
    }
    for (std::size_t k = 0; k < before_.findings.size(); ++k) {
      if (is_matched[k]) continue;
      const auto why = why_not_gone(before_, after_, motions_, before_.findings[k]);
      made.findings.push_back({why ? Change::not_checked : Change::gone, {k}, {}, why.value_or("")});
    }
    made.differences = setup_differences(before_, after_);
    std::size_t open = 0;
    for (const MoveRecord& move : after_.record.moves)
      open += move.state == MoveState::not_checked || move.state == MoveState::not_certified ? 1U : 0U;
    made.open_moves = open - std::min(open, after_.record.totals.left_out_as_asked);
    made.open_facts = newly_open_facts(before_, after_);
    made.excess = compare_excess(before_, after_, options_.same_within_mm);
    return made;
  }

 private:
  [[nodiscard]] bool is_above(double depth_mm, double limit_mm) const {
    return depth_mm > limit_mm + options_.same_within_mm;
  }

  [[nodiscard]] ComparedFinding judge(std::size_t n, const std::vector<std::size_t>& was) const {
    ComparedFinding made{Change::same, was, {n}, {}};
    if (was.empty()) {
      made.change = Change::fresh;
      return made;
    }
    const EventRecord& finding = after_.findings[n];
    Largest old, now;
    std::vector<const MoveRecord*> all_before;
    for (const std::size_t k : was) {
      for (const MoveRecord* move : before_.moves_of(before_.findings[k])) {
        old.add(*move, finding);
        all_before.push_back(move);
      }
    }
    Widening wider;
    std::string deepening;  // of the first move that became deeper
    std::string further;    // of the first move with a new further contact
    Stretch stretch;
    const WitnessGrid places(before_, was, kSamePlace_mm);
    const bool had_stock = std::ranges::any_of(was, [&](std::size_t k) {
      return std::ranges::any_of(before_.moves_of(before_.findings[k]), [](auto* move) { return has_stock(*move); });
    });
    for (const MoveRecord* move : after_.moves_of(after_.findings[n])) {
      now.add(*move, finding);
      const std::size_t other = motions_.after_to_before[move->move];
      const MoveRecord* then = other == kNone ? nullptr : before_.find_move(other);
      if (has_stock(*move) && !(other == kNone ? had_stock : then != nullptr && has_stock(*then))) {
        made.change = Change::deeper;
        ++wider.stock;
      }
      const std::string more = why_further(*move, other == kNone ? all_before : std::vector{then});
      if (!more.empty()) made.change = Change::deeper;
      if (further.empty()) further = more;
      if (other == kNone) {
        const std::string deeper = why_deeper(*move, finding, old);
        if (!deeper.empty()) made.change = Change::deeper;
        if (deepening.empty()) deepening = deeper;
        if (!is_there(places, *move) && has_grown(n, was, stretch_of(move->move, stretch))) {
          made.change = Change::deeper;
          ++wider.far;
        }
      } else if (is_deeper(*move, finding, then)) {
        made.change = Change::deeper;
        if (then == nullptr || then->state != move->state || !contact_depth(*then, finding.body, finding.against))
          ++wider.of(*move, then);
        else if (deepening.empty())
          deepening = why_deeper(*move, finding, {depth_of(*then, finding), overcut_of(*then, finding)});
      }
    }
    if (made.change == Change::deeper) {
      made.why = wider.text();
      for (const std::string& one : {deepening, further})
        if (!one.empty()) made.why += (made.why.empty() ? "" : "; ") + one;
      return made;
    }
    made.why = why_shallower(now, old);
    if (!made.why.empty()) made.change = Change::shallower;
    return made;
  }

  // Returns the reason for which a gouge is deeper than gouges before: its depth, else its overcut; empty if it is not.
  [[nodiscard]] std::string why_deeper(const MoveRecord& now, const EventRecord& finding, const Largest& then) const {
    const LengthUnit unit = after_.record.unit;
    if (is_above(depth_of(now, finding).low_mm, then.depth.high_mm))
      return deepening_text(now, then.depth.low_mm, unit);
    const double overcut = overcut_of(now, finding).low_mm;
    if (!is_above(overcut, then.overcut.high_mm)) return {};
    return "in line " + std::to_string(now.line) + " " + overcut_change(overcut, then.overcut.low_mm, unit);
  }

  // Returns the reason for which the further contacts of a move are more than the contacts of motions before; empty if they
  // are not. A null among these motions was clean.
  [[nodiscard]] std::string why_further(const MoveRecord& now, const std::vector<const MoveRecord*>& before) const {
    for (const FurtherRecord& contact : now.further) {
      std::optional<DepthBounds> then;
      for (const MoveRecord* move : before) {
        const auto one = move == nullptr ? std::nullopt : contact_depth(*move, contact.body, contact.against);
        if (one && (!then || one->high_mm > then->high_mm)) then = one;
      }
      const double depth_mm = contact.depth_mm.value_or(0);
      if (then && !is_above(depth_mm, then->high_mm)) continue;
      const LengthUnit unit = after_.record.unit;
      const std::string pair = std::string(body_name(contact.body)) + (contact.depth_mm ? " gouges " : " may gouge ") +
                               (contact.against == Against::part ? "the part" : "a fixture") + " too";
      return "in line " + std::to_string(now.line) + " the " + pair +
             (contact.depth_mm ? ", " + depth_text(depth_mm, unit) + " deep" : "") + ", " +
             (then ? depth_text(then->low_mm, unit) + " before" : "which was not so before");
    }
    return {};
  }

  // Returns the reason for which a finding that is not deeper is shallower; empty if it is not.
  [[nodiscard]] std::string why_shallower(const Largest& now, const Largest& old) const {
    const LengthUnit unit = after_.record.unit;
    if (is_above(old.depth.low_mm, now.depth.high_mm)) {
      if (std::isinf(old.depth.low_mm)) return "the tool was buried before";
      return "the depth is " + depth_text(now.depth.low_mm, unit) + ", " + depth_text(old.depth.low_mm, unit) +
             " before";
    }
    if (!is_above(old.overcut.low_mm, now.overcut.high_mm)) return {};
    return overcut_change(now.overcut.low_mm, old.overcut.low_mm, unit);
  }

  // Returns whether there was a gouge at the place of a move. For a buried tool no place is known, so the result is
  // true.
  [[nodiscard]] static bool is_there(const WitnessGrid& places, const MoveRecord& move) {
    if (!move.witness) return true;
    bool is_there = false;
    places.for_each_near(move.witness->point_mm, [&](const WitnessGrid::Near&, double) { is_there = true; });
    return is_there;
  }

  // Returns whether, between the nearest motions that both paths have, more moves gouge than before. If the depth is
  // equal over an area, its deepest point may be anywhere in the area. So places alone are not sufficient.
  [[nodiscard]] bool has_grown(std::size_t n, const std::vector<std::size_t>& was, Stretch& stretch) const {
    if (stretch.has_grown) return *stretch.has_grown;
    const std::vector<std::size_t>& other = motions_.after_to_before;
    const std::size_t first = stretch.first, end = stretch.end;
    const std::size_t old_first = first > 0 ? other[first - 1] + 1 : 0;
    const std::size_t old_end = end < other.size() ? other[end] : before_.record.listed_motions();
    std::size_t old_count = 0;
    for (const std::size_t k : was) old_count += count_within(before_, before_.findings[k], old_first, old_end);
    stretch.has_grown = count_within(after_, after_.findings[n], first, end) > old_count;
    return *stretch.has_grown;
  }

  // Returns the stretch of a move. `last` is that of the previous move, and is returned again if the move is in it.
  [[nodiscard]] Stretch& stretch_of(std::size_t move, Stretch& last) const {
    if (move >= last.first && move < last.end) return last;
    const std::vector<std::size_t>& other = motions_.after_to_before;
    last = {move, move, {}};
    while (last.first > 0 && other[last.first - 1] == kNone) --last.first;
    while (last.end < other.size() && other[last.end] == kNone) ++last.end;
    return last;
  }

  static std::size_t count_within(const StoredResult& result, const EventRecord& finding, std::size_t first,
                                  std::size_t end) {
    std::size_t count = 0;
    for (const MoveRecord* move : result.moves_of(finding)) count += move->move >= first && move->move < end ? 1U : 0U;
    return count;
  }

  /// Returns whether the move of a gouge of a part or a fixture meets remaining stock too, or may meet it.
  [[nodiscard]] static bool has_stock(const MoveRecord& move) {
    return move.state == MoveState::gouge && is_text_of_stock_too(move.reason);
  }

  // Compares one motion in both runs; `then` is null if it was clean.
  [[nodiscard]] bool is_deeper(const MoveRecord& now, const EventRecord& finding, const MoveRecord* then) const {
    const bool was_found = then != nullptr && (then->state == MoveState::gouge || then->state == MoveState::buried) &&
                           contact_depth(*then, finding.body, finding.against);
    if (!was_found)
      return is_above(depth_of(now, finding).low_mm, before_.options.tolerance_mm + before_.options.resolution_mm);
    return !why_deeper(now, finding, {depth_of(*then, finding), overcut_of(*then, finding)}).empty();
  }

  const StoredResult& before_;
  const StoredResult& after_;
  const CompareOptions& options_;
  MotionAlignment motions_;
};

}  // namespace

const char* change_name(Change change) {
  static constexpr std::array<const char*, kChanges> kNames = {"new",  "deeper",    "not-checked-any-more",
                                                               "gone", "shallower", "same"};
  return kNames.at(static_cast<std::size_t>(change));
}

std::size_t Comparison::count(Change change) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(findings, [&](const ComparedFinding& one) { return one.change == change; }));
}

ExitCode Comparison::exit_status() const {
  const auto has = [&](Change change) { return count(change) > 0 || (excess && excess->change == change); };
  if (has(Change::fresh) || has(Change::deeper)) return kExitGouges;
  return has(Change::not_checked) || open_moves + open_facts.size() > 0 ? kExitNotChecked : kExitClean;
}

Comparison compare_results(const StoredResult& before, const StoredResult& after, const CompareOptions& options) {
  return Comparer(before, after, options).run();
}

}  // namespace gouge
