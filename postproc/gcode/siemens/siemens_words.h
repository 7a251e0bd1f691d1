#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/letters.h"
#include "postproc/gcode/siemens/siemens_block.h"
#include "postproc/gcode/siemens/siemens_table.h"

namespace gouge {

/// The words of one block with their rows. Only words of the table, and values that one of them takes, are accepted.
class SiemensWords {
 public:
  struct Code {
    const SiemensRow* row;
    const SiemensWord* word;
  };

  /// Takes the words of a block, which must outlive their use. Returns why they are not understood; empty: they are.
  /// `harmless`: names that the user states to be without effect.
  [[nodiscard]] std::string take(const SiemensBlock& block, const std::vector<std::string>& harmless);

  [[nodiscard]] const std::vector<Code>& codes() const { return codes_; }
  [[nodiscard]] const Code* code(SiemensMeaning meaning) const;
  [[nodiscard]] const Code* code_of(SiemensGroup group) const;
  /// Returns the word with a value by its address; null: the block has none.
  [[nodiscard]] const SiemensWord* value(std::string_view address) const {
    if (is_letter(address)) return letters_.has(address[0]) ? by_letter_.at(index_of(address[0])) : nullptr;
    return long_values_.empty() ? nullptr : find_long_value(address);
  }
  [[nodiscard]] bool has_any(std::initializer_list<std::string_view> addresses) const;
  [[nodiscard]] bool has_path_axes() const { return has_any({"X", "Y", "Z"}); }
  [[nodiscard]] bool has_axes() const;
  [[nodiscard]] bool has_arc_words() const;
  /// Name of the program that the block calls; empty: it calls none.
  [[nodiscard]] const std::string& called() const { return called_; }

 private:
  [[nodiscard]] static bool is_letter(std::string_view address) {
    return address.size() == 1 && is_capital(address[0]);
  }
  [[nodiscard]] static std::size_t index_of(char letter) { return static_cast<std::size_t>(letter - 'A'); }
  [[nodiscard]] const SiemensWord* find_long_value(std::string_view address) const;
  [[nodiscard]] std::string take_code(const SiemensWord& word, const SiemensRow& row);
  [[nodiscard]] std::string take_value(const SiemensWord& word);
  [[nodiscard]] std::string find_conflict() const;

  std::vector<Code> codes_;
  CapitalSet letters_;                                 // addresses of one letter that have a value
  std::array<const SiemensWord*, 26> by_letter_ = {};  // of letters_; others are of earlier blocks
  std::vector<const SiemensWord*> long_values_;        // of longer addresses
  std::string called_;
};

}  // namespace gouge
