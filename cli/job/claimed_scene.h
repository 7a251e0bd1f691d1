#pragma once

#include <string>
#include <vector>

#include "cli/job/job.h"
#include "cli/job/load_stock.h"
#include "lib/verify/certificate.h"
#include "lib/verify/claimed_stock.h"

// The input of a verification: a job and the result of its check.

namespace gouge {

/// Returns the scene of a job, which must outlive it.
[[nodiscard]] ClaimedScene claimed_scene(const Job& job);

/// Returns the stock of a job that was loaded with these arguments. All of them must outlive it.
[[nodiscard]] ClaimedStock claimed_stock(const Job& job, const JobArguments& arguments, const LoadedStock& stock);

[[nodiscard]] ClaimedState claimed_state(MoveState state);

/// Returns the claims about parts and fixtures. A move with a finding in remaining stock is clean of these.
[[nodiscard]] std::vector<MoveClaim> claims_of(const CheckResult& result);

/// Returns the depths that no remaining stock exceeds. A clean move claims tolerance + resolution, a finding its upper bound.
[[nodiscard]] StockDepths stock_depths_of(const CheckResult& result, const ClaimedStock& stock);

/// Returns the SHA-256 of the roles and checksums of all inputs, in their order, and of the set-up. A certificate holds
/// for inputs with this digest: docs/formats/certificate.md.
[[nodiscard]] std::string inputs_digest(const std::vector<InputFile>& inputs, const Job& job,
                                        const JobArguments& arguments);

/// Returns the warnings about moves without a proof.
[[nodiscard]] Diagnostics describe_unproved(const Job& job, const MadeCertificate& certificate);

}  // namespace gouge
