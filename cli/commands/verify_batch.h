#pragma once

#include <iosfwd>

#include "cli/commands/verify_command.h"

namespace gouge {

/// Runs `gougecheck verify` on the folder of a batch: verifies the result of each job with the certificate that the job
/// wrote, if it wrote one. `seconds` is the minimum duration of the sampling of each result. Returns the exit status of
/// the worst job, in the order 5, 2, 3, 1, 4, 0. A job without a result counts as 4.
[[nodiscard]] int run_verify_batch(const VerifyArguments& arguments, double seconds, std::ostream& out,
                                   std::ostream& err);

}  // namespace gouge
