#pragma once

#include <memory>
#include <vector>

#include "lib/certify/stock_at_moves.h"
#include "lib/correct/correct_path.h"
#include "lib/correct/laws.h"

namespace gouge {

/// The rules of a correction about remaining stock, and the material that its search examines.
///
/// A move that was clear of stock stays clear. One that meets stock comes no deeper into it, and does not become
/// uncertain. One that was not certified may prove to meet stock, unless it is a changed rapid: an earlier correction can
/// make that known. A rapid in place of a feed is clear of stock. All states are those of a whole path with the material
/// that its own moves leave.
class StockLaws {
 public:
  /// Checks the path against its stock. `result` is that of its check without stock. All objects must outlive this.
  StockLaws(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const ProgressCall& progress);

  /// Returns the result of the path with the findings in stock.
  [[nodiscard]] const CheckResult& before() const { return before_; }
  /// Returns the same with those that `seek` added.
  [[nodiscard]] const CheckResult& sought() const { return sought_; }
  /// Returns the material before each move, as the path of the last `seek` leaves it; at first, the path itself.
  [[nodiscard]] std::shared_ptr<const StockAtMoves> material() const { return material_; }

  /// The result for a corrected path.
  struct Examined {
    CheckResult result;               ///< with the findings in stock
    std::vector<std::size_t> sought;  ///< moves of the original path that meet stock, though no search for a way failed
    std::vector<MoveVerdict> found;   ///< their verdicts
    std::vector<std::size_t> blamed;  ///< moves of the original path with changes by which a move breaks a rule
  };
  /// Checks a corrected path. `after` is checked without stock.
  [[nodiscard]] Examined examine(const Correction& correction, const CheckedPath& after,
                                 const ProgressCall& progress) const;

  /// Adds the findings of a corrected path to those that are sought, and takes the material from that path.
  void seek(const Examined& examined, const std::vector<PathChange>& changes, Toolpath after);
  /// Forgets what `seek` added.
  void forget();

 private:
  struct RapidPiece {
    bool is_new = false, replaces_feed = false;
  };
  [[nodiscard]] bool is_no_worse(std::size_t move, const StockResult& after, std::size_t piece, RapidPiece rapid) const;
  [[nodiscard]] std::vector<std::size_t> blame(std::size_t move, const std::vector<PathChange>& changes,
                                               const StockFinding* finding) const;
  [[nodiscard]] bool was_cut(std::size_t move, const Vec3& point) const;

  const Toolpath& path_;
  const CheckSetup& setup_;
  CheckResult before_, sought_;
  StockResult found_;
  std::shared_ptr<const StockAtMoves> programmed_, material_;
};

}  // namespace gouge
