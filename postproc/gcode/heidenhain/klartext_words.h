#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "postproc/gcode/heidenhain/q_parameters.h"

namespace gouge {

/// A word of a Klartext block: FMAX, DR-, X+12.5, TOOL CALL's name in quotation marks.
struct KlartextWord {
  enum class Kind : std::uint8_t { name, sign, number, text };
  std::string name;  ///< capitals; empty: a value without a name
  Kind kind = Kind::name;
  double value = 0;         ///< of a number; kUnknownValue: not established. Of a sign: 1 or -1
  std::string parameter{};  ///< the Q parameter that is the value; empty: a number
  std::string text{};       ///< between quotation marks

  [[nodiscard]] bool is(std::string_view other) const { return kind == Kind::name && name == other; }
  [[nodiscard]] bool has_number(std::string_view other) const { return kind == Kind::number && name == other; }
};

/// Reads the words of a text in capitals. Returns why the text is not understood; empty: it is.
[[nodiscard]] std::string read_klartext_words(std::string_view text, const QParameters& parameters,
                                              std::vector<KlartextWord>& words);

/// Returns a word as a program writes it, without its value.
[[nodiscard]] std::string word_text(const KlartextWord& word);

/// Returns the value of a word as a whole number. None: it is none.
[[nodiscard]] std::optional<int> whole_number(const KlartextWord& word);

}  // namespace gouge
