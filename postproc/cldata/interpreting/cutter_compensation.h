#pragma once

#include <optional>
#include <string_view>
#include <utility>

#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/program/cutcom.h"

namespace gouge {

/// CUTCOM: the control offsets the path by an unknown radius, unless the file or the user states that positions are
/// those of the cutter's centre. A CUTCOM that the file never ends holds for all positions that follow.
class CutterCompensation {
 public:
  explicit CutterCompensation(StatementContext& in) : in_(in) {}

  void begin();
  /// Ends the compensation. Returns true if the file had it on before, it is off already, and positions are not those
  /// of the cutter's centre. In a file that never had it on, CUTCOM/OFF changes nothing.
  [[nodiscard]] bool end();
  /// Returns the first move since compensation was last switched off, and begins a new such run here.
  [[nodiscard]] std::size_t begin_run() { return std::exchange(run_begin_, in_.moves()); }
  /// Notes that positions are those of the cutter's centre. If the user states this, it holds for the whole file; if
  /// the file does, until end_centre().
  void say_centre() { is_centre_ = is_centre_said_ = true; }
  void begin_centre() { is_centre_ = true; }
  void end_centre() { is_centre_ = is_centre_said_; }
  /// Notes that positions are those of the contour, independent of CUTCOM.
  void begin_contour() { is_contour_ = true; }
  void end_contour() { is_contour_ = false; }
  [[nodiscard]] bool is_centre() const { return is_centre_; }

  /// Returns whether the compensation and the meaning of positions are those of `other`.
  [[nodiscard]] bool is_same(const CutterCompensation& other) const {
    return side_ == other.side_ && is_centre_ == other.is_centre_ && is_contour_ == other.is_contour_;
  }

  [[nodiscard]] CutcomSide side() const { return side_; }
  /// Returns why the next motion is not checked; empty if CUTCOM does not prevent its check.
  [[nodiscard]] std::string_view reason() const;
  /// Returns the deviation of the motion to `move`, which reason() excludes from the check. If the control offsets the
  /// path in a plane, the tip is beside the path across `plane_normal`.
  [[nodiscard]] Cover cover(const Move& move, const std::optional<Pose>& start, const Vec3& plane_normal) const;
  void note_position();
  void break_motion() { was_on_ = false; }
  void write_note() const;

 private:
  /// Returns whether compensation is on, and no statement says that positions are those of the cutter's centre.
  [[nodiscard]] bool is_on() const { return is_contour_ || (side_ != CutcomSide::none && !is_centre_); }

  StatementContext& in_;
  CutcomSide side_ = CutcomSide::none;
  bool is_centre_said_ = false, is_centre_ = false, is_contour_ = false;
  bool is_across_axis_ = true;  // CUTCOM states only a side, a register and the plane XY
  bool was_on_ = false;         // whether it was on at the last position
  bool was_ever_on_ = false;
  std::size_t run_begin_ = 0;
  Tally statements_;
};

}  // namespace gouge
