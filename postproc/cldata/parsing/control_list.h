#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// Meanings of the words of a machine's control, each with the control and the document that state so. Text is harmless
// only if every one of its words is here: a word that is in no row may do anything. Where controls disagree, a word has
// all of its meanings, as a CL file does not state for which control it is.

namespace gouge {

enum class ControlMeaning : std::uint8_t {
  harmless,
  length,            ///< of the tool, in the control
  path,              ///< moves where axes stand in the block
  moves,             ///< moves
  shifts,            ///< shifts, turns, scales, mirrors or compensates what follows
  shifts_with_axes,  ///< does so where axes stand in the block
  begins_cycle,      ///< every position that follows runs a cycle
  ends_cycle,
  offset,  ///< chooses a work offset
  begins_steps,
  ends_steps,
  inch,
  mm,
  changes_tool,
  ends_program
};

struct ControlCode {
  char letter;      ///< G or M
  int first, last;  ///< ten times the number
  ControlMeaning meaning;
  std::string_view addresses;  ///< letters that belong to it beside N, S and F
  std::string_view source;
};

/// Returns the rows of G or M `number`: none where it is not known.
[[nodiscard]] std::vector<const ControlCode*> find_control_code(char letter, double number);

/// Arguments that a word of a control may have.
enum class ControlForm : std::uint8_t {
  alone,     ///< nothing
  values,    ///< brackets, or = and a value; behind them addresses
  message,   ///< text in brackets or quotes
  addresses  ///< a block of its own
};

struct ControlWord {
  std::string_view word;
  ControlForm form;
  std::string_view source;
};

/// Returns a word that does nothing in the form of its row, or null.
[[nodiscard]] const ControlWord* find_control_word(std::string_view word);

/// A whole block of a Heidenhain control.
struct ControlPhrase {
  static constexpr int kNoNumber = -1, kAnyNumber = -2;

  std::string_view first, second;  ///< the words that it begins with; `second` may be empty
  std::string_view rest;           ///< the words that may follow, separated by blanks
  int number;                      ///< that follows them, cut to a whole one; or one of the above
  ControlMeaning meaning;
};
[[nodiscard]] std::span<const ControlPhrase> control_phrases();

/// Returns true where `words`, separated by blanks, have `word`, in any case.
[[nodiscard]] bool is_among_words(std::string_view word, std::string_view words);

}  // namespace gouge
