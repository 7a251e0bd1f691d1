#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "postproc/cldata/language/arguments.h"

// Words that are known to leave positions, frame, axis, compensation and tool alone, each with the arguments that are
// known for it. A statement is harmless only if its word is here and every argument fits: all else may mean anything.

namespace gouge {

struct HarmlessWord {
  /// Numbers that may be below 0: none, the only one, or any. Three in a row only where any may be.
  enum class Sign : std::uint8_t { none, one, any };
  enum class Others : std::uint8_t {
    none,      ///< only the words of `minors`
    names,     ///< names as well: up to kMaxNames words that no dialect knows
    required,  ///< only the words of `minors`, of which one must stand there
  };

  std::string_view word;
  std::string_view minors;  ///< words that may stand among its arguments, separated by blanks
  std::uint8_t max_numbers;
  Sign sign;
  Others others;
  std::string_view source;  ///< the documents that state what it means: docs/formats/harmless_words.md names them
};

inline constexpr std::size_t kMaxNames = 6;

/// Returns all of them, in alphabetical order.
[[nodiscard]] std::span<const HarmlessWord> harmless_words();

/// Returns the row of `word`, in any case, or null.
[[nodiscard]] const HarmlessWord* find_harmless_word(std::string_view word);

/// Returns true where `word`, in any case, stands in the table and `arguments` have a form that is known for it.
[[nodiscard]] bool is_harmless(std::string_view word, std::span<const Argument> arguments);

/// Returns true where an argument is the first word of a statement of its own: something was joined to the statement.
[[nodiscard]] bool hides_statement(std::span<const Argument> arguments);

}  // namespace gouge
