#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lib/verify/proof_subject.h"
#include "lib/verify/stock_proof.h"

namespace gouge {

/// The depths that a result claims no remaining stock to exceed, one for each move; nothing: it claims none.
using StockDepths = std::vector<std::optional<double>>;

/// The claims of a result about remaining stock.
class StockClaims final : public ProofSubject {
 public:
  /// All references must outlive it. Cost: some microseconds for each move of each program.
  StockClaims(const ClaimedStock& stock, const StockDepths& depths);

  [[nodiscard]] double tolerance_mm() const { return stock_.tolerance_mm; }
  [[nodiscard]] double resolution_mm() const { return stock_.resolution_mm; }

  /// A proof is of one known motion of a solid of revolution: where heads move with the tool or several motions are
  /// permitted, no move has one.
  [[nodiscard]] bool is_askable(std::size_t move) const override;
  [[nodiscard]] bool is_alike(std::size_t a, std::size_t b) const override;
  [[nodiscard]] std::unique_ptr<ProofSearch> search() const override;
  [[nodiscard]] std::optional<ProofRefutation> refute(const ProofGroup& group) const override;

 private:
  class Search;

  [[nodiscard]] bool is_of_clear_move(std::size_t move) const;
  /// Returns the depth that a proof is about. It counts cutters as wider and the stock as smaller, so it is less than the
  /// claimed one.
  [[nodiscard]] double proved_depth_mm(std::size_t move) const;

  const ClaimedStock& stock_;
  const StockDepths& depths_;
  CutPrograms programs_;
  StockSpace space_;
};

}  // namespace gouge
