#include "postproc/cldata/interpreting/axis_state.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "postproc/cldata/interpreting/reasons.h"

namespace gouge {
namespace {

constexpr double kTiltReported = 1e-3;  // sine of the angle to +Z from which an axis counts as tilted

bool is_tilted(const Vec3& axis, const Vec3& upright = Vec3::UnitZ()) {
  return axis.cross(upright).squaredNorm() > kTiltReported * kTiltReported || axis.dot(upright) < 0;
}

}  // namespace

void AxisState::take_multax() {
  const bool is_off = in_.has("OFF");
  const bool is_known = in_.arguments.empty() || (in_.arguments.size() == 1 && (is_off || in_.has("ON")));
  uncertainties_.set(Uncertainty::multax, is_known ? nullptr : in_.because(Reasons::kMultax));
  if (!is_known) in_.count_unknown();
  multax_ = !is_off;
  if (!is_off) {
    locked_axis_.reset();
    return;
  }
  // No document states whether a TLAXIS outlives MULTAX/OFF.
  is_fixed_doubtful_ = is_tilted(fixed_axis_);
  if (in_.dialect.locks_axis) lock_axis();
}

// Locks the axis at that of the last position with five axes, if no TLAXIS follows. (Dassault, Syntax of Generated APT
// Instructions.)
void AxisState::lock_axis() {
  if (is_lock_lost_) {
    is_fixed_doubtful_ = true;
  } else if (last_axis_) {
    locked_axis_ = last_axis_;
    is_fixed_doubtful_ = is_tlaxis_new_ && is_tilted(*last_axis_, fixed_axis_);
  }
}

void AxisState::take_tlaxis() {
  if (!in_.has_numbers_alone(3)) {
    if (in_.path.moves.empty() && find_word_argument(in_.arguments) != nullptr)
      return in_.refuse_part_program("TLAXIS");
    return in_.fail("path-count", "TLAXIS has " + std::to_string(in_.arguments.size()) + " arguments; expected i,j,k");
  }
  const std::optional<Vec3> axis = read(0);
  if (!axis) return;
  fixed_axis_ = *axis;
  locked_axis_.reset();
  is_lock_lost_ = false;
  is_fixed_doubtful_ = is_modal_doubtful_ = false;
  is_last_tilted_ = false;
  is_tlaxis_new_ = has_tlaxis_ = true;
  if (in_.dialect.is_axis_modal) modal_axis_ = *axis;
}

void AxisState::note_position(const Vec3& axis_local) {
  if (in_.dialect.is_axis_modal) modal_axis_ = axis_local;
  is_tlaxis_new_ = false;
}

// Notes a change of the frame. No document states whether a locked axis turns with the frame.
void AxisState::note_frame(bool says_axis) {
  const bool is_lost = last_axis_ && !says_axis;
  if (locked_axis_) is_fixed_doubtful_ = is_lost;
  if (says_axis) is_last_tilted_ = false;
  locked_axis_.reset();
  last_axis_.reset();
  is_lock_lost_ = is_lost;
}

void AxisState::join(const AxisState& other) {
  const auto is_same = [](const std::optional<Vec3>& a, const std::optional<Vec3>& b) {
    return a.has_value() == b.has_value() && (!a || !is_tilted(*a, *b));
  };
  const bool is_order_same =
      is_tlaxis_new_ == other.is_tlaxis_new_ || !last_axis_ || !is_tilted(*last_axis_, fixed_axis_);
  is_lock_lost_ = is_lock_lost_ || other.is_lock_lost_ || !is_same(last_axis_, other.last_axis_) || !is_order_same;
  is_last_tilted_ = is_last_tilted_ || other.is_last_tilted_;
  is_fixed_doubtful_ = is_fixed_doubtful_ || other.is_fixed_doubtful_;
  is_modal_doubtful_ = is_modal_doubtful_ || other.is_modal_doubtful_ ||
                       (in_.dialect.is_axis_modal && !is_same(modal_axis_, other.modal_axis_));
}

bool AxisState::are_axes_unit() const {
  for (std::size_t i = 3; i < in_.arguments.size(); i += 6) {
    if (std::abs(in_.vector(i).norm() - 1) > Tolerance::kUnitVectorError) return false;
  }
  return true;
}

std::size_t AxisState::numbers_per_point() {
  const std::size_t count = in_.arguments.size();
  if (count == 3) return 3;
  if (in_.statement().has_axes) return 6;
  const bool is_list = in_.statement().word == Word::go_to && !in_.dialect.is_axis_modal;
  if (count == 6 || (is_list && count > 6 && count % 6 == 0)) {
    if (!is_list || is_multax_on()) return 6;
    if (in_.dialect.has_points_at_multax_off && multax_ == false) return 3;
    if (are_axes_unit()) return 6;
    // Two positions and a position with a wrong axis look alike. They are two positions only if MULTAX/OFF or the
    // dialect states it.
    return multax_.has_value() || in_.dialect.has_points_without_axis || count > 6 ? 3 : 6;
  }
  if (is_list && !is_multax_on() && count > 6 && count % 3 == 0) return 3;
  if (is_list && may_have_normals()) return 3;
  in_.fail("path-count",
           in_.major() + " has " + std::to_string(count) + " numbers; " + kPositionForm + in_.comma_hint());
  return 0;
}

// Returns why the numbers have two readings. If the second of two positions is at a distance of 1 from the origin, it
// looks like the axis of the first one. The file is ambiguous after MULTAX/OFF, and without MULTAX if its writers
// usually state MULTAX.
const char* AxisState::two_readings(std::size_t numbers) const {
  if (in_.statement().has_axes || in_.dialect.is_axis_modal) return nullptr;
  if (may_have_normals()) return Reasons::kNineNumbers;
  if (numbers != 6) return nullptr;
  return needs_multax() || (has_lists_ && !multax_) ? Reasons::kSixNumbers : nullptr;
}

// Returns whether the numbers may be a position, its axis and the normal of the surface, instead of three positions.
bool AxisState::may_have_normals() const {
  constexpr std::size_t kNumbers = 9;
  const std::size_t count = in_.arguments.size();
  if (count == 0 || count % kNumbers != 0 || in_.statement().is_decoded) return false;
  for (std::size_t i = 3; i < count; i += kNumbers) {
    if (std::abs(in_.vector(i).norm() - 1) > Tolerance::kUnitVectorError) return false;
  }
  return true;
}

std::pair<std::size_t, std::size_t> AxisState::note_list(std::size_t numbers) {
  const bool is_verdict_final = multax_.has_value() || in_.dialect.has_known_plain_axis || in_.dialect.is_axis_modal;
  if (is_verdict_final || in_.statement().is_decoded) return {0, 0};
  if (numbers == 6 && first_axis_ == kNone) first_axis_ = in_.moves();
  if (numbers != 3 || in_.arguments.size() <= numbers) return {0, 0};
  has_lists_ = true;
  return {std::min(std::exchange(first_axis_, kNone), in_.moves()), in_.moves()};
}

// Returns whether the axis of a position is uncertain. Without an axis after a tilted one, it may have that axis or the
// fixed one.
bool AxisState::is_doubtful(const Position& position) {
  if (is_fixed_doubtful_ && position.numbers == 6 && in_.dialect.is_axis_modal) is_fixed_doubtful_ = false;
  if (position.numbers == 6) is_modal_doubtful_ = false;
  if ((is_fixed_doubtful_ || is_modal_doubtful_) && position.numbers != 6) {
    plain_after_tilt_.add(in_.line());
    return true;
  }
  if (in_.dialect.is_axis_modal) return false;
  if (position.numbers == 6) {
    if (locked_axis_ && is_tilted(position.axis_local, *locked_axis_)) is_fixed_doubtful_ = true;
    last_axis_ = position.axis_local;
    is_lock_lost_ = false;
    // With a fixed axis, another vector after the position may be its axis or the normal of the surface. In a line of
    // NCI the code states which.
    if (has_tlaxis_ && !in_.statement().is_decoded && !is_multax_on() && is_tilted(position.axis_local, fixed_axis_))
      return true;
    is_last_tilted_ = is_tilted(position.axis_local, fixed_axis_);
    return false;
  }
  // After MULTAX/OFF the axis is known if the dialect defines it. In a dialect that writes axes only under MULTAX, it
  // is not known without MULTAX/OFF.
  const bool is_off = multax_ == false;
  const bool is_known = in_.dialect.has_known_plain_axis && (is_off || !in_.dialect.has_axes_under_multax);
  if (!is_last_tilted_ || is_known || locked_axis_) return false;
  plain_after_tilt_.add(in_.line());
  return true;
}

std::optional<Vec3> AxisState::read(std::size_t first) {
  const Vec3 axis = in_.vector(first);
  const double length = axis.norm();
  const double error = std::abs(length - 1);
  if (!(error <= Tolerance::kUnitVectorError)) {
    in_.fail("path-axis", in_.major() + ": the tool axis has length " + fixed_text(length, 6) +
                              "; expected a unit vector i,j,k (length 1 within 0.001)" +
                              (length > 1 ? in_.comma_hint() : ""));
    return std::nullopt;
  }
  if (error > Tolerance::kFileAxis) {
    ++renormalised_;
    if (error > std::abs(worst_length_ - 1)) worst_length_ = length;
  }
  return axis / length;
}

void AxisState::write_length_note() const {
  if (renormalised_ == 0) return;
  in_.path.notes.push_back(make_note("path-axis-length",
                                     count_text(renormalised_, "tool axis vector") + " not of length 1 (worst " +
                                         exact_text(worst_length_) + ") made so",
                                     in_.path.file));
}

void AxisState::write_plain_note() const {
  in_.report(Severity::warning, "path-plain-axis", plain_after_tilt_, "position",
             " of 3 numbers after one with a tilted axis: the file does not say which axis they have, so they are not "
             "checked");
}

}  // namespace gouge
