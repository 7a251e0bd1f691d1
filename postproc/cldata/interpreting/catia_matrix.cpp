#include "postproc/cldata/interpreting/catia_matrix.h"

#include <algorithm>
#include <span>

#include "postproc/cldata/language/text.h"

namespace gouge {

bool CatiaMatrix::is_row(std::string_view text) {
  Statement row;
  row.pieces.push_back(text);
  split_arguments(row, in_.arguments);
  return in_.has_numbers_alone(4);
}

void CatiaMatrix::begin() {
  if (row_ >= 0) fail();
  row_ = 0;
  rounding_ = 0;
}

void CatiaMatrix::pass_statement(bool needs_frame) {
  if (row_ >= 0 && needs_frame) fail();
  is_nameless_ = is_nameless_ && row_ >= 0;
}

void CatiaMatrix::fail() {
  in_.fail(
      "path-frame",
      "$$*CATIA0 is not followed by the whole of its matrix; expected a line with a name and 3 lines of 4 numbers");
  row_ = -1;
  is_nameless_ = false;
}

std::optional<RigidTransform> CatiaMatrix::take_row(std::string_view text) {
  const bool is_numbers = is_row(text);
  if (row_ < 0) {
    is_nameless_ = false;
    if (is_numbers) fail();
    return std::nullopt;
  }
  if (row_++ == 0) {
    is_nameless_ = is_numbers;
    if (!is_numbers) return std::nullopt;
    ++row_;
  }
  if (!is_numbers) {
    row_ = -1;
    is_nameless_ = false;
    in_.fail("path-frame",
             "$$*CATIA0: " + quoted_text(text) + " is not a row of its matrix; expected 4 numbers in each of 3 lines");
    return std::nullopt;
  }
  const auto first = static_cast<std::size_t>(row_ - 2) * 4;
  for (std::size_t i = 0; i < 4; ++i) rows_[first + i] = *in_.arguments[i].number;
  const double rounding = rounding_of(std::span<const Argument>(in_.arguments).first(3));
  if (rounding > 0) rounding_ = rounding_ > 0 ? std::min(rounding_, rounding) : rounding;
  if (row_ != 4) return std::nullopt;
  row_ = -1;
  return finish();
}

std::optional<RigidTransform> CatiaMatrix::finish() {
  const auto column = [&](std::size_t c) { return Vec3(rows_[c], rows_[c + 4], rows_[c + 8]); };
  std::optional<RigidTransform> frame = frame_.make(column(3), column(0), column(1), column(2), rounding_, "$$*CATIA0");
  if (!frame || column(2).dot(frame->rotation.col(2)) >= 0) return frame;
  in_.fail("path-frame", "$$*CATIA0: the matrix mirrors; expected a right-handed axis system");
  return std::nullopt;
}

}  // namespace gouge
