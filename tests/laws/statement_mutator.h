#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "tests/support/scatter.h"

// Damages a toolpath the way editors, cards, transfers and posts do: a statement lost, written twice, cut
// short, parted, misplaced or contradicted, or a character that makes the difference lost or doubled. Numbers
// keep their digits.

namespace gouge::laws {

struct Mutant {
  std::string bytes;
  std::string what;      ///< the kind of damage and its line, for a person
  std::size_t kind = 0;  ///< below mutation_kinds()
};

[[nodiscard]] std::size_t mutation_kinds();
[[nodiscard]] std::string_view mutation_name(std::size_t kind);

/// One damage of the given kind at a place that `random` chooses; the bytes unchanged where there is no place
/// for it.
[[nodiscard]] Mutant mutate(const std::string& bytes, std::size_t kind, test::Scatter& random);

}  // namespace gouge::laws
