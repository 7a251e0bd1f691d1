#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lib/base/units.h"
#include "postproc/cldata/language/statement.h"

// How a file writes its numbers, learned from the numbers it has, so that new ones look like their
// neighbours.

namespace gouge {

/// The style of one kind of number (coordinates, or axis components). Feed it tokens, then `choose_decimals`.
class NumberStyle {
 public:
  /// `field` is how many characters the number takes with the blanks before it.
  void learn(std::string_view token, std::size_t field);
  /// To be called once: no fewer than `least_decimals` are written; `usual_decimals` where nothing was
  /// learned.
  void choose_decimals(int least_decimals, int usual_decimals);

  /// `value` as the file would write it.
  [[nodiscard]] std::string text(double value) const;
  /// Blanks to put before `token`, where `blanks` stood before the one it replaces.
  [[nodiscard]] std::string padding(std::string_view token, std::size_t blanks) const;
  [[nodiscard]] int decimals() const { return decimals_; }

 private:
  std::size_t count_ = 0;
  int decimals_ = 0;
  int fewest_decimals_ = 1000;
  std::size_t field_ = 0;
  bool is_aligned_ = true;
  bool has_varying_length_ = false;
  std::size_t first_length_ = 0;
  bool keeps_point_ = false;          ///< "25." for whole numbers
  bool drops_zero_ = false;           ///< ".5"
  bool keeps_negative_zero_ = false;  ///< "-0.5" although ".5"
};

/// Appends `bytes` from `copied` to the end of `argument`, which lies in them, with `value` in its place, and
/// moves `copied` there. A number that stays the same at the style's decimals keeps its bytes: then nothing
/// is appended yet.
void append_changed_number(std::string& text, std::size_t& copied, std::string_view bytes, const Argument& argument,
                           const NumberStyle& style, double value);

/// Decimals that keep a coordinate within 1e-4 mm.
[[nodiscard]] constexpr int least_coordinate_decimals(LengthUnit unit) { return unit == LengthUnit::inch ? 5 : 4; }

}  // namespace gouge
