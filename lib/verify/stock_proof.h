#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lib/verify/claimed_pieces.h"
#include "lib/verify/named_cut.h"
#include "lib/verify/proof_time.h"
#include "lib/verify/stock_space.h"
#include "lib/verify/surface_proof.h"

// The proof that no remaining stock is deeper in a body of the tool than a given depth during a motion. The space of the
// stock and the time are halved until each part is proved: by a plane (separation.h), beside the stock, or in a cutter at
// one earlier instant. docs/method/verify.md, "Remaining stock".

namespace gouge {

/// Steps besides those of ProofKind and the cuts of surface_proof.h. The numbers are those of docs/formats/certificate.md.
enum class StockStep : std::uint8_t {
  named_cut = 10,     ///< the block is in the cutter of the cut that follows, at one instant or between two
  same_cut = 11,      ///< in that of the cut that was named last
  beside_stock = 12,  ///< the block is outside of the stock
  cut_first = 13,     ///< cuts the block in the middle of its first arm; 14 and 15: of its second and third
  cut_third = 15,
  coaxial_cut = 16,  ///< what is deep in the body at the heights of the block is in the cutter of the cut that follows
  same_coaxial_cut = 17  ///< in that of the cut that was named last
};

/// Returns the byte of a step.
[[nodiscard]] constexpr char step_of(StockStep step) { return static_cast<char>(step); }
inline constexpr int kMaxNestedCuts = 160;

struct StockProofQuestion {
  const ToolContour& body;
  const CutPrograms& cuts;
  const StockSpace& stock;
  double depth_mm = 0, resolution_mm = 0;
  std::span<const MotionPiece> pieces;
  std::span<const PieceOfMove> of_piece;  ///< one for each piece

  /// Returns whether the statement is true without a proof.
  [[nodiscard]] bool is_empty() const;
  /// Returns the block that contains the stock, along the axis of the first pose and the way of the tip.
  [[nodiscard]] SpaceBlock whole_block() const;
  [[nodiscard]] ProofTime whole_time() const;
  [[nodiscard]] LatestInstant start_of(const ProofTime& time) const;
  [[nodiscard]] LatestInstant end_of(const ProofTime& time) const;
};

/// Follows a proof. Returns false if the proof is wrong or goes on after its end; `fault` states where. Requires
/// RoundsUpward, at least one piece. Cost: linear in the number of steps, for any content; O(n) for a step beside a stock
/// of n triangles.
[[nodiscard]] bool follow_stock_proof(const StockProofQuestion& question, std::string_view steps, ProofFault& fault);

}  // namespace gouge
