#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

// Meanings of the words of machine controls, each with the control and its document. Text is harmless only if every one
// of its words is here, because any other word may have any effect. If controls differ, a word has all of its meanings,
// because a CL file does not state its control.

namespace gouge {

enum class ControlMeaning : std::uint8_t {
  harmless,
  smooths,           ///< the control may leave the path, unless an address of the code or a value is 0
  blends,            ///< the control may leave the path, whatever the values
  plane,             ///< the plane of arcs and cycles
  centres_absolute,  ///< arc centres are points
  centres_from_start,
  level,      ///< the level to which cycles retract
  ends_tilt,  ///< ends a tilted plane
  ends_compensation,
  stops_spindle,     ///< at an angle
  turns_axes,        ///< the rotary joints run in proportion, not the tool axis on the great circle
  length,            ///< changes the tool length in the control
  path,              ///< moves if the block has axes
  moves,             ///< always moves
  shifts,            ///< shifts, turns, scales, mirrors or compensates later positions
  shifts_with_axes,  ///< does the same if the block has axes
  begins_cycle,      ///< every later position runs a cycle
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
  int first, last;  ///< ten times the number of the code
  ControlMeaning meaning;
  std::string_view addresses;  ///< letters that may accompany it, besides N, S and F
  std::string_view source;
};

/// Returns the rows of G or M `number`; none if it is unknown.
[[nodiscard]] std::vector<const ControlCode*> find_control_code(char letter, double number);

/// Arguments that a word of a control may have.
enum class ControlForm : std::uint8_t {
  alone,     ///< no arguments
  values,    ///< brackets, or = and a value; addresses may follow
  message,   ///< text in brackets or quotes
  addresses  ///< a block of addresses
};

struct ControlWord {
  std::string_view word;
  ControlForm form;
  std::string_view source;
  ControlMeaning meaning = ControlMeaning::harmless;  ///< or smooths, turns_axes, stops_spindle
};

/// Returns a word that moves and changes nothing, or null.
[[nodiscard]] const ControlWord* find_control_word(std::string_view word);

/// A whole block of a Heidenhain control.
struct ControlPhrase {
  static constexpr int kNoNumber = -1, kAnyNumber = -2;

  std::string_view first, second;  ///< the words with which it begins; `second` may be empty
  std::string_view rest;           ///< the words that may follow, separated by blanks
  int number;                      ///< the number after them, cut to an integer; or one of the constants above
  ControlMeaning meaning;
};
[[nodiscard]] std::span<const ControlPhrase> control_phrases();

/// Returns whether `words`, separated by blanks, contain `word`, in upper or lower case.
[[nodiscard]] bool is_among_words(std::string_view word, std::string_view words);

}  // namespace gouge
