#pragma once

#include <string>

#include "cli/commands/verification.h"

namespace gouge {

/// Returns a line for each refutation, then the verified, the sampled and the uncovered parts.
[[nodiscard]] std::string verification_text(const Verification& verification, const ClaimedResult& result);

}  // namespace gouge
