#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "postproc/gcode/language/control_table.h"
#include "postproc/gcode/language/gcode_block.h"

namespace gouge {

/// The codes of a control for fast access, and the words that the user states to be harmless.
class CodeIndex {
 public:
  CodeIndex(const ControlTable& control, const std::vector<std::string>& harmless_words);

  /// Returns the row of a G or M word; null: there is none.
  [[nodiscard]] const GcodeRow* row(const GcodeWord& word) const;
  [[nodiscard]] const ControlTable& control() const { return control_; }
  /// Returns whether the code that begins tool centre point control is of this group, so that others of it end it.
  [[nodiscard]] bool has_tip_control_of(ModalGroup group) const { return tip_control_group_ == group; }

 private:
  static constexpr std::size_t kG = 10000, kM = 10000;  // codes from 0 to G999.9 and M999.9
  /// Returns the row of a code that the user states to be harmless; null: it is none.
  [[nodiscard]] const GcodeRow* harmless_row(char letter, CodeNumber number) const;

  const ControlTable& control_;
  std::vector<const GcodeRow*> g_, m_;
  std::vector<GcodeRow> harmless_;
  ModalGroup tip_control_group_ = ModalGroup::none;
};

/// The words of a block by their letters, with the rows of its codes.
class BlockWords {
 public:
  /// Takes the words of a block. `modal`: the row of the motion in force, whose words are allowed too; may be null.
  /// Returns why the block is not understood; empty: every word has a place.
  [[nodiscard]] std::string take(const GcodeBlock& block, const CodeIndex& index, const GcodeRow* modal);

  [[nodiscard]] bool has(char letter) const { return (present_ >> bit(letter) & 1U) != 0; }
  [[nodiscard]] double value(char letter) const { return words_[bit(letter)]->value; }
  [[nodiscard]] const GcodeWord& word(char letter) const { return *words_[bit(letter)]; }
  [[nodiscard]] std::optional<int> integer(char letter) const;
  [[nodiscard]] bool has_any(std::string_view letters) const;
  [[nodiscard]] const std::vector<const GcodeRow*>& rows() const { return rows_; }
  /// Returns the row with a meaning; null: the block has none.
  [[nodiscard]] const GcodeRow* row_of(GcodeMeaning meaning) const;
  /// Returns the row of a group; null: the block has none.
  [[nodiscard]] const GcodeRow* row_of(ModalGroup group) const { return groups_[static_cast<std::size_t>(group)]; }
  /// Words that are axes here: not taken by a code, as X of G4 is.
  [[nodiscard]] bool has_axes() const { return axes_ != 0; }
  [[nodiscard]] bool is_axis(char letter) const { return (axes_ >> bit(letter) & 1U) != 0; }

 private:
  static constexpr std::size_t kGroups = 14;
  static unsigned bit(char letter) { return static_cast<unsigned>(letter - 'A'); }

  [[nodiscard]] std::string take_codes(const GcodeBlock& block, const CodeIndex& index);
  [[nodiscard]] std::string why_not_taken(const GcodeWord& word) const;

  std::array<const GcodeWord*, 26> words_{};
  std::uint32_t present_ = 0, axes_ = 0;
  std::vector<const GcodeRow*> rows_;
  std::array<const GcodeRow*, kGroups> groups_{};
};

/// Returns a code as programs write it: "G43.4".
[[nodiscard]] std::string code_text(char letter, CodeNumber number);

}  // namespace gouge
