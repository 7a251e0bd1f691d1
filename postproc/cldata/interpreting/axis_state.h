#pragma once

#include <optional>
#include <utility>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"

namespace gouge {

/// The tool axis: MULTAX, TLAXIS and what a position of three numbers means. A file that never states MULTAX is judged
/// by what its dialect's writers do; one that never ends it keeps it.
class AxisState {
 public:
  AxisState(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  void take_multax();
  void take_tlaxis();
  /// CAMplete makes comments of TLAXIS.
  void ignore_tlaxis() { is_tlaxis_ignored_ = true; }
  [[nodiscard]] bool is_tlaxis_ignored() const { return is_tlaxis_ignored_; }
  void begin_block() { modal_axis_ = Vec3::UnitZ(); }
  /// The axis that a position or a control point leaves in force.
  void note_position(const Vec3& axis_local);
  /// Positions are in another frame from here on. `says_axis`: its Z axis is that of positions without one.
  void note_frame(bool says_axis);

  [[nodiscard]] bool is_multax_on() const { return multax_.value_or(false); }
  /// Returns whether a TLAXIS stands since the last position.
  [[nodiscard]] bool is_new() const { return is_tlaxis_new_; }
  /// Axis of a position that states none, in the block's frame.
  [[nodiscard]] Vec3 implied() const {
    return in_.dialect.is_axis_modal ? modal_axis_ : locked_axis_ ? *locked_axis_ : fixed_axis_;
  }
  /// Before an axis can be written. Those who write files that state MULTAX state it where they mean it.
  [[nodiscard]] bool needs_multax() const { return !multax_.value_or(!in_.dialect.states_multax); }
  /// Returns the number of numbers of the statement make a position: 3 or 6, or 0 after an error.
  [[nodiscard]] std::size_t numbers_per_point();
  /// Returns why the numbers of the statement, `numbers` of which are taken for a position, have two readings; or null.
  [[nodiscard]] const char* two_readings(std::size_t numbers) const;
  /// The numbers are a list of positions without axes: [first, last) of the moves whose axes may be positions as well.
  [[nodiscard]] std::pair<std::size_t, std::size_t> note_list(std::size_t numbers);
  [[nodiscard]] bool is_doubtful(const Position& position);
  /// Returns the unit vector at argument `first`; nothing after an error.
  [[nodiscard]] std::optional<Vec3> read(std::size_t first);

  void write_length_note() const;
  void write_plain_note() const;

 private:
  [[nodiscard]] bool are_axes_unit() const;
  [[nodiscard]] bool may_have_normals() const;
  void lock_axis();

  StatementContext& in_;
  Uncertainties& uncertainties_;
  std::optional<bool> multax_;
  Vec3 modal_axis_ = Vec3::UnitZ();  // the last axis given, or TLAXIS
  Vec3 fixed_axis_ = Vec3::UnitZ();  // TLAXIS
  std::optional<Vec3> locked_axis_;  // by MULTAX/OFF
  std::optional<Vec3> last_axis_;    // of the last position that had one in its numbers, in the frame in force
  bool is_tlaxis_new_ = false;
  bool has_tlaxis_ = false;
  bool has_lists_ = false;          // of positions without axes, in a file that does not state MULTAX
  std::size_t first_axis_ = kNone;  // the first move with one in such a file
  bool is_tlaxis_ignored_ = false;
  bool is_last_tilted_ = false;
  bool is_fixed_doubtful_ = false;  // the state after MULTAX/OFF is not known
  bool is_lock_lost_ = false;       // the last axis was in another frame
  Tally plain_after_tilt_;
  std::size_t renormalised_ = 0;
  double worst_length_ = 1;
};

}  // namespace gouge
