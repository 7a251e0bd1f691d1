#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "lib/base/units.h"

// The major words of CL data. Listed are those that change the meaning of a motion, and those known to have no effect
// on the place of the cutter. Every other word is `unknown`: kept in the file, counted and reported.

// Also the words for units of length, alone or within a feed.

namespace gouge {

enum class Word : std::uint8_t {
  comment,       // $$ ...
  unknown,       // counted and reported
  harmless,      // no effect on positions if its arguments are known: harmless_words.h
  free_text,     // PARTNO, REMARK, LETTER: text, not arguments
  pprint,        // text that names operations in some dialects
  insert,        // text that names tools in SolidWorks CAM
  tprint,        // text that names tools in CATIA
  operation,     // CSI_TOOL_PATH, OPNAME, OPFEATSTART: text that names an operation
  part_program,  // geometry and drive words of the APT source language
  curve,         // words after which the tool does not reach the next positions on straight lines
  arc_record,    // ARC of VERICUT: an arc that has its end
  arc_slope,     // ARCSLP: the rise of the next arc
  auxfun,        // an M of the control
  camera,
  circle,
  clear_plane,  // CLEARP
  csys,
  cntrl,
  copy,  // repeats the positions of INDEX
  cutcom,
  cutter,
  cycle,
  end_of_path,
  fedrat,
  fini,
  flute_length,
  extension_length,
  from,
  godlta,
  gohome,
  go_to,
  helical,  // a helix of CATIA that has its end
  index,    // begins or ends positions that COPY repeats
  indirv,
  knot,
  load,
  loadtl,
  mcs,
  mcsys,
  mode,
  movarc,
  movnrb,  // a NURBS of Creo
  msys,
  multax,
  nurbs,
  opskip,
  ppword,
  prefun,  // a G of the control
  rapid,
  retrct,
  rotabl,
  select,
  setup,
  syn,
  tldata,
  tlaxis,
  tlon,
  tool_path,
  toolno,
  trans,
  trntyp,
  turret,
  units,
  repeat,         // repeats motion, or calls it from another place
  unread_frame,   // may turn or shift later positions, in a way that is not read
  unread_motion,  // moves the tool, in a way that is not read
  unread_tool     // defines a tool, in a way that is not read
};

/// A set of words.
class WordSet {
 public:
  constexpr WordSet(std::initializer_list<Word> words) {
    for (const Word word : words) bits_[index(word)] |= bit(word);
  }
  [[nodiscard]] constexpr bool has(Word word) const { return (bits_[index(word)] & bit(word)) != 0; }

 private:
  static constexpr unsigned kBits = 64;
  static constexpr std::size_t index(Word word) { return static_cast<unsigned>(word) / kBits; }
  static constexpr std::uint64_t bit(Word word) { return std::uint64_t{1} << (static_cast<unsigned>(word) % kBits); }

  std::array<std::uint64_t, 2> bits_{};
};

/// Finds the first word of a statement, in upper or lower case.
[[nodiscard]] Word find_word(std::string_view major);

/// Returns whether a word moves the tool or changes the meaning of motion. A word that is missing here would be
/// overlooked.
[[nodiscard]] bool changes_motion(Word word);

/// Finds, for a statement with an unknown word, the known word that its beginning was probably meant to be. Else
/// returns `unknown`. (1) Text without a slash is joined to the word ("GOTO(0", "GODLTA-50.", "CUTTER=5"). (2) One
/// character is missing, wrong or too many ("GODLT", "CUTTTER"). (3) Two characters are swapped. Only words that change
/// motion are found.
[[nodiscard]] Word find_intended_word(std::string_view major);

/// Returns the word of a table that an unknown word of five or more letters was probably meant to be: one character is
/// missing, wrong or too many, or two are swapped ("FEDRATE" for FEDRAT). Empty: there is none.
[[nodiscard]] std::string_view similar_word(std::string_view major);

/// Returns the word with which `token` ends, such as CYCLE in "OFFCYCLE". It is one of the words that change motion and
/// have at least four letters.
[[nodiscard]] Word find_word_at_end(std::string_view token);

/// Returns whether a word occurs only after the beginning of a statement: OFF, FEDTO, MMPM. At the beginning of a line
/// it shows that the beginning of the statement is missing.
[[nodiscard]] bool is_minor_word(std::string_view word);

/// Returns the length of the free-text word of `line` (without leading blanks), or 0 if it has no such word. The rest
/// of such a line is always text. PARTNO, PPRINT and similar words need no delimiter after their six letters.
[[nodiscard]] std::size_t free_text_word_length(std::string_view line);

/// Returns the unit of MM, MMS, MILLIMETERS, INCH, INCHES, IN; nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_word(std::string_view word);

/// Returns the length unit of a feed word (MMPM, MMPR, IPM, IPR, FPM, FPR); nothing for other words.
[[nodiscard]] std::optional<LengthUnit> unit_of_feed_word(std::string_view word);

}  // namespace gouge
