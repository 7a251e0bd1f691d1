#include "postproc/accept/apply_baseline.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/report/baseline_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

/// A motion with the identity of its tool, its body and its counterpart.
using Key = std::tuple<std::string, std::string, std::string, std::string>;

struct Offer {
  std::size_t entry = 0;
  const AcceptedMove* move = nullptr;
  bool is_used = false;
};

/// The acceptances with the same key.
struct Slot {
  std::vector<Offer> offers;
  std::size_t passes = 0, used = 0;  ///< how often it may gouge, and how often it does
};

/// Result for one move.
struct MoveAnswer {
  std::optional<std::size_t> entry;  ///< the entry that accepts the move
  std::set<std::size_t> of_motion;   ///< entries with the same motion
  std::string why_not;
};

class Baseline {
 public:
  Baseline(const std::vector<Acceptance>& accepted, const CheckedFindings& checked)
      : accepted_(accepted), checked_(checked) {}

  BaselineFacts run() {
    for (std::size_t k = 0; k < accepted_.size(); ++k) add_entry(k);
    judge_all();
    for (std::size_t i = 0; i < facts_.events.size(); ++i) explain_changed_motion(i);
    set_aside_others();
    return std::move(facts_);
  }

 private:
  void add_entry(std::size_t k) {
    const Acceptance& a = accepted_[k];
    BaselineEntry entry;
    entry.by = a.by;
    entry.date = a.date;
    entry.reason = a.reason;
    entry.toolpath = a.toolpath;
    entry.line = a.line;
    entry.finding = a.toolpath + ":" + std::to_string(a.line) + ": " + a.finding;
    if (const auto change = find_setup_change(a)) {
      entry.use = BaselineEntry::Use::voided;
      entry.why = *change;
      for (const AcceptedMove& move : a.moves) void_[{move.motion, a.body, a.against}].insert(k);
    } else {
      for (const AcceptedMove& move : a.moves) {
        Slot& slot = slots_[{move.motion, a.setup.tool, a.body, a.against}];
        slot.offers.push_back({k, &move});
        slot.passes = std::max(slot.passes, move.passes);
      }
    }
    facts_.entries.push_back(std::move(entry));
  }

  // Judges first the findings in whose lines an entry was made, because an entry counts where it was made if its motion
  // gouges more often than it was accepted.
  void judge_all() {
    const std::vector<CheckedFinding>& findings = checked_.findings;
    facts_.events.resize(findings.size());
    std::vector<std::size_t> later;
    for (std::size_t i = 0; i < findings.size(); ++i) {
      const bool has_own =
          std::ranges::any_of(accepted_, [&](const Acceptance& a) { return is_made_in(a, findings[i]); });
      has_own ? static_cast<void>(facts_.events[i] = judge(findings[i])) : later.push_back(i);
    }
    for (const std::size_t i : later) facts_.events[i] = judge(findings[i]);
  }

  [[nodiscard]] bool is_of_other(const std::string& toolpath) const {
    return is_of_other_program(toolpath, checked_.toolpath);
  }

  // Returns whether an entry was made for a line of a finding of this program.
  [[nodiscard]] bool is_made_in(const Acceptance& a, const CheckedFinding& finding) const {
    return finding.first_line <= a.line && a.line <= finding.last_line && !is_of_other(a.toolpath);
  }

  [[nodiscard]] std::optional<std::string> find_setup_change(const Acceptance& a) const {
    if (auto change = find_change(a.setup, checked_.setup, checked_.unit)) return change;
    bool is_named = false;
    for (const CheckedTool& tool : checked_.tools) {
      if (tool.identity == a.setup.tool) return std::nullopt;
      is_named = is_named || tool.key == a.tool;
    }
    if (is_named) return stored_tool_label(a.tool) + " has other dimensions";
    return std::nullopt;
  }

