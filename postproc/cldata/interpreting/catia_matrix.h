#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "postproc/cldata/interpreting/frame_state.h"

namespace gouge {

/// The $$*CATIA0 of CATIA. The comments after it are a line with a name and three lines with the rows of a matrix,
/// absolute = R p + t. If the name is missing or looks like a row, four such lines cannot be distinguished from three.
/// A position before the last row is an error.
class CatiaMatrix {
 public:
  CatiaMatrix(StatementContext& in, FrameState& frame) : in_(in), frame_(frame) {}

  void begin();
  /// Notes a statement that is not a comment, and whether it needs the frame.
  void pass_statement(bool needs_frame);
  [[nodiscard]] bool expects_row() const { return row_ >= 0 || is_nameless_; }
  /// Takes the text of a comment that expects_row(). Returns the frame after the last row; else nothing.
  [[nodiscard]] std::optional<RigidTransform> take_row(std::string_view text);
  /// Returns whether the text is four numbers, which become the arguments of the statement.
  [[nodiscard]] bool is_row(std::string_view text);

 private:
  void fail();
  [[nodiscard]] std::optional<RigidTransform> finish();

  StatementContext& in_;
  FrameState& frame_;
  int row_ = -1;              // number of lines since $$*CATIA0; -1: none is expected
  bool is_nameless_ = false;  // the first line after it looks like a row
  std::array<double, 12> rows_{};
  double rounding_ = 0;  // rounding of the components of its axes
};

}  // namespace gouge
