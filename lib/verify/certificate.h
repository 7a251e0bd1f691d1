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

/// A proof for every clean, near and gouging move, one for several moves where one will do.
///
/// `inputs`  the SHA-256 digits of what the result is about (64), which a reader compares.
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
  refuted,  ///< what it has proves nothing
};

struct CertificateReading {
  std::vector<ProofState> of_move;
  std::vector<ProofRefutation> refuted;
};

/// Proves anew what the certificate proves. `orders` are those of the scene.
/// Errors  certificate-invalid: it is no certificate, is cut short or broken, or belongs to other inputs or
///         another result; the message states which.
/// Cost    Linear in what it holds once it is unpacked; memory for some thousand moves of it.
[[nodiscard]] Result<CertificateReading> verify_certificate(const ClaimedScene& scene, const SceneOrders& orders,
                                                            const std::vector<MoveClaim>& claims,
                                                            std::string_view inputs, const std::string& name,
                                                            std::string_view bytes, const ProgressCall& progress);

}  // namespace gouge
