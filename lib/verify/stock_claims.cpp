#include "lib/verify/stock_claims.h"

#include <cmath>

#include "lib/verify/claimed_pieces.h"
#include "lib/verify/find_stock_proof.h"

namespace gouge {

namespace {

constexpr std::uint64_t kStockTriesPerMove = 1'000, kStockTriesAlone = 30'000;
constexpr double kSame_mm = 1e-9;

}  // namespace

StockClaims::StockClaims(const ClaimedStock& stock, const StockDepths& depths)
    : stock_(stock), depths_(depths), programs_(stock.programs), space_(stock) {}

bool StockClaims::is_askable(std::size_t move) const {
  if (stock_.is_motion_open || !stock_.heads.empty() || !depths_[move]) return false;
  const ProgramCuts& program = programs_.last();
  return program.is_known(move) && program.body_of(move).is_closed();
}

bool StockClaims::is_alike(std::size_t a, std::size_t b) const {
  const ProgramCuts& program = programs_.last();
  return is_of_clear_move(a) && is_of_clear_move(b) && program.path().moves[a].tool == program.path().moves[b].tool &&
         program.cuts(a) == program.cuts(b);
}

bool StockClaims::is_of_clear_move(std::size_t move) const {
  return std::abs(*depths_[move] - stock_.largest_clear_mm()) <= kSame_mm;
}

// A claim that the body is not wider than it is needs no proof.
double StockClaims::proved_depth_mm(std::size_t move) const {
  const double claimed_mm = *depths_[move];
  if (is_of_clear_move(move) || claimed_mm >= programs_.last().body_of(move).largest_radius_mm()) return claimed_mm;
  return claimed_mm - stock_.beyond_proof_mm();
}

class StockClaims::Search final : public ProofSearch {
 public:
  explicit Search(const StockClaims& claims) : claims_(claims), cuts_(claims.programs_, claims.stock_.resolution_mm) {}

  bool find(std::size_t first, std::size_t count, std::string& steps) override {
    const auto pieces = pieces_of_moves(claims_.programs_.last().scene(), first, count);
    if (!pieces) return false;
    const std::uint64_t tries = count > 1 ? kStockTriesPerMove * count : kStockTriesAlone;
    return find_stock_proof(
        {claims_.programs_.last().body_of(first), claims_.programs_, claims_.space_, claims_.proved_depth_mm(first),
         claims_.stock_.resolution_mm, pieces->motion, pieces->of_piece},
        cuts_, tries, steps);
  }

 private:
  const StockClaims& claims_;
  CutSearch cuts_;
};

std::unique_ptr<ProofSearch> StockClaims::search() const { return std::make_unique<Search>(*this); }

std::optional<ProofRefutation> StockClaims::refute(const ProofGroup& group) const {
  const auto pieces = pieces_of_moves(programs_.last().scene(), group.first, group.count);
  if (!pieces) return ProofRefutation{group.first, Vec3::Zero(), "its motion is not defined"};
  ProofFault fault;
  if (follow_stock_proof({programs_.last().body_of(group.first), programs_, space_, proved_depth_mm(group.first),
                          stock_.resolution_mm, pieces->motion, pieces->of_piece},
                         group.steps, fault))
    return std::nullopt;
  return ProofRefutation{pieces->of_piece[fault.piece].move, fault.point, fault.what};
}

}  // namespace gouge
