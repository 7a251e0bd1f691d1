#include "postproc/accept/apply_baseline.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/path/motion_key.h"
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
  Baseline(const std::string& file, const std::vector<Acceptance>& accepted, const ReportModel& model)
      : accepted_(accepted), model_(model) {
    facts_.file = file;
  }

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
    entry.text = write_entry(a);
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
    const std::vector<Event>& events = model_.result->events;
    facts_.events.resize(events.size());
    std::vector<std::size_t> later;
    for (std::size_t i = 0; i < events.size(); ++i) {
      const bool has_own =
          std::ranges::any_of(accepted_, [&](const Acceptance& a) { return is_made_in(a, events[i]); });
      has_own ? static_cast<void>(facts_.events[i] = judge(events[i])) : later.push_back(i);
    }
    for (const std::size_t i : later) facts_.events[i] = judge(events[i]);
  }

  // Returns whether an entry was made for a line of a finding of this program.
  [[nodiscard]] bool is_made_in(const Acceptance& a, const Event& event) const {
    const Moves& moves = model_.toolpath->moves;
    return moves[event.first_move].line <= a.line && a.line <= moves[event.last_move].line &&
           !is_of_other_program(a.toolpath, model_);
  }

  [[nodiscard]] std::optional<std::string> find_setup_change(const Acceptance& a) const {
    if (auto change = find_change(a.setup, setup_of(model_, a.setup.tool), model_.toolpath->unit)) return change;
    bool is_named = false;
    for (std::size_t i = 0; i < model_.toolpath->tools.size() && i < model_.tools.size(); ++i) {
      if (model_.tools[i].identity == a.setup.tool) return std::nullopt;
      is_named = is_named || tool_key(*model_.toolpath, i) == a.tool;
    }
    if (is_named) return stored_tool_label(a.tool) + " has other dimensions";
    return std::nullopt;
  }

  EventAcceptance judge(const Event& event) {
    EventAcceptance judged;
    if (event.state != MoveState::gouge || event.tool >= model_.tools.size()) return judged;
    const std::string& tool = model_.tools[event.tool].identity;
    std::set<std::size_t> applied, of_motion;
    std::size_t count = 0;
    std::string why;
    for (std::size_t move = event.first_move; move <= event.last_move; ++move) {
      MoveAnswer answer = ask(event, tool, move);
      of_motion.insert(answer.of_motion.begin(), answer.of_motion.end());
      if (answer.entry) {
        ++count;
        applied.insert(*answer.entry);
      } else if (why.empty()) {
        why = answer.why_not;
      }
    }
    judged.is_accepted = count > 0 && count == event.moves && !tool.empty();
    const std::set<std::size_t>& of = judged.is_accepted ? applied : of_motion;
    judged.entries.assign(of.begin(), of.end());
    if (judged.is_accepted) {
      facts_.accepted_moves += event.moves;
      for (const std::size_t k : applied) facts_.entries[k].use = BaselineEntry::Use::applied;
    } else if (!of_motion.empty()) {
      judged.why_not =
          count == 0 ? why
                     : why + " (" + std::to_string(count) + " of " + count_text(event.moves, "move") + " accepted)";
      for (const std::size_t k : of_motion) void_entry(k, judged.why_not);
    }
    return judged;
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
    const Event& event = model_.result->events[i];
    EventAcceptance& judged = facts_.events[i];
    const MoveVerdict& worst = model_.result->verdicts[event.worst_move];
    if (event.state != MoveState::gouge || judged.is_accepted || !worst.witness) return;
    const LengthUnit unit = model_.toolpath->unit;
    const std::size_t first = model_.toolpath->moves[event.first_move].line,
                      last = model_.toolpath->moves[event.last_move].line;
    for (std::size_t k = 0; k < accepted_.size(); ++k) {
      const Acceptance& a = accepted_[k];
      const bool is_there = first <= a.line && a.line <= last && a.tool == tool_key(*model_.toolpath, event.tool) &&
                            a.body == body_name(event.body) && a.against == against_name(event.against);
      if (!is_there || is_of_other_program(a.toolpath, model_) || facts_.entries[k].use != BaselineEntry::Use::unused)
        continue;
      double accepted_mm = 0;
      for (const AcceptedMove& move : a.moves) accepted_mm = std::max(accepted_mm, move.depth_upper_mm);
      const std::string why = "the motion in line " + std::to_string(a.line) +
                              " is another one: " + depth_text(worst.depth_mm, unit) + " deep, accepted up to " +
                              depth_text(accepted_mm, unit);
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
      if (!is_of_other_program(entry.toolpath, model_) || entry.use == BaselineEntry::Use::applied ||
          concerned.contains(k))
        continue;
      entry.use = BaselineEntry::Use::elsewhere;
      entry.why.clear();
    }
  }

  MoveAnswer ask(const Event& event, const std::string& tool, std::size_t move) {
    const MoveVerdict& verdict = model_.result->verdicts[move];
    const std::string line = "line " + std::to_string(model_.toolpath->moves[move].line);
    MoveAnswer answer;
    answer.why_not = line + " was not accepted";
    if (verdict.state != MoveState::gouge || !verdict.witness) return answer;
    if (!verdict.reason.is(Reason::Kind::none) && !verdict.reason.names_limit()) {
      answer.why_not = line + " leaves more open: " + reason_text(verdict.reason);
      return answer;
    }
    const std::string motion = motion_key(*model_.toolpath, move), body = body_name(verdict.witness->body),
                      against = against_name(verdict.witness->against);
    if (event.body != verdict.witness->body || event.against != verdict.witness->against) return answer;
    if (const auto voided = void_.find({motion, body, against}); voided != void_.end()) {
      answer.of_motion = voided->second;
      answer.why_not = line + " was accepted, but " + facts_.entries[*voided->second.begin()].why;
    }
    const auto found = slots_.find({motion, tool, body, against});
    if (found == slots_.end()) return answer;
    Slot& slot = found->second;
    for (const Offer& offer : slot.offers) answer.of_motion.insert(offer.entry);
    if (slot.used >= slot.passes) {
      answer.why_not = line + " gouges more often than was accepted";
      return answer;
    }
    answer.why_not = line + " gouges more often than was accepted";
    if (Offer* const offer = find_offer(slot, event, verdict, line, answer.why_not)) {
      offer->is_used = true;
      ++slot.used;
      answer.entry = offer->entry;
    }
    return answer;
  }

  // Returns an offer that accepts the depth of a move: one that was made in the lines of its finding, if there is one.
  Offer* find_offer(Slot& slot, const Event& event, const MoveVerdict& verdict, const std::string& line,
                    std::string& why_not) const {
    Offer* found = nullptr;
    for (Offer& offer : slot.offers) {
      if (offer.is_used) continue;
      if (const auto why = why_deeper(verdict, *offer.move)) {
        if (found == nullptr) why_not = line + " is " + *why;
        continue;
      }
      const bool is_own = is_made_in(accepted_[offer.entry], event);
      if (is_own) return &offer;
      if (found == nullptr) found = &offer;
    }
    return found;
  }

  // Returns why a move is deeper than accepted. Both depths belong to one motion in one set-up, so they can differ only
  // by the gap between their certified bounds.
  [[nodiscard]] std::optional<std::string> why_deeper(const MoveVerdict& now, const AcceptedMove& then) const {
    const LengthUnit unit = model_.toolpath->unit;
    const auto is_within = [](double a_mm, double b_mm) {
      return a_mm <= b_mm + Tolerance::kFewRoundings * (1 + b_mm);
    };
    const double resolution_mm = model_.options.resolution_mm;
    if (!is_within(now.depth_mm, then.depth_upper_mm))
      return depth_text(now.depth_mm, unit) + " deep, accepted up to " + depth_text(then.depth_upper_mm, unit);
    if (!is_within(now.depth_upper_mm, then.depth_upper_mm + resolution_mm))
      return "certified to " + depth_text(now.depth_upper_mm, unit) + " only, accepted up to " +
             depth_text(then.depth_upper_mm, unit);
    if (!now.overcut) return std::nullopt;
    if (!then.overcut_upper_mm) return std::string("known with an overcut now, and was accepted without");
    if (!is_within(now.overcut->lower_mm, *then.overcut_upper_mm))
      return "at an overcut of " + depth_text(now.overcut->lower_mm, unit) + ", accepted up to " +
             depth_text(*then.overcut_upper_mm, unit);
    return std::nullopt;
  }

  const std::vector<Acceptance>& accepted_;
  const ReportModel& model_;
  BaselineFacts facts_;
  std::map<Key, Slot> slots_;
  std::map<std::tuple<std::string, std::string, std::string>, std::set<std::size_t>> void_;
};

}  // namespace

BaselineFacts apply_baseline(const std::string& file, const std::vector<Acceptance>& accepted,
                             const ReportModel& model) {
  return Baseline(file, accepted, model).run();
}

}  // namespace gouge
