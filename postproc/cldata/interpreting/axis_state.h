#pragma once

#include <optional>
#include <utility>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"
#include "postproc/cldata/interpreting/uncertainties.h"

namespace gouge {

/// The tool axis: MULTAX, TLAXIS and the meaning of a position of three numbers. A file without MULTAX is read by the
/// habits of its dialect's writers. A MULTAX that the file never ends stays in force.
class AxisState {
 public:
  AxisState(StatementContext& in, Uncertainties& uncertainties) : in_(in), uncertainties_(uncertainties) {}

  void take_multax();
  void take_tlaxis();
  /// Ignores TLAXIS statements, which CAMplete may declare to be comments.
  void ignore_tlaxis() { is_tlaxis_ignored_ = true; }
  [[nodiscard]] bool is_tlaxis_ignored() const { return is_tlaxis_ignored_; }
  void begin_block() {
    modal_axis_ = Vec3::UnitZ();
    is_modal_doubtful_ = false;
  }
  /// Notes the axis that stays in force after a position or a control point.
  void note_position(const Vec3& axis_local);
  /// Notes that positions are in another frame from here on. With `says_axis` the Z axis of this frame is the axis of
  /// positions without one.
  void note_frame(bool says_axis);

  /// Joins the state of another reading of the file. An axis that differs is unknown until the file states one.
  void join(const AxisState& other);

  [[nodiscard]] bool is_multax_on() const { return multax_.value_or(false); }
  /// Returns whether there was a TLAXIS since the last position.
  [[nodiscard]] bool is_new() const { return is_tlaxis_new_; }
  /// Returns the axis of a position that states none, in the frame of the block.
  [[nodiscard]] Vec3 implied() const {
    return in_.dialect.is_axis_modal ? modal_axis_ : locked_axis_ ? *locked_axis_ : fixed_axis_;
  }
  /// Returns whether a MULTAX must be written before an axis. In a file without MULTAX so far, it must if the writers
  /// of the dialect state MULTAX.
  [[nodiscard]] bool needs_multax() const { return !multax_.value_or(!in_.dialect.states_multax); }
  /// Returns how many numbers of the statement make a position: 3 or 6, or 0 after an error.
  [[nodiscard]] std::size_t numbers_per_point();
  /// Returns why the numbers of the statement have two readings, or null. `numbers` of them are taken for a position.
  [[nodiscard]] const char* two_readings(std::size_t numbers) const;
  /// Notes that the numbers are a list of positions without axes. Returns [first, last) of the moves whose axes may be
  /// positions too.
  [[nodiscard]] std::pair<std::size_t, std::size_t> note_list(std::size_t numbers);
  [[nodiscard]] bool is_doubtful(const Position& position);
  /// Returns whether the axis that positions have left in force is unknown.
  [[nodiscard]] bool is_modal_doubtful() const { return is_modal_doubtful_; }
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
  Vec3 fixed_axis_ = Vec3::UnitZ();  // the last TLAXIS
  std::optional<Vec3> locked_axis_;  // the axis that MULTAX/OFF locked
  std::optional<Vec3> last_axis_;    // of the last position whose numbers had an axis; in the frame in force
  bool is_tlaxis_new_ = false;
  bool has_tlaxis_ = false;
  bool has_lists_ = false;          // whether a file without MULTAX has lists of positions without axes
  std::size_t first_axis_ = kNone;  // in such a file: the first move with an axis
  bool is_tlaxis_ignored_ = false;
  bool is_last_tilted_ = false;
  bool is_fixed_doubtful_ = false;  // the fixed axis after MULTAX/OFF is uncertain
  bool is_lock_lost_ = false;       // the last axis was in another frame, or differs between readings
  bool is_modal_doubtful_ = false;  // the last axis given differs between readings
  Tally plain_after_tilt_;
  std::size_t renormalised_ = 0;
  double worst_length_ = 1;
};

}  // namespace gouge
