#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/cycle_statement.h"

namespace gouge {

/// A drilling cycle, during which positions are holes. CYCLE/OFF ends it. If a later statement shows that it should
/// have ended, or the file never ends it, all positions after its first are uncertain.
class CycleState {
 public:
  explicit CycleState(StatementContext& in) : in_(in) {}

  /// Takes CYCLE with the words of a cycle, or with ON, which resumes the cycle that was switched off.
  void begin(double mm_per_unit);
  /// Begins a cycle of which nothing is understood.
  void begin_unknown();
  /// Leaves its later positions unchecked: text for the control may have ended or changed it.
  void doubt(const char* why);
  /// Ends the cycle. Returns true if none is in force, but the file has had one before. In a file without cycles,
  /// CYCLE/OFF has no effect.
  [[nodiscard]] bool end();
  /// Notes another tool: ON does not resume a cycle of the previous tool.
  void change_tool() {
    if (!is_on_) drill_.reset();
  }
  void begin_block() { words_.clear(); }
  /// Takes a statement that does not occur in cycles. The next position may be a hole or a motion. This is reported at
  /// that position, because nothing is lost before it.
  void contradict();
  /// Notes a statement that does not occur in cycles. If the CYCLE of a cycle is missing, only moves after it can be
  /// holes.
  void bound_holes() {
    if (!is_on_) first_possible_hole_ = in_.moves();
  }
  /// Notes that the moves of a hole at `place`, in part coordinates, were made.
  void note_hole(const Pose& place) {
    last_hole_ = place;
    count_hole();
  }
  void count_hole();
  void leave_hole() { last_hole_.reset(); }
  /// Returns [first, last) of the moves that are holes or motions. Returns it once after begin(), then nothing.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> uncertainty();
  /// Notes that the plane stated by the user is below the clearance of this hole.
  void note_low_plane() { below_clearance_.add(in_.line()); }
  void note_stray_end() { never_begun_.add(in_.line()); }

  /// Sets the depth of the tool for DrillCycle::csink_mm; nothing: it is unknown, so the cycle is not checked.
  void set_countersink(std::optional<double> depth_mm);
  [[nodiscard]] bool is_on() const { return is_on_; }
  [[nodiscard]] bool has_holes() const { return first_positions_ != kNone; }
  [[nodiscard]] bool is_doubtful() const { return is_on_ && is_contradicted_; }
  /// Returns whether the file ends within the cycle, and moves are uncertain.
  [[nodiscard]] bool is_left_open() const { return is_on_ && certain_moves_ < in_.moves(); }
  /// Returns the cycle; nothing if its words are not understood, for the reason why().
  [[nodiscard]] const std::optional<DrillCycle>& drill() const { return drill_; }
  [[nodiscard]] const char* why() const { return why_; }
  [[nodiscard]] std::string_view uncertainty_reason() const { return reason_; }
  /// Returns the last position if it was a hole. GODLTA continues from it, although the tool is elsewhere.
  [[nodiscard]] const std::optional<Pose>& last_hole() const { return last_hole_; }
  [[nodiscard]] std::size_t first_possible_hole() const { return first_possible_hole_; }
  void write_notes() const;

 private:
  void take_changed_words();

  StatementContext& in_;
  bool is_on_ = false;
  bool was_ever_on_ = false;
  std::optional<DrillCycle> drill_;
  const char* why_ = Reasons::kCycle;
  std::size_t line_ = 0;                 // of the CYCLE in force
  std::size_t first_positions_ = kNone;  // the first statement with positions under the cycle
  std::size_t certain_moves_ = 0;        // moves before this one are certain, whether or not the cycle ended
  bool is_contradicted_ = false;         // a later statement shows that it should have ended
  std::size_t contradicted_moves_ = 0;   // number of moves read until that statement
  std::string_view reason_;              // the reason reported for its uncertain moves
  std::size_t first_possible_hole_ = 0;  // while no cycle is in force
  std::optional<Pose> last_hole_;
  std::vector<Argument> words_;  // of the last described cycle
  Tally never_begun_, never_ended_, without_retract_, below_clearance_;
};

}  // namespace gouge
