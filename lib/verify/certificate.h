#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/verify/claims.h"
#include "lib/verify/triangle_order.h"

// Proofs of a result in a file: docs/formats/certificate.md.

namespace gouge {

struct MadeCertificate {
  std::string bytes;
  std::size_t proved = 0;               ///< moves it has a proof for
  std::vector<std::size_t> not_proved;  ///< moves that claim a bound for which none was found
};

/// Makes a proof for every clean, near and gouging move, one for several moves where one will do.
///
/// Requires `inputs`, the SHA-256 digits of the inputs of the result (64), which a reader compares.
/// Ensures   The same bytes at any number of threads.
/// Cost      Some hundred microseconds a move near the surface; a gouge, some milliseconds.
[[nodiscard]] MadeCertificate make_certificate(const ClaimedScene& scene, const std::vector<MoveClaim>& claims,
                                               std::string_view inputs, const ProgressCall& progress);

struct ProofRefutation {
  std::size_t move = 0;
  Vec3 point = Vec3::Zero();
  std::string what;
};

enum class ProofState : std::uint8_t {
  missing,  ///< the certificate does not mention the move
  open,     ///< it states that none was found
  proved,
  refuted,  ///< its content proves nothing
};

struct CertificateReading {
  std::vector<ProofState> of_move;
  std::vector<ProofRefutation> refuted;
};

/// Proves anew what the certificate proves. The `orders` are those of the scene.
/// Errors  The code certificate-invalid: it is not a certificate, is cut short or broken, or belongs to other inputs or
///         another result. The message states which.
/// Cost    Linear in its size once it is unpacked; memory for some thousand moves of it.
[[nodiscard]] Result<CertificateReading> verify_certificate(const ClaimedScene& scene, const SceneOrders& orders,
                                                            const std::vector<MoveClaim>& claims,
                                                            std::string_view inputs, const std::string& name,
                                                            std::string_view bytes, const ProgressCall& progress);

}  // namespace gouge
