#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace gouge {

/// Reasons why all following positions are uncertain, in the order in which they are reported.
enum class Uncertainty : std::uint8_t {
  ended,  ///< the program has ended
  skip,   ///< the control may skip positions
  block,
  matrix,
  turning,
  contour,
  tip,      ///< positions are those of another point of the tool than its tip
  unknown,  ///< a statement is not understood; holds until a block states all facts again
  adjust,
  spline,
  control_curve,  ///< a curve in words of one control
  unread_frame,
  mcs,
  skew,  ///< the axes of the frame are not unit vectors at right angles
  csys,
  trans,
  origin,
  trntyp,
  mode,
  multax,
  cutter,   ///< a statement may have been a CUTTER, and none has followed
  loading,  ///< a statement may have been a tool change, and none has followed
  setup,
  machine_shift,
  work_offset,
  machine_cycle,
  machine_steps,
  clt_setup,
  count
};

/// The uncertainties in force, each with its reason, until the file states otherwise. One that the file never ends
/// holds for all positions that follow.
class Uncertainties {
 public:
  /// Sets the reason of an uncertainty; null ends it.
  void set(Uncertainty uncertainty, const char* reason) {
    const auto place = static_cast<std::size_t>(uncertainty);
    reasons_[place] = reason;
    was_on_[place] = was_on_[place] || reason != nullptr;
  }
  void clear(Uncertainty uncertainty) { set(uncertainty, nullptr); }
  [[nodiscard]] bool has(Uncertainty uncertainty) const {
    return reasons_[static_cast<std::size_t>(uncertainty)] != nullptr;
  }
  /// Returns whether it is in force or was before.
  [[nodiscard]] bool was_on(Uncertainty uncertainty) const { return was_on_[static_cast<std::size_t>(uncertainty)]; }
  /// Returns whether this uncertainty is in force and no other.
  [[nodiscard]] bool is_alone(Uncertainty uncertainty) const {
    return has(uncertainty) &&
           std::ranges::count_if(reasons_, [](const char* reason) { return reason != nullptr; }) == 1;
  }
  /// Returns whether all uncertainties except `except` are those of `other`.
  [[nodiscard]] bool is_same(const Uncertainties& other, Uncertainty except) const {
    std::array<const char*, kCount> own = reasons_;
    own[static_cast<std::size_t>(except)] = other.reasons_[static_cast<std::size_t>(except)];
    return own == other.reasons_;
  }
  /// Returns the reason to report, or null.
  [[nodiscard]] const char* reason() const {
    const auto* const first =
        std::find_if(reasons_.begin(), reasons_.end(), [](const char* reason) { return reason != nullptr; });
    return first == reasons_.end() ? nullptr : *first;
  }

  /// Returns the first move since an uncertainty with its own OFF was last switched, and begins a new run at `moves`.
  [[nodiscard]] std::size_t begin_run(Uncertainty uncertainty, std::size_t moves) {
    return std::exchange(run_begins_[static_cast<std::size_t>(uncertainty)], moves);
  }

 private:
  static constexpr auto kCount = static_cast<std::size_t>(Uncertainty::count);
  std::array<const char*, kCount> reasons_{};
  std::array<bool, kCount> was_on_{};
  std::array<std::size_t, kCount> run_begins_{};
};

}  // namespace gouge
