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

// Number format of a file, learned from its numbers, so that new ones look like their neighbours.

// Also GOTO statements in the style of a file. They are learned from the file, and used to change its positions and to
// add new ones.

namespace gouge {

/// The style of one kind of number (coordinates, or axis components). `learn` is called for its tokens, then
/// `choose_decimals`.
class NumberStyle {
 public:
  /// Learns a number. `field` is the number of its characters, with the blanks before it.
  void learn(std::string_view token, std::size_t field);
  /// Chooses the decimals: at least `min_decimals`, or `usual_decimals` if nothing was learned. Must be called once.
  void choose_decimals(int min_decimals, int usual_decimals);

  /// Returns `value` in the style of the file.
  [[nodiscard]] std::string text(double value) const;
  /// Returns the blanks before `token`, which replaces a number after `blanks` blanks.
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
  bool keeps_point_ = false;          ///< integers are written as "25."
  bool drops_zero_ = false;           ///< ".5"
  bool keeps_negative_zero_ = false;  ///< "-0.5" is written although ".5" is
};

/// Appends `bytes` from `copied` to the end of `argument`, which lies in them, with `value` in its place. Moves
/// `copied` to that end. A number that is equal at the decimals of the style keeps its bytes; then nothing is appended
/// yet.
void append_changed_number(std::string& text, std::size_t& copied, std::string_view bytes, const Argument& argument,
                           const NumberStyle& style, double value);

/// Returns the number of decimals that keeps a coordinate within 1e-4 mm.
[[nodiscard]] constexpr int min_coordinate_decimals(LengthUnit unit) { return unit == LengthUnit::inch ? 5 : 4; }

/// A position to write, in the frame and unit of its statement. Without an axis it is written with 3 numbers.
struct WrittenPosition {
  Vec3 tip = Vec3::Zero();
  std::optional<Vec3> axis;
};

class GotoText {
 public:
  /// Learns the style from the first GOTO statements of the file. `records` are those of read_motion_records.
  GotoText(const Toolpath& path, const MotionRecords& records, OpenStatements open = &open_text);

  /// Returns the bytes of statement `index` with new positions: `positions[k]` replaces the k-th one if it has a value.
  /// Numbers that are equal at the file's decimals keep their bytes. Requires a statement with number arguments, all
  /// positions of which have `numbers` numbers.
  [[nodiscard]] std::string replaced(std::size_t index, std::size_t numbers,
                                     const std::vector<std::optional<WrittenPosition>>& positions) const;

  /// Returns the bytes of statement `index` with `shifts[k]`, in the frame and unit of the statement, added to its k-th
  /// position. The requirements and guarantees are those of `replaced`; axes keep their bytes.
  [[nodiscard]] std::string shifted(std::size_t index, std::size_t numbers, const std::vector<Vec3>& shifts) const;

  /// Returns a new GOTO statement with its line end.
  [[nodiscard]] std::string fresh(const WrittenPosition& position) const;

  /// Returns `text` with the line end of the file, if it has none.
  [[nodiscard]] std::string with_line_end(std::string text) const;

  [[nodiscard]] int coordinate_decimals() const { return coordinates_.decimals(); }
  [[nodiscard]] int axis_decimals() const { return components_.decimals(); }

  /// Returns whether both axes have the same digits in the file.
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
  std::size_t first_gap_ = 0, gap_ = 0;  // numbers of blanks before the first number and after a separator
  std::optional<std::size_t> axis_gap_;  // number of blanks before a component of an axis
  bool has_form_ = false;
  std::string line_end_;
};

}  // namespace gouge
