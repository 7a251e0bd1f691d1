#pragma once

#include "postproc/cldata/interpreting/file_facts.h"
#include "postproc/cldata/interpreting/states.h"

// The interpreter of CL data, which turns statements into moves and keeps the modal state. The reader runs it to fill a
// Toolpath. The writer runs it again over the same bytes to find the state (axis, frame, unit, rapid) in which each
// position was read.

namespace gouge {

class Interpreter {
 public:
  /// Requires that `path.source` holds the bytes. `records` may be null; else it gets one entry for each move.
  Interpreter(Toolpath& path, const Dialect& dialect, LengthUnit unit, MotionRecords* records)
      : states_(path, dialect, unit, records) {}

  /// Takes the next statement. After is_beyond_cutoff(), further reading is useless.
  void take(const Statement& statement);
  /// Completes the path. Must be called once, after the last statement.
  void finish();

  /// Notes that positions under CUTCOM are those of the cutter's centre, because the user states so.
  void set_cutter_centre() { states_.cutcom.say_centre(); }

  [[nodiscard]] Diagnostics take_errors() { return states_.in.take_errors(); }
  [[nodiscard]] const FeedUnits& feed_units() const { return states_.feed_units; }
  /// Returns the facts that the file establishes about itself. Requires finish().
  [[nodiscard]] const FileFacts& facts() const { return facts_; }
  [[nodiscard]] bool is_beyond_cutoff() const { return states_.in.is_beyond_cutoff(); }

 private:
  [[nodiscard]] bool refuse();
  void write_notes();
  void gather_facts();

  States states_;
  FileFacts facts_;
};

}  // namespace gouge
