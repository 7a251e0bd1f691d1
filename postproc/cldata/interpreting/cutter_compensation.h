#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/program/cutcom.h"

namespace gouge {

/// CUTCOM: the control offsets the path by a radius unknown here, unless the file or the user states that positions
/// are the cutter's centre. One that the file never ends holds for all positions that follow.
class CutterCompensation {
 public:
  explicit CutterCompensation(StatementContext& in) : in_(in) {}

  void begin();
  /// Ensures  The result is true where compensation is off and the file had it on before. In a file that never had it
  /// on, CUTCOM/OFF changes nothing.
  [[nodiscard]] bool end();
  /// The first move since it was last switched off, which it is now.
  [[nodiscard]] std::size_t begin_run() { return std::exchange(run_begin_, in_.moves()); }
  /// Positions are the cutter's centre: so states the user, for the whole file; or the file, until end_centre().
  void say_centre() { is_centre_ = is_centre_said_ = true; }
  void begin_centre() { is_centre_ = true; }
  void end_centre() { is_centre_ = is_centre_said_; }
  /// Positions are the contour, whatever CUTCOM states.
  void begin_contour() { is_contour_ = true; }
  void end_contour() { is_contour_ = false; }
  [[nodiscard]] bool is_centre() const { return is_centre_; }

  [[nodiscard]] CutcomSide side() const { return side_; }
  /// Returns why the next motion is not checked; empty where CUTCOM does not keep it from being so.
  [[nodiscard]] std::string_view reason() const;
  /// Returns the deviation of the motion to `move`, which reason() keeps from being checked. The tip is beside it,
  /// across `plane_normal`, where the control offsets it in that plane.
  [[nodiscard]] Cover cover(const Move& move, const std::optional<Pose>& start, const Vec3& plane_normal) const;
  void note_position();
  void break_motion() { was_on_ = false; }
  void write_note() const;

 private:
  /// Returns whether it is on, and nothing states that positions are the cutter's centre.
  [[nodiscard]] bool is_on() const { return is_contour_ || (side_ != CutcomSide::none && !is_centre_); }

  StatementContext& in_;
  CutcomSide side_ = CutcomSide::none;
  bool is_centre_said_ = false, is_centre_ = false, is_contour_ = false;
  bool is_across_axis_ = true;  // all that CUTCOM states is a side, a register and the plane XY
  bool was_on_ = false;         // at the last position
  bool was_ever_on_ = false;
  std::size_t run_begin_ = 0;
  Tally statements_;
};

}  // namespace gouge
