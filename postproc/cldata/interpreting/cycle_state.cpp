#include "postproc/cldata/interpreting/cycle_state.h"

#include <span>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreting/emit.h"
#include "postproc/cldata/interpreting/misreading.h"
#include "postproc/cldata/interpreting/word_handlers.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

// Takes CYCLE. In NX, ON resumes a cycle with other values for some of its words. CAMWorks CLT describes the cycle in
// the statement after ON, or behind ON in the same one.
void CycleState::begin(double mm_per_unit) {
  std::vector<Argument>& words = in_.arguments;
  const CycleForm form = in_.dialect.cycle_form;
  if (has_argument(std::span(words).subspan(0, 1), "ON") && words.size() > 1) {
    if (form == CycleForm::nx) take_changed_words();
    if (equals_ignoring_case(words[1].text, "CYCLE")) words.erase(words.begin(), words.begin() + 2);
  }
  if (words.empty()) return in_.count_unknown();
  const bool is_taken_up = equals_ignoring_case(words.front().text, "ON");
  const bool describes = !is_taken_up || words.size() > 1;
  const bool was_on = std::exchange(is_on_, true);
  was_ever_on_ = true;
  if (is_taken_up && !describes && was_on && form != CycleForm::clt) return;
  line_ = in_.line();
  first_positions_ = kNone;
  certain_moves_ = in_.moves();
  is_contradicted_ = false;
  reason_ = {};
  if (is_taken_up && (describes || form == CycleForm::clt)) drill_.reset();
  if (is_taken_up) {
    if (!drill_) why_ = describes ? in_.because(Reasons::kCycle) : Reasons::kCycle;
    return;
  }
  drill_ = read_cycle(form, words, mm_per_unit);
  words_ = words;
  if (!drill_) why_ = in_.because(Reasons::kCycle);
  if (drill_ && !drill_->is_retract_stated) without_retract_.add(in_.line());
}

// Replaces the arguments by those of the last cycle with the values stated here. They stay unchanged, and are then not
// understood, if there was no cycle, or if words here have no value.
void CycleState::take_changed_words() {
  if (words_.empty()) return;
  const std::optional<std::vector<Argument>> changed =
      changed_cycle(words_, std::span<const Argument>(in_.arguments).subspan(1));
  if (changed) in_.arguments = *changed;
}

void CycleState::set_countersink(std::optional<double> depth_mm) {
  if (!depth_mm) {
    drill_.reset();
    why_ = in_.because(Reasons::kCountersink);
    return;
  }
  drill_->bottom_mm = -*depth_mm;
  drill_->csink_mm = 0;
}

void CycleState::begin_unknown() {
  is_on_ = was_ever_on_ = true;
  drill_.reset();
  line_ = in_.line();
  first_positions_ = kNone;
  certain_moves_ = in_.moves();
  is_contradicted_ = false;
  contradicted_moves_ = 0;
  reason_ = {};
  first_possible_hole_ = 0;
  why_ = in_.because(Reasons::kCycle);
}

void CycleState::doubt(const char* why) {
  drill_.reset();
  words_.clear();
  why_ = why;
}

bool CycleState::end() { return !std::exchange(is_on_, false) && was_ever_on_; }

void CycleState::contradict() {
  if (!is_contradicted_) contradicted_moves_ = in_.moves();
  is_contradicted_ = true;
}

// Counts a hole. If the statement that ends the cycle was lost, it may have been after any position of the cycle except
// the first.
void CycleState::count_hole() {
  const std::size_t statement = in_.index();
  // a list in several records
  const bool goes_on = in_.statement().is_continuation && first_positions_ + 1 == statement;
  if (first_positions_ == kNone || goes_on) first_positions_ = statement;
  if (first_positions_ == statement) certain_moves_ = in_.moves();
}

std::optional<std::pair<std::size_t, std::size_t>> CycleState::uncertainty() {
  if (!reason_.empty()) return std::nullopt;
  reason_ = in_.named(Reasons::kCycleOpen, "CYCLE", line_);
  never_ended_.add(line_);
  return std::pair(certain_moves_, is_contradicted_ ? contradicted_moves_ : in_.moves());
}

void CycleState::write_notes() const {
  in_.report(
      Severity::warning, "path-cycle", never_ended_, "cycle",
      " never ended by CYCLE/OFF: which positions are holes and which are motions of their own the file does not "
      "say, so they are not checked");
  in_.report(Severity::warning, "path-cycle", never_begun_, "CYCLE/OFF statement",
             " without a cycle: the positions before it may be holes, so they are not checked");
  in_.report(Severity::warning, "path-cycle", below_clearance_, "hole",
             " with a clearance above the retract plane that is stated: the plane is not used there, and the paths up "
             "are not checked; expected a --retract-plane no lower than every clearance");
  in_.report(Severity::note, "path-cycle", without_retract_, "cycle",
             " without a retract height: taken to stay at the clearance between holes");
}

namespace {

// Handles a CYCLE/OFF while no cycle is in force. A cycle may have begun anywhere after the last word that does not
// occur in cycles.
void mark_moves_before_stray_end_uncertain(States& s) {
  Moves& moves = s.in.path.moves;
  std::string_view reason;
  for (std::size_t i = s.cycle.first_possible_hole(); i < moves.size(); ++i) {
    if (moves[i].kind != MoveKind::feed || !moves[i].not_checked_reason.empty()) continue;
    if (reason.empty()) {
      reason = s.in.because(Reasons::kCycleStrayEnd);
      s.cycle.note_stray_end();
    }
    moves[i].not_checked_reason = reason;
  }
  if (!reason.empty()) s.chain.lose_last_pose(Reasons::kAfterCycle);
}

}  // namespace

void take_cycle(States& s) {
  if (s.in.arguments.empty()) {
    s.in.count_unknown();
    return distrust(s, Word::cycle);
  }
  s.feed_units.note(s.in.arguments, s.in.line());
  const std::string_view what = s.in.arguments.front().text;
  if (equals_ignoring_case(what, "INIT") || equals_ignoring_case(what, "CLEAR")) {
    if (s.cycle.is_on()) s.cycle.contradict();  // no document states whether it ends the cycle in force
    return;
  }
  // The control or the post-processor makes the moves.
  if (s.in.dialect.cycle_form == CycleForm::ncl && equals_ignoring_case(what, "AUTO")) return;
  const bool is_end = equals_ignoring_case(what, "OFF") || equals_ignoring_case(what, "NOMORE");
  if (!is_end || s.in.arguments.size() > 1) {
    s.cycle.begin(s.frame.mm_per_unit());
    const auto& drill = s.cycle.drill();
    if (drill && drill->csink_mm > 0) s.cycle.set_countersink(s.tool.countersink_depth(drill->csink_mm));
    return;
  }
  if (s.cycle.end()) mark_moves_before_stray_end_uncertain(s);
  s.cycle.bound_holes();
}

}  // namespace gouge
