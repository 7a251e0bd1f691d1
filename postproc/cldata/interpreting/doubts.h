#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace gouge {

/// What can make every position that follows one of nobody knows where; in the order in which reasons are reported.
enum class Doubt : std::uint8_t {
  ended,  ///< the program
  skip,   ///< the control may leave positions out
  block,
  matrix,
  turning,
  contour,
  tip,      ///< positions are another point of the tool than its tip
  unknown,  ///< a statement that is not understood, until a block of its own states all again
  adjust,
  spline,
  control_curve,  ///< in words of one control
  unread_frame,
  mcs,
  skew,  ///< the axes of the frame are no unit vectors at right angles
  csys,
  trans,
  origin,
  trntyp,
  mode,
  multax,
  cutter,   ///< no cutter since a statement that may have been one
  loading,  ///< no tool change since a statement that may have been one
  setup,
  machine_shift,
  work_offset,
  machine_cycle,
  machine_steps,
  clt_setup,
  count
};

/// The doubts in force: each with its reason, until the file says otherwise. One that the file never ends holds for all
/// positions that follow.
class Doubts {
 public:
  /// A reason of null ends the doubt.
  void set(Doubt doubt, const char* reason) {
    const auto place = static_cast<std::size_t>(doubt);
    reasons_[place] = reason;
    was_on_[place] = was_on_[place] || reason != nullptr;
  }
  void clear(Doubt doubt) { set(doubt, nullptr); }
  [[nodiscard]] bool has(Doubt doubt) const { return reasons_[static_cast<std::size_t>(doubt)] != nullptr; }
  /// True where it is in force or was before.
  [[nodiscard]] bool was_on(Doubt doubt) const { return was_on_[static_cast<std::size_t>(doubt)]; }
  /// True where that doubt is in force and no other.
  [[nodiscard]] bool is_alone(Doubt doubt) const {
    return has(doubt) && std::ranges::count_if(reasons_, [](const char* reason) { return reason != nullptr; }) == 1;
  }
  /// The reason to report, or null.
  [[nodiscard]] const char* reason() const {
    const auto* const first =
        std::find_if(reasons_.begin(), reasons_.end(), [](const char* reason) { return reason != nullptr; });
    return first == reasons_.end() ? nullptr : *first;
  }

  /// Of a doubt with an OFF of its own: the first move since it was last switched on or off. Now it is again.
  [[nodiscard]] std::size_t begin_run(Doubt doubt, std::size_t moves) {
    return std::exchange(run_begins_[static_cast<std::size_t>(doubt)], moves);
  }

 private:
  static constexpr auto kCount = static_cast<std::size_t>(Doubt::count);
  std::array<const char*, kCount> reasons_{};
  std::array<bool, kCount> was_on_{};
  std::array<std::size_t, kCount> run_begins_{};
};

}  // namespace gouge
