#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "lib/verify/certificate_text.h"
#include "lib/verify/claims.h"

namespace gouge {

struct ProofRefutation {
  std::size_t move = 0;
  Vec3 point = Vec3::Zero();
  std::string what;
};

/// Finds proofs one after the other. It may use what it found before.
class ProofSearch {
 public:
  virtual ~ProofSearch() = default;
  /// Appends the steps that prove the claims of some moves. Returns false if it finds no proof; `steps` may then have
  /// changed. Requires moves that are askable and alike, RoundsUpward.
  [[nodiscard]] virtual bool find(std::size_t first, std::size_t count, std::string& steps) = 0;
};

/// The claims that one section of a certificate proves.
class ProofSubject {
 public:
  virtual ~ProofSubject() = default;

  /// Returns whether a proof for this move is possible.
  [[nodiscard]] virtual bool is_askable(std::size_t move) const = 0;
  /// Returns whether one proof can cover both moves.
  [[nodiscard]] virtual bool is_alike(std::size_t a, std::size_t b) const = 0;
  [[nodiscard]] virtual std::unique_ptr<ProofSearch> search() const = 0;
  /// Returns the reason why a group does not prove the claims of its moves; nothing if it proves them. Requires moves that
  /// are askable and alike, RoundsUpward.
  [[nodiscard]] virtual std::optional<ProofRefutation> refute(const ProofGroup& group) const = 0;
};

}  // namespace gouge
