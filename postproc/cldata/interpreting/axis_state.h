#pragma once

#include <optional>

#include "postproc/cldata/interpreting/doubts.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/statement_context.h"

namespace gouge {

/// The tool axis: MULTAX, TLAXIS and what a position of three numbers means. A file that never says MULTAX is judged by
/// what its dialect's writers do; one that never ends it keeps it.
class AxisState {
 public:
  AxisState(StatementContext& in, Doubts& doubts) : in_(in), doubts_(doubts) {}

  void take_multax();
  void take_tlaxis();
  /// CAMplete makes comments of TLAXIS.
  void ignore_tlaxis() { is_tlaxis_ignored_ = true; }
  [[nodiscard]] bool is_tlaxis_ignored() const { return is_tlaxis_ignored_; }
  void begin_block() { modal_axis_ = Vec3::UnitZ(); }
  void note_position(const Vec3& axis_local);

  [[nodiscard]] bool is_multax_on() const { return multax_.value_or(false); }
  /// TLAXIS since the last position.
  [[nodiscard]] bool is_new() const { return is_tlaxis_new_; }
  /// Of a position without an axis, in the block's frame.
  [[nodiscard]] Vec3 implied() const { return in_.dialect.is_axis_modal ? modal_axis_ : fixed_axis_; }
  /// Before an axis can be written. Those who write files that state MULTAX say it where they mean it.
  [[nodiscard]] bool needs_multax() const { return !multax_.value_or(!in_.dialect.states_multax); }
  /// How many numbers of the statement make a position: 3 or 6, or 0 after an error.
  [[nodiscard]] std::size_t numbers_per_point();
  [[nodiscard]] bool are_axes_doubtful(std::size_t numbers) const;
  [[nodiscard]] bool is_doubtful(const Position& position);
  /// The unit vector at argument `first`; nothing after an error.
  [[nodiscard]] std::optional<Vec3> read(std::size_t first);

  void write_length_note() const;
  void write_plain_note() const;

 private:
  [[nodiscard]] bool are_axes_unit() const;

  StatementContext& in_;
  Doubts& doubts_;
  std::optional<bool> multax_;
  Vec3 modal_axis_ = Vec3::UnitZ();  // the last axis given, or TLAXIS
  Vec3 fixed_axis_ = Vec3::UnitZ();  // TLAXIS
  bool is_tlaxis_new_ = false;
  bool is_tlaxis_ignored_ = false;
  bool is_last_tilted_ = false;
  bool is_fixed_doubtful_ = false;  // a tilted TLAXIS, and MULTAX/OFF after it
  Tally plain_after_tilt_;
  std::size_t renormalised_ = 0;
  double worst_length_ = 1;
};

}  // namespace gouge
