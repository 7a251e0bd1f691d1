#pragma once

#include <memory>
#include <vector>

#include "lib/verify/proof_subject.h"
#include "lib/verify/surface_proof.h"
#include "lib/verify/triangle_order.h"

namespace gouge {

/// The claims of a result about the surfaces of parts and fixtures. For each move they are pairs of a form of its tool and a
/// surface, with the allowed depth.
class SurfaceClaims final : public ProofSubject {
 public:
  /// All references must outlive it.
  SurfaceClaims(const ClaimedScene& scene, const SceneOrders& orders, const std::vector<MoveClaim>& claims);

  /// The lemma of a certificate is about depths, not distances: a move with a clearance of a single file has no proof.
  [[nodiscard]] bool is_askable(std::size_t move) const override;
  [[nodiscard]] bool is_alike(std::size_t a, std::size_t b) const override;
  [[nodiscard]] std::unique_ptr<ProofSearch> search() const override;
  [[nodiscard]] std::optional<ProofRefutation> refute(const ProofGroup& group) const override;

 private:
  struct Forms {
    explicit Forms(const ToolVariants& tool);
    ToolContour part, fixture, clearance;
    bool is_closed = false;
  };
  class Search;

  [[nodiscard]] std::vector<ProofQuestion> questions_of(std::size_t move) const;

  const ClaimedScene& scene_;
  const SceneOrders& orders_;
  const std::vector<MoveClaim>& claims_;
  std::vector<std::unique_ptr<Forms>> forms_;
};

}  // namespace gouge
