#pragma once

#include <optional>
#include <string_view>

#include "cli/commands/verification.h"
#include "cli/commands/verify_command.h"

namespace gouge {

/// One result with its verification.
struct VerifiedResult {
  Diagnostics notes;  ///< about the inputs
  Diagnostics errors;
  ClaimedResult result;                      ///< valid only with a verification
  std::optional<Verification> verification;  ///< none: `errors` states why the result cannot be verified
};

/// Reads the inputs that a result names and verifies it. `file` is the name of the result, `bytes` is its content.
[[nodiscard]] VerifiedResult verify_result(const std::string& file, std::string_view bytes,
                                           const NamedCertificate& certificate, const VerifyArguments& arguments,
                                           double seconds, Progress& progress);

}  // namespace gouge
