#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/laws/loose_statements.h"

// Which words of a toolpath show the mutation law's reader what moves, and which leave the cutter where it
// is.

namespace gouge::laws {

/// A motion, or what changes the meaning of one: cycle, compensation, axis, frame, unit, tool, block.
[[nodiscard]] bool is_meaningful(std::string_view word);

/// Known to leave the cutter and the meaning of positions as they are.
[[nodiscard]] bool is_passive(std::string_view word);

/// Accepts an empty list.
[[nodiscard]] bool is_all_numbers(const std::vector<LooseArgument>& arguments);

/// The text after its slash is a name or free text.
[[nodiscard]] bool is_naming(std::string_view word);

/// One letter added, lost, changed, or two of them the wrong way round; or the same.
[[nodiscard]] bool is_one_letter_away(std::string_view a, std::string_view b);

/// The meaningful word that stands somewhere in `text`; empty: none.
[[nodiscard]] std::string_view meaning_within(std::string_view text);

/// Without the slash: the meaningful word that `text` begins with, where a blank or a number follows it.
[[nodiscard]] std::string_view meaning_before_blank(std::string_view text);

}  // namespace gouge::laws
