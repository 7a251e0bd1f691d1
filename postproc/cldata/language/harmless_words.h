#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "postproc/cldata/language/arguments.h"

// Words that are known to have no effect on positions, frame, axis, compensation and tool, each with its known
// arguments. A statement is harmless only if its word is here and every argument fits. Any other statement may have any
// effect.

namespace gouge {

struct HarmlessWord {
  /// Numbers that may be negative: none, a single one, or any. Three numbers in a row are allowed only with `any`.
  enum class Sign : std::uint8_t { none, one, any };
  enum class Others : std::uint8_t {
    none,      ///< only the words of `minors`
    names,     ///< also names: up to kMaxNames words that no dialect knows
    required,  ///< only the words of `minors`, at least one of which is necessary
  };

  std::string_view word;
  std::string_view minors;  ///< words that may be among its arguments, separated by blanks
  std::uint8_t max_numbers;
  Sign sign;
  Others others;
  std::string_view source;  ///< the documents that state its meaning: docs/formats/harmless_words.md names them
};

inline constexpr std::size_t kMaxNames = 6;

/// Returns all harmless words, in alphabetical order.
[[nodiscard]] std::span<const HarmlessWord> harmless_words();

/// Returns the row of `word`, in upper or lower case, or null.
[[nodiscard]] const HarmlessWord* find_harmless_word(std::string_view word);

/// Returns whether `word`, in upper or lower case, is in the table and `arguments` have a form that is known for it.
[[nodiscard]] bool is_harmless(std::string_view word, std::span<const Argument> arguments);

/// Returns whether an argument is the first word of another statement, which was joined to this one.
[[nodiscard]] bool hides_statement(std::span<const Argument> arguments);

}  // namespace gouge
