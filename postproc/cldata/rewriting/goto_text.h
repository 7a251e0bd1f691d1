#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/geom/pose.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/lexing/statement_at.h"
#include "postproc/cldata/rewriting/number_style.h"

// GOTO statements as one file writes them: learned from the file, used to change its positions and to add new
// ones.

namespace gouge {

/// A position to write: the statement's own frame and unit. Without axis it is written with 3 numbers.
struct WrittenPosition {
  Vec3 tip = Vec3::Zero();
  std::optional<Vec3> axis;
};

class GotoText {
 public:
  /// Learns from the first GOTO statements of the file. `records` as read_motion_records gives them.
  GotoText(const Toolpath& path, const MotionRecords& records, OpenStatements open = &open_text);

  /// The bytes of statement `index` with positions put in: `positions[k]` replaces the k-th where it has a
  /// value. Numbers that stay the same at the file's decimals keep their bytes. Requires a statement with
  /// number arguments, all positions of which have `numbers` numbers.
  [[nodiscard]] std::string replaced(std::size_t index, std::size_t numbers,
                                     const std::vector<std::optional<WrittenPosition>>& positions) const;

  /// The bytes of statement `index` with `shifts[k]`, in the statement's own frame and unit, added to its
  /// k-th position. Requires and ensures as `replaced`; axes keep their bytes.
  [[nodiscard]] std::string shifted(std::size_t index, std::size_t numbers, const std::vector<Vec3>& shifts) const;

  /// A GOTO statement of its own, line end included.
  [[nodiscard]] std::string fresh(const WrittenPosition& position) const;

  /// `text` with the file's line end, if it has none.
  [[nodiscard]] std::string with_line_end(std::string text) const;

  [[nodiscard]] int coordinate_decimals() const { return coordinates_.decimals(); }
  [[nodiscard]] int axis_decimals() const { return components_.decimals(); }

  /// True where both axes are written with the same digits.
  [[nodiscard]] bool is_same_axis(const Vec3& a, const Vec3& b) const;

 private:
  void learn(const MotionRecord& record);
  void learn_holes(const MotionRecords& records);
  void append_number(std::string& text, const NumberStyle& style, double value) const;

  const Toolpath& path_;
  OpenStatements open_;
  NumberStyle coordinates_, components_;
  std::string prefix_ = "GOTO/";
  std::string separator_ = ",";
  std::size_t first_gap_ = 0, gap_ = 0;  // blanks before the first number and after a separator
  std::optional<std::size_t> axis_gap_;  // the same before a component of an axis
  bool has_form_ = false;
  std::string line_end_;
};

}  // namespace gouge
