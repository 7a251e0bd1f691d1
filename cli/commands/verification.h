#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/job/claimed_result.h"
#include "cli/job/expected_record.h"
#include "cli/job/job.h"
#include "cli/terminal/progress.h"
#include "lib/base/result.h"
#include "lib/verify/attack.h"
#include "lib/verify/certificate.h"
#include "lib/verify/outside_check.h"

namespace gouge {

/// Result of a verification.
struct Verification {
  struct Refuted {
    std::optional<std::size_t> move = {};  ///< none: the result as a whole
    std::optional<double> t = {};
    std::optional<Vec3> point = {};  ///< in mm
    std::string what = {};
    std::optional<std::size_t> line = {};  ///< line of the move in the toolpath; none: the toolpath has no such move
  };
  std::vector<Refuted> refuted;
  std::size_t witnesses = 0;  ///< number of recomputed witnesses
  bool has_certificate = false;
  std::size_t proved_clean = 0, proved_gouges = 0;    ///< numbers of moves whose bound is proved
  std::size_t sampled_clean = 0, sampled_gouges = 0;  ///< numbers of moves whose bound is only sampled
  std::vector<std::size_t> without_proof;             ///< clean moves for which the certificate has no proof
  std::size_t uncovered = 0;                          ///< number of moves without a claim that could be verified
  OutsideCheck outside;
  AttackResult attack;
  std::size_t stock_witnesses = 0;  ///< number of recomputed witnesses in remaining stock
  std::size_t proved_stock = 0,
              sampled_stock = 0;                 ///< numbers of moves whose bound in remaining stock is proved, sampled
  std::vector<std::size_t> without_stock_proof;  ///< moves for which the certificate has no proof about the stock
  std::optional<AttackResult> stock;             ///< none: the check had no stock
  bool has_excess = false;                       ///< the result states material left on the parts
  bool has_heads = false;
  bool is_placement_open = false;  ///< whether path and part fit depends on clean moves, which the result does not list
};

/// The certificate of a result. Both texts must outlive the verification.
struct NamedCertificate {
  std::string_view name;  ///< empty: there is none
  std::string_view bytes;
};

/// Verifies the claims of a result whose inputs are unchanged. `seconds` is the minimum duration of the sampling; 0: a
/// fixed number of samples. Errors: certificate-invalid.
[[nodiscard]] Result<Verification> verify_claims(const Job& job, const BesideJob& beside, const ClaimedResult& result,
                                                 const NamedCertificate& certificate, double seconds,
                                                 Progress& progress);

/// Returns the exit status: 0, 1 or 4.
[[nodiscard]] int exit_status(const Verification& verification);

}  // namespace gouge
