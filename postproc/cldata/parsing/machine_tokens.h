#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "postproc/cldata/language/text.h"

namespace gouge {

/// A token of a block for a machine's control: "X-50." has letters and a number, "FMAX" only letters, "12" only a
/// number, "#" neither.
struct MachineToken {
  std::string_view letters;
  std::optional<double> number;
  bool is_glued = false;  ///< there is nothing between letters and number
  char other = '\0';
};

/// Returns the tokens of one block, without comments, blanks and quoted names.
[[nodiscard]] std::vector<MachineToken> machine_tokens(std::string_view text);

}  // namespace gouge
