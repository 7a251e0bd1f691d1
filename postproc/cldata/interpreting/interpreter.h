#pragma once

#include "postproc/cldata/interpreting/file_facts.h"
#include "postproc/cldata/interpreting/states.h"

// Statements to moves: the modal state of CL data. The reader runs it to fill a Toolpath. The writer runs it again over
// the same bytes to know in which state (axis, frame, unit, rapid) each position was read.

namespace gouge {

class Interpreter {
 public:
  /// Requires that `path.source` holds the bytes. The list `records` may be null; else it gets one entry for each move.
  Interpreter(Toolpath& path, const Dialect& dialect, LengthUnit unit, MotionRecords* records)
      : states_(path, dialect, unit, records) {}

  /// Takes the next statement. Once is_beyond_cutoff(), reading further has no use.
  void take(const Statement& statement);
  /// To be called once, after the last statement.
  void finish();

  /// Positions under CUTCOM are the cutter's centre, because the user states so.
  void set_cutter_centre() { states_.cutcom.say_centre(); }

  [[nodiscard]] Diagnostics take_errors() { return states_.in.take_errors(); }
  [[nodiscard]] const FeedUnits& feed_units() const { return states_.feed_units; }
  /// Facts that the file establishes about itself. Requires finish().
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
