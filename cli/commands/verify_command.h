#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "cli/job/claimed_result.h"
#include "cli/options/reading_options.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/verify/attack.h"
#include "lib/verify/certificate.h"
#include "lib/verify/outside_check.h"

namespace CLI {
class App;
}

namespace gouge {

struct VerifyArguments : Verbosity {
  std::string result_file, certificate_file;
  InputLimit input;
  std::string seconds;  ///< empty: a fixed number of samples
  std::string progress = "auto";
  std::uint32_t threads = 0;
};

void add_verify_options(CLI::App& command, VerifyArguments& arguments);

/// Runs `gougecheck verify`, which tests whether a result is correct. It shares no code with the check except the
/// readers of files. Returns the exit status: 0 verified, 1 refuted, 2 wrong command line, 3 unreadable, 4 not
/// everything is covered.
[[nodiscard]] int run_verify(const VerifyArguments& arguments, std::ostream& out, std::ostream& err);

/// Result of a verification.
struct Verification {
  struct Refuted {
    std::optional<std::size_t> move = {};  ///< none: the result as a whole
    std::optional<double> t = {};
    std::optional<Vec3> point = {};  ///< in mm
    std::string what = {};
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
};

/// Returns the exit status: 0, 1 or 4.
[[nodiscard]] int exit_status(const Verification& verification);

/// Returns a line for each refutation, then the verified, the sampled and the uncovered parts.
[[nodiscard]] std::string verification_text(const Verification& verification, const ClaimedResult& result,
                                            const Toolpath* path);

}  // namespace gouge
