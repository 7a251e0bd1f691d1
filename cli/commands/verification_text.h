#pragma once

#include <string>
#include <vector>

#include "cli/commands/verification.h"

namespace gouge {

/// Returns a line for each refutation, then the verified, the sampled and the uncovered parts.
[[nodiscard]] std::string verification_text(const Verification& verification, const ClaimedResult& result);

/// Returns the line of each refutation, without a line end.
[[nodiscard]] std::vector<std::string> refutation_lines(const Verification& verification, const ClaimedResult& result);
/// Returns the claims that are only sampled, as the rest of a sentence.
[[nodiscard]] std::vector<std::string> sampled_parts(const Verification& verification);
/// Returns the claims that are not covered, as the rest of a sentence.
[[nodiscard]] std::vector<std::string> uncovered_parts(const Verification& verification);
/// Returns the line with the claims that no verification covers.
[[nodiscard]] const char* not_part_of_a_verification();

/// Returns whether every claim about a depth is proved. Requires the exit status 0.
[[nodiscard]] bool is_all_proved(const Verification& verification);

}  // namespace gouge
