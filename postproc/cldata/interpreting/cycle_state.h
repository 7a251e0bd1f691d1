#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/parsing/cycle_statement.h"

namespace gouge {

/// A drilling cycle, while which positions are holes. It ends by CYCLE/OFF. A later statement may show that a cycle
/// should have ended, or the file may never end it. Then all positions behind its first are in doubt.
class CycleState {
 public:
  explicit CycleState(StatementContext& in) : in_(in) {}

  /// CYCLE with the words of one, or ON, which takes up the one that was switched off.
  void begin(double mm_per_unit);
  /// One begins of which nothing is understood.
  void begin_unknown();
  /// Ensures  The result is true where none is in force that could end, and the file has had one before. In a file that
  /// never has, CYCLE/OFF states what holds anyway.
  [[nodiscard]] bool end();
  /// Another tool: ON takes up no cycle of the one before.
  void change_tool() {
    if (!is_on_) drill_.reset();
  }
  void begin_block() { words_.clear(); }
  /// Takes a statement that no cycle holds. The next position could be a hole or a motion. It is reported there, as
  /// before it nothing is lost.
  void contradict();
  /// A statement that no cycle contains bounds the moves that could be holes of a cycle whose CYCLE is missing.
  void bound_holes() {
    if (!is_on_) first_possible_hole_ = in_.moves();
  }
  /// The moves of a hole at `place`, in part coordinates, were made.
  void note_hole(const Pose& place) {
    last_hole_ = place;
    count_hole();
  }
  void count_hole();
  void leave_hole() { last_hole_.reset(); }
  /// Returns [first, last) of the moves that are holes or motions of their own, the first time after begin(); else
  /// nothing.
  [[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> uncertainty();
  /// The plane that the user states is below the clearance of this hole.
  void note_low_plane() { below_clearance_.add(in_.line()); }
  void note_stray_end() { never_begun_.add(in_.line()); }

  /// Returns how deep the tool goes for DrillCycle::csink_mm; nothing: not known, so that the cycle is not understood.
  void set_countersink(std::optional<double> depth_mm);
  [[nodiscard]] bool is_on() const { return is_on_; }
  [[nodiscard]] bool has_holes() const { return first_positions_ != kNone; }
  [[nodiscard]] bool is_doubtful() const { return is_on_ && is_contradicted_; }
  /// Returns whether the file ends within it, and moves are in doubt.
  [[nodiscard]] bool is_left_open() const { return is_on_ && certain_moves_ < in_.moves(); }
  /// Returns the cycle; nothing where its words are not understood, for why().
  [[nodiscard]] const std::optional<DrillCycle>& drill() const { return drill_; }
  [[nodiscard]] const char* why() const { return why_; }
  [[nodiscard]] std::string_view uncertainty_reason() const { return reason_; }
  /// Returns the last position where that was a hole. GODLTA goes on from it, although the tool is elsewhere.
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
  std::size_t first_positions_ = kNone;  // the statement of its first position
  std::size_t certain_moves_ = 0;        // those before this one are certain whether or not the cycle ever ended
  bool is_contradicted_ = false;         // a later statement states that it should have ended
  std::size_t contradicted_moves_ = 0;   // read until then
  std::string_view reason_;              // reported for what it leaves doubtful
  std::size_t first_possible_hole_ = 0;  // while none is in force
  std::optional<Pose> last_hole_;
  std::vector<Argument> words_;  // of the last cycle that was described
  Tally never_begun_, never_ended_, without_retract_, below_clearance_;
};

}  // namespace gouge
