#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/units.h"
#include "lib/geom/pose.h"
#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/cldata/lexing/statement_at.h"

// Number format of a file, learned from the numbers it has, so that new ones look like their
// neighbours.

// GOTO statements as one file writes them: learned from the file, used to change its positions and to add new
// ones.

namespace gouge {

/// The style of one kind of number (coordinates, or axis components). Feed it tokens, then `choose_decimals`.
class NumberStyle {
 public:
  /// `field` is how many characters the number takes with the blanks before it.
  void learn(std::string_view token, std::size_t field);
  /// To be called once: no fewer than `min_decimals` are written; `usual_decimals` where nothing was
  /// learned.
  void choose_decimals(int min_decimals, int usual_decimals);

  /// Returns `value` as the file would write it.
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
[[nodiscard]] constexpr int min_coordinate_decimals(LengthUnit unit) { return unit == LengthUnit::inch ? 5 : 4; }

/// A position to write: the statement's own frame and unit. Without axis it is written with 3 numbers.
struct WrittenPosition {
  Vec3 tip = Vec3::Zero();
  std::optional<Vec3> axis;
};

class GotoText {
 public:
  /// Learns from the first GOTO statements of the file. `records` as read_motion_records gives them.
  GotoText(const Toolpath& path, const MotionRecords& records, OpenStatements open = &open_text);

  /// Returns the bytes of statement `index` with positions put in: `positions[k]` replaces the k-th where it has a
  /// value. Numbers that stay the same at the file's decimals keep their bytes. Requires a statement with number
  /// arguments, all positions of which have `numbers` numbers.
  [[nodiscard]] std::string replaced(std::size_t index, std::size_t numbers,
                                     const std::vector<std::optional<WrittenPosition>>& positions) const;

  /// Returns the bytes of statement `index` with `shifts[k]`, in the statement's own frame and unit, added to its k-th
  /// position. Requires and ensures as `replaced`; axes keep their bytes.
  [[nodiscard]] std::string shifted(std::size_t index, std::size_t numbers, const std::vector<Vec3>& shifts) const;

  /// Returns a GOTO statement of its own, line end included.
  [[nodiscard]] std::string fresh(const WrittenPosition& position) const;

  /// Returns `text` with the file's line end, if it has none.
  [[nodiscard]] std::string with_line_end(std::string text) const;

  [[nodiscard]] int coordinate_decimals() const { return coordinates_.decimals(); }
  [[nodiscard]] int axis_decimals() const { return components_.decimals(); }

  /// Returns true where both axes are written with the same digits.
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
