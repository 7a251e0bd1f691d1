#pragma once

#include <span>
#include <string_view>

#include "postproc/cldata/parsing/control_list.h"
#include "postproc/cldata/parsing/machine_text.h"
#include "postproc/cldata/parsing/machine_tokens.h"

// Effects of the addresses of one block: codes and axes.

namespace gouge {

using MachineTokens = std::span<const MachineToken>;

/// Returns whether a token is one letter with its number.
[[nodiscard]] inline bool is_address(const MachineToken& token) {
  return token.letters.size() == 1 && token.number.has_value();
}

/// Returns whether a token is one of these letters with its number.
[[nodiscard]] bool is_address_of(const MachineToken& token, std::string_view letters);

/// Returns whether all tokens are letters with numbers; also IX+5, a step of Heidenhain.
[[nodiscard]] bool are_addresses(MachineTokens tokens);

/// Adds the effect of a meaning; `has_axes`: the block has numbers of axes.
void take_meaning(ControlMeaning meaning, MachineTokens tokens, bool has_axes, MachineEffect& effect);

/// Adds the effects of a block of addresses. Every code must be in the list, and every other address must be known or
/// belong to a code. Requires are_addresses().
void take_addresses(MachineTokens tokens, MachineEffect& effect);

/// Notes a distance by which the control may leave the path. The largest one counts.
void note_smoothing(double distance, MachineEffect& effect);

}  // namespace gouge
