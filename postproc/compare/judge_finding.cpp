#include "postproc/compare/judge_finding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "lib/base/number_text.h"
#include "lib/check/reason.h"
#include "lib/path/toolpath.h"
#include "postproc/compare/contact_depth.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

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

/// Appends a sentence to sentences.
void add_sentence(const std::string& one, std::string& all) {
  if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
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
    const auto add = [&all](const std::string& one) { add_sentence(one, all); };
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

/// Returns whether the move of a gouge of a part or a fixture meets remaining stock too, or may meet it.
bool has_stock(const MoveRecord& move) { return move.state == MoveState::gouge && is_text_of_stock_too(move.reason); }

class FindingJudge {
 public:
  FindingJudge(const StoredResult& before, const StoredResult& after, const MotionAlignment& motions,
               const CompareOptions& options, std::size_t n, const std::vector<std::size_t>& was)
      : before_(before),
        after_(after),
        motions_(motions),
        options_(options),
        finding_(after.findings[n]),
        was_(was),
        places_(before, was, kSamePlace_mm),
        made_{Change::same, was, {n}, {}} {
    for (const std::size_t k : was) {
      for (const MoveRecord* move : before.moves_of(before.findings[k])) {
        old_.add(*move, finding_);
        had_stock_ = had_stock_ || has_stock(*move);
        moves_before_.push_back(move);
      }
    }
  }

  ComparedFinding run() {
    for (const MoveRecord* move : after_.moves_of(finding_)) examine(*move);
    if (made_.change == Change::deeper) {
      made_.why = wider_.text();
      add_sentence(deepening_, made_.why);
      add_sentence(further_, made_.why);
      return made_;
    }
    made_.why = why_shallower();
    if (!made_.why.empty()) made_.change = Change::shallower;
    return made_;
  }

 private:
  void examine(const MoveRecord& now) {
    now_.add(now, finding_);
    const std::size_t other = motions_.after_to_before[now.move];
    if (other == kNone) return examine_new_motion(now);
    examine_same_motion(now, before_.find_move(other));
  }

  // Compares a motion that the old path does not have with all motions of the old findings.
  void examine_new_motion(const MoveRecord& now) {
    if (has_stock(now) && !had_stock_) widen(wider_.stock);
    note(why_further(now, moves_before_), further_);
    note(why_deeper(now, old_), deepening_);
    if (!is_there(now) && has_grown(now.move)) widen(wider_.far);
  }

  // Compares one motion in both runs; `then` is null if it was clean.
  void examine_same_motion(const MoveRecord& now, const MoveRecord* then) {
    if (has_stock(now) && (then == nullptr || !has_stock(*then))) widen(wider_.stock);
    const bool was_found = then != nullptr && (then->state == MoveState::gouge || then->state == MoveState::buried) &&
                           contact_depth(*then, finding_.body, finding_.against);
    if (!was_found) {
      const double allowed_mm = before_.options.tolerance_mm + before_.options.resolution_mm;
      if (is_above(depth_of(now, finding_).low_mm, allowed_mm)) widen(wider_.of(now, then));
    } else {
      const std::string deeper = why_deeper(now, {depth_of(*then, finding_), overcut_of(*then, finding_)});
      if (then->state == now.state)
        note(deeper, deepening_);
      else if (!deeper.empty())
        widen(wider_.of(now, then));
    }
    if (then != nullptr) note(why_further(now, {&then, 1}), further_);
  }

  void widen(std::size_t& count) {
    made_.change = Change::deeper;
    ++count;
  }

  // Takes a reason for which the finding is deeper. The first one of its kind is kept.
  void note(const std::string& reason, std::string& kept) {
    if (reason.empty()) return;
    made_.change = Change::deeper;
    if (kept.empty()) kept = reason;
  }

  [[nodiscard]] bool is_above(double depth_mm, double limit_mm) const {
    return depth_mm > limit_mm + options_.same_within_mm;
  }

  // Returns the reason for which a gouge is deeper than gouges before: its depth, else its overcut; empty if it is not.
  [[nodiscard]] std::string why_deeper(const MoveRecord& now, const Largest& then) const {
    const LengthUnit unit = after_.record.unit;
    if (is_above(depth_of(now, finding_).low_mm, then.depth.high_mm))
      return deepening_text(now, then.depth.low_mm, unit);
    const double overcut = overcut_of(now, finding_).low_mm;
    if (!is_above(overcut, then.overcut.high_mm)) return {};
    return "in line " + std::to_string(now.line) + " " + overcut_change(overcut, then.overcut.low_mm, unit);
  }

  // Returns the reason for which the further contacts of a move are more than the contacts of motions before; empty if
  // they are not.
  [[nodiscard]] std::string why_further(const MoveRecord& now, std::span<const MoveRecord* const> before) const {
    for (const FurtherRecord& contact : now.further) {
      std::optional<DepthBounds> then;
      for (const MoveRecord* move : before) {
        const auto one = contact_depth(*move, contact.body, contact.against);
        if (one && (!then || one->high_mm > then->high_mm)) then = one;
      }
      if (then && !is_above(contact.depth_mm.value_or(0), then->high_mm)) continue;
      return "in line " + std::to_string(now.line) + " " + further_change(contact, then);
    }
    return {};
  }

  // Returns "the holder gouges a fixture too, 2.1 mm deep, which was not so before".
  [[nodiscard]] std::string further_change(const FurtherRecord& contact, const std::optional<DepthBounds>& then) const {
    const LengthUnit unit = after_.record.unit;
    const std::string obstacle = contact.against == Against::part ? "the part" : "a fixture";
    return "the " + std::string(body_name(contact.body)) + (contact.depth_mm ? " gouges " : " may gouge ") + obstacle +
           " too" + (contact.depth_mm ? ", " + depth_text(*contact.depth_mm, unit) + " deep, " : ", ") +
           (then ? depth_text(then->low_mm, unit) + " before" : "which was not so before");
  }

  // Returns the reason for which a finding that is not deeper is shallower; empty if it is not.
  [[nodiscard]] std::string why_shallower() const {
    const LengthUnit unit = after_.record.unit;
    if (is_above(old_.depth.low_mm, now_.depth.high_mm)) {
      if (std::isinf(old_.depth.low_mm)) return "the tool was buried before";
      return "the depth is " + depth_text(now_.depth.low_mm, unit) + ", " + depth_text(old_.depth.low_mm, unit) +
             " before";
    }
    if (!is_above(old_.overcut.low_mm, now_.overcut.high_mm)) return {};
    return overcut_change(now_.overcut.low_mm, old_.overcut.low_mm, unit);
  }

  // Returns whether there was a gouge at the place of a move. For a buried tool no place is known, so the result is
  // true.
  [[nodiscard]] bool is_there(const MoveRecord& move) const {
    if (!move.witness) return true;
    bool is_there = false;
    places_.for_each_near(move.witness->point_mm, [&](const WitnessGrid::Near&, double) { is_there = true; });
    return is_there;
  }

  // Returns whether, between the nearest motions that both paths have, more moves gouge than before. If the depth is
  // equal over an area, its deepest point may be anywhere in the area. So places alone are not sufficient.
  [[nodiscard]] bool has_grown(std::size_t move) {
    Stretch& stretch = stretch_of(move);
    if (stretch.has_grown) return *stretch.has_grown;
    const std::vector<std::size_t>& other = motions_.after_to_before;
    const std::size_t first = stretch.first, end = stretch.end;
    const std::size_t old_first = first > 0 ? other[first - 1] + 1 : 0;
    const std::size_t old_end = end < other.size() ? other[end] : before_.record.listed_motions();
    std::size_t old_count = 0;
    for (const std::size_t k : was_) old_count += count_within(before_, before_.findings[k], old_first, old_end);
    stretch.has_grown = count_within(after_, finding_, first, end) > old_count;
    return *stretch.has_grown;
  }

  // Returns the stretch of a move. It is that of the previous move if the move is in it.
  [[nodiscard]] Stretch& stretch_of(std::size_t move) {
    if (move >= stretch_.first && move < stretch_.end) return stretch_;
    const std::vector<std::size_t>& other = motions_.after_to_before;
    stretch_ = {move, move, {}};
    while (stretch_.first > 0 && other[stretch_.first - 1] == kNone) --stretch_.first;
    while (stretch_.end < other.size() && other[stretch_.end] == kNone) ++stretch_.end;
    return stretch_;
  }

  static std::size_t count_within(const StoredResult& result, const EventRecord& finding, std::size_t first,
                                  std::size_t end) {
    std::size_t count = 0;
    for (const MoveRecord* move : result.moves_of(finding)) count += move->move >= first && move->move < end ? 1U : 0U;
    return count;
  }

  const StoredResult& before_;
  const StoredResult& after_;
  const MotionAlignment& motions_;
  const CompareOptions& options_;
  const EventRecord& finding_;
  const std::vector<std::size_t>& was_;
  WitnessGrid places_;
  std::vector<const MoveRecord*> moves_before_;  // of the old findings
  bool had_stock_ = false;                       // of these moves
  Largest old_, now_;
  Stretch stretch_;
  Widening wider_;
  std::string deepening_;  // of the first move that became deeper
  std::string further_;    // of the first move with a new further contact
  ComparedFinding made_;
};

}  // namespace

ComparedFinding judge_finding(const StoredResult& before, const StoredResult& after, const MotionAlignment& motions,
                              const CompareOptions& options, std::size_t n, const std::vector<std::size_t>& was) {
  if (was.empty()) return {Change::fresh, was, {n}, {}};
  return FindingJudge(before, after, motions, options, n, was).run();
}

}  // namespace gouge
