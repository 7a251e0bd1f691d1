#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/verify/claims.h"
#include "lib/verify/proof_subject.h"
#include "lib/verify/stock_claims.h"
#include "lib/verify/triangle_order.h"

// Proofs of a result in a file: docs/formats/certificate.md.

namespace gouge {

/// The proofs of a section of a certificate.
struct SectionProofs {
  std::size_t proved = 0;               ///< number of moves with a proof
  std::vector<std::size_t> not_proved;  ///< moves that claim a bound but have no proof
};

struct MadeCertificate {
  std::string bytes;
  SectionProofs surfaces;  ///< about parts and fixtures
  SectionProofs stock;     ///< about remaining stock
};

/// Makes a proof for every clean, near and gouging move. One proof covers several moves if possible.
///
/// `stock` holds the claims about remaining stock; null: the result has none.
/// Requires `inputs`, the 64 SHA-256 digits of the inputs of the result. A reader compares them.
/// Ensures   The bytes are the same at any number of threads.
/// Cost      A few hundred microseconds for a move near the surface; a few milliseconds for a gouge, or beside stock.
[[nodiscard]] MadeCertificate make_certificate(const ClaimedScene& scene, const std::vector<MoveClaim>& claims,
                                               std::string_view inputs, const ProgressCall& progress,
                                               const StockClaims* stock = nullptr);

enum class ProofState : std::uint8_t {
  missing,  ///< the certificate does not mention the move
  open,     ///< it states that no proof was found
  proved,
  refuted,  ///< its steps do not prove the claim
};

struct CertificateReading {
  std::vector<ProofState> of_move;           ///< about parts and fixtures
  std::vector<ProofState> of_move_in_stock;  ///< empty: the result has no stock
  std::vector<ProofRefutation> refuted;
};

/// Verifies all proofs of a certificate. `orders` are the triangle orders of the scene.
/// Errors  certificate-invalid: the bytes are not a certificate, are incomplete or broken, or belong to other inputs or
///         another result. The message states the case.
/// Cost    Linear in the unpacked size; memory for a few thousand moves.
[[nodiscard]] Result<CertificateReading> verify_certificate(const ClaimedScene& scene, const SceneOrders& orders,
                                                            const std::vector<MoveClaim>& claims,
                                                            std::string_view inputs, const std::string& name,
                                                            std::string_view bytes, const ProgressCall& progress,
                                                            const StockClaims* stock = nullptr);

}  // namespace gouge