  EventAcceptance judge(const CheckedFinding& finding) {
    EventAcceptance judged;
    if (!finding.is_gouge) return judged;
    std::map<std::size_t, std::size_t> applied;  // the number of moves that each entry accepts
    std::set<std::size_t> of_motion;
    std::size_t count = 0;
    std::string why;
    for (const CheckedMove& move : finding.moves) {
      MoveAnswer answer = ask(finding, move);
      of_motion.insert(answer.of_motion.begin(), answer.of_motion.end());
      if (answer.entry) {
        ++count;
        ++applied[*answer.entry];
      } else if (why.empty()) {
        why = answer.why_not;
      }
    }
    judged.is_accepted = count > 0 && count == finding.moves.size() && !finding.tool.empty();
    if (judged.is_accepted) {
      facts_.accepted_moves += count;
      for (const auto& [k, moves] : applied) {
        judged.entries.push_back(k);
        facts_.entries[k].use = BaselineEntry::Use::applied;
        facts_.entries[k].why.clear();
      }
      return judged;
    }
    judged.entries.assign(of_motion.begin(), of_motion.end());
    if (of_motion.empty()) return judged;
    judged.why_not = why;
    if (count > 0)
      judged.why_not += " (" + std::to_string(count) + " of " + count_text(finding.moves.size(), "move") + " accepted)";
    for (const std::size_t k : of_motion) {
      const auto part = applied.find(k);
      part != applied.end() && is_of_other(accepted_[k].toolpath) ? apply_in_part(k, finding, part->second)
                                                                  : void_entry(k, judged.why_not);
    }
    return judged;
  }

  // Marks an entry of another program that accepts some moves of a finding here. It keeps its effect where it was made.
  void apply_in_part(std::size_t k, const CheckedFinding& finding, std::size_t moves) {
    BaselineEntry& entry = facts_.entries[k];
    if (entry.use != BaselineEntry::Use::unused) return;
    entry.use = BaselineEntry::Use::partly;
    entry.why = "it accepts " + std::to_string(moves) + " of " + count_text(finding.moves.size(), "move") +
                " of the gouge in line " + std::to_string(finding.line);
  }

  // Voids an entry whose finding has changed: none of its moves is accepted any more.
  void void_entry(std::size_t k, const std::string& why) {
    BaselineEntry& entry = facts_.entries[k];
    if (entry.use != BaselineEntry::Use::unused) return;
    entry.use = BaselineEntry::Use::voided;
    entry.why = why;
  }

