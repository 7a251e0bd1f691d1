#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lib/certify/settle_stock.h"
#include "lib/check/verdict.h"
#include "lib/motion/motion.h"

namespace gouge {

struct CheckSetup;

/// The place of a question about stock: the tool, and the cuts that were made before.
struct StockPlace {
  std::size_t tool = kNone;  ///< index into Toolpath::tools
  std::size_t before = 0;    ///< only moves before this one, of the path with the cuts, removed material
  bool is_whole = false;     ///< the cutter must not meet stock either
  bool is_brief = false;     ///< the examination ends after few pieces, for searches over many motions
  bool keeps_room = false;   ///< the whole tool must keep a distance (StockSetup::roomy_mm)
};

/// The material that is left before each move of a path, for searches that try other motions in place of a move.
///
/// A motion that it calls clear has no stock deeper than four fifths of the tolerance + resolution: the rest is a margin
/// for the digits of a file. It gives no credit for what the motion itself cuts, so a cut that is clear may not be
/// called clear. It proves nothing about a path: the check of the whole path decides.
class StockAtMoves {
 public:
  /// Takes the cuts from `path`. `first[i]` is the first of its moves that replaced move i of the path in question, and
  /// the last entry is their number. `meets_stock` marks the moves that are known to meet stock. `setup` must outlive
  /// this, and has a stock.
  StockAtMoves(std::shared_ptr<const Toolpath> path, std::vector<std::size_t> first, std::vector<bool> meets_stock,
               const CheckSetup& setup);
  ~StockAtMoves() = default;
  StockAtMoves(const StockAtMoves&) = delete;
  StockAtMoves& operator=(const StockAtMoves&) = delete;

  /// Returns the place of move i, or, if `is_after`, the same tool after the move's own cut.
  [[nodiscard]] StockPlace place_of(std::size_t i, bool is_after) const;
  [[nodiscard]] bool meets_stock(std::size_t i) const { return meets_stock_[i]; }
  [[nodiscard]] const CutHistory& cuts() const { return history_.of_path(); }

  /// Returns `free`, the verdict about part and fixtures, or the one about stock if that is not clear. `examined` grows
  /// by the number of pieces. `is_depth_wanted` narrows the bounds of the depth.
  [[nodiscard]] MoveVerdict check(const Motion& motion, const StockPlace& place, const MoveVerdict& free,
                                  bool is_depth_wanted, std::uint64_t& examined) const;

  /// Returns a distance that the tool must at least move to leave the stock at a pose, up to the resolution; 0: it is
  /// clear.
  [[nodiscard]] double excess_mm(const Pose& pose, const StockPlace& place, std::uint64_t& examined) const;

  /// Returns the lift along the tool axis that takes the tool, with its room, above all stock.
  [[nodiscard]] double lift_over_mm(const Pose& pose, const StockPlace& place) const;
  /// Returns the length of the diagonal of the box about the stock.
  [[nodiscard]] double size_mm() const;

 private:
  [[nodiscard]] const CompiledTool* body_of(const StockPlace& place) const;
  /// Returns the questions about all bodies that must be clear at a place.
  [[nodiscard]] std::vector<StockQuestion> questions(const StockPlace& place) const;
  /// Returns a verdict other than clean; nothing: the body of the question is clear.
  [[nodiscard]] std::optional<MoveVerdict> find_stock_in(const StockQuestion& about, std::size_t tool,
                                                         const Motion& motion, bool is_depth_wanted,
                                                         std::uint64_t& examined) const;
  [[nodiscard]] double excess_mm(const StockQuestion& about, const Motion& rest, std::uint64_t& examined) const;

  const StockSetup& stock_;
  const MotionLaw& law_;
  StockOptions options_;
  std::shared_ptr<const Toolpath> path_;
  std::vector<std::size_t> first_;
  std::vector<bool> meets_stock_;
  StockHistory history_;
  std::vector<StockHead> roomy_heads_;  // wider in all directions; empty: none are asked for
};

}  // namespace gouge
