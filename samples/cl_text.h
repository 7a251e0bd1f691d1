#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "lib/geom/pose.h"

// A writer of cutter-location text that remembers the line of each position.

namespace gouge::samples {

class ClText {
 public:
  enum class Form {
    apt,      ///< "GOTO/ 1.00000, 2.00000, 3.00000, 0.0000000, ...", always with the axis
    apt_xyz,  ///< three numbers; the axis is +Z
    nx        ///< "GOTO/1.0000,2.0000,...", with the axis only if it changes
  };

  /// Begins an empty text. `to_block` maps part coordinates to the coordinates that are written (the inverse of an
  /// MSYS).
  explicit ClText(Form form, const RigidTransform& to_block = {}) : form_(form), to_block_(to_block) {}

  void line(std::string_view text);

  /// Writes a position (a rapid one after RAPID). Returns the line of its GOTO.
  std::size_t feed(const Pose& pose);
  std::size_t rapid(const Pose& pose);

  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] std::size_t positions() const { return positions_; }

 private:
  Form form_;
  RigidTransform to_block_;
  std::string text_;
  std::string last_axis_;
  std::size_t lines_ = 0;
  std::size_t positions_ = 0;
};

}  // namespace gouge::samples