  // Voids entries of this program whose motion is not in the path any more, where another motion gouges in its line.
  void explain_changed_motion(std::size_t i) {
    const CheckedFinding& finding = checked_.findings[i];
    EventAcceptance& judged = facts_.events[i];
    if (!finding.is_gouge || judged.is_accepted) return;
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      const Acceptance& a = accepted_[k];
      const bool is_there = is_made_in(a, finding) && a.tool == finding.tool_key && a.body == finding.body &&
                            a.against == finding.against;
      if (!is_there || facts_.entries[k].use != BaselineEntry::Use::unused) continue;
      double accepted_mm = 0;
      for (const AcceptedMove& move : a.moves) accepted_mm = std::max(accepted_mm, move.depth_upper_mm);
      const std::string why = "the motion in line " + std::to_string(a.line) +
                              " is another one: " + depth_text(finding.depth_mm, checked_.unit) +
                              " deep, accepted up to " + depth_text(accepted_mm, checked_.unit);
      void_entry(k, why);
      if (judged.entries.empty()) judged.why_not = why;
      judged.entries.push_back(k);
    }
  }

  // Marks the entries of other programs that concern no finding here. They keep their effect where they were made.
  void set_aside_others() {
    std::set<std::size_t> concerned;
    for (const EventAcceptance& event : facts_.events) concerned.insert(event.entries.begin(), event.entries.end());
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      BaselineEntry& entry = facts_.entries[k];
      if (!is_of_other(entry.toolpath) || entry.use == BaselineEntry::Use::applied || concerned.contains(k)) continue;
      entry.use = BaselineEntry::Use::elsewhere;
      entry.why.clear();
    }
  }

  MoveAnswer ask(const CheckedFinding& finding, const CheckedMove& move) {
    const std::string line = "line " + std::to_string(move.line);
    MoveAnswer answer;
    answer.why_not = line + " was not accepted";
    if (move.motion.empty()) return answer;
    if (const auto voided = void_.find({move.motion, finding.body, finding.against}); voided != void_.end()) {
      answer.of_motion = voided->second;
      answer.why_not = line + " was accepted, but " + facts_.entries[*voided->second.begin()].why;
    }
    const auto found = slots_.find({move.motion, finding.tool, finding.body, finding.against});
    if (found == slots_.end()) return answer;
    Slot& slot = found->second;
    for (const Offer& offer : slot.offers) answer.of_motion.insert(offer.entry);
    if (!move.open.empty()) {
      answer.why_not = line + " " + more_text(move.open);
      return answer;
    }
    answer.why_not = line + " gouges more often than was accepted";
    if (slot.used >= slot.passes) return answer;
    if (Offer* const offer = find_offer(slot, finding, move, line, answer.why_not)) {
      offer->is_used = true;
      ++slot.used;
      answer.entry = offer->entry;
    }
    return answer;
  }

  // Returns an offer that accepts the depth of a move: one that was made in the lines of its finding, if there is one.
  Offer* find_offer(Slot& slot, const CheckedFinding& finding, const CheckedMove& move, const std::string& line,
                    std::string& why_not) const {
    Offer* found = nullptr;
    for (Offer& offer : slot.offers) {
      if (offer.is_used) continue;
      if (const auto why = why_deeper(move, *offer.move)) {
        if (found == nullptr) why_not = line + " is " + *why;
        continue;
      }
      if (is_made_in(accepted_[offer.entry], finding)) return &offer;
      if (found == nullptr) found = &offer;
    }
    return found;
  }

  // Returns why a move is deeper than accepted. Both depths belong to one motion in one set-up, so they can differ only
  // by the gap between their certified bounds.
  [[nodiscard]] std::optional<std::string> why_deeper(const CheckedMove& now, const AcceptedMove& then) const {
    const LengthUnit unit = checked_.unit;
    const auto is_within = [](double a_mm, double b_mm) {
      return a_mm <= b_mm + Tolerance::kFewRoundings * (1 + b_mm);
    };
    const double resolution_mm = checked_.setup.resolution_mm;
    if (!is_within(now.depth_mm, then.depth_upper_mm))
      return depth_text(now.depth_mm, unit) + " deep, accepted up to " + depth_text(then.depth_upper_mm, unit);
    if (!is_within(now.depth_upper_mm, then.depth_upper_mm + resolution_mm))
      return "certified to " + depth_text(now.depth_upper_mm, unit) + " only, accepted up to " +
             depth_text(then.depth_upper_mm, unit);
    if (!now.overcut_mm) return std::nullopt;
    if (!then.overcut_upper_mm) return std::string("known with an overcut now, and was accepted without");
    if (!is_within(*now.overcut_mm, *then.overcut_upper_mm))
      return "at an overcut of " + depth_text(*now.overcut_mm, unit) + ", accepted up to " +
             depth_text(*then.overcut_upper_mm, unit);
    return std::nullopt;
  }

  const std::vector<Acceptance>& accepted_;
  const CheckedFindings& checked_;
  BaselineFacts facts_;
  std::map<Key, Slot> slots_;
  std::map<std::tuple<std::string, std::string, std::string>, std::set<std::size_t>> void_;
};

}  // namespace

BaselineFacts apply_acceptances(const std::vector<Acceptance>& accepted, const CheckedFindings& checked) {
  return Baseline(accepted, checked).run();
}

BaselineFacts apply_baseline(const std::string& file, const std::vector<Acceptance>& accepted,
                             const ReportModel& model) {
  BaselineFacts facts = apply_acceptances(accepted, checked_findings(model));
  facts.file = file;
  for (std::size_t k = 0; k < accepted.size(); ++k) facts.entries[k].text = write_entry(accepted[k]);
  return facts;
}

}  // namespace gouge
