#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/verify/attack.h"
#include "lib/verify/claims.h"
#include "lib/verify/solid_depth.h"

// Claims about remaining stock, tested by this module's own formulas. Definition: docs/method/stock.md.

namespace gouge {

class Draws;
class CutPrograms;

/// A program that cuts the stock.
struct ClaimedProgram {
  ClaimedScene scene;                     ///< its path, its tools without offsets, and the law of its motion
  std::vector<const ToolVariants*> bare;  ///< the tools without offsets; null: not defined
  std::vector<bool> cuts;                 ///< one for each tool
};

/// The stock of a check with the programs that cut it. Referenced objects must outlive it.
struct ClaimedStock {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< the box, without solids
  std::vector<SolidDepth> solids;                ///< the union of them, moved out by the allowance
  double allowance_mm = 0;
  double tolerance_mm = 0, resolution_mm = 0;
  bool is_motion_open = false;  ///< several motions are permitted: depths are the least of all, on the first one larger
  std::vector<ClaimedProgram> programs;  ///< in the order of time; the last is the path of the claims
  std::vector<SolidDepth> heads = {};    ///< bodies that move with the tools of that path, in the tool's frame

  /// Returns the depth that is proved for clear moves, with cutters wider and the stock smaller by the resolution.
  [[nodiscard]] double largest_clear_mm() const { return tolerance_mm + resolution_mm; }
  /// Returns how much deeper other material may be than what is proved so.
  [[nodiscard]] double beyond_proof_mm() const { return 2 * resolution_mm; }
};

/// Tests witnesses of findings in stock, and searches for stock in moves that claim to be clear of it.
class StockVerifier {
 public:
  /// `stock` must outlive it.
  explicit StockVerifier(const ClaimedStock& stock);
  ~StockVerifier();
  StockVerifier(const StockVerifier&) = delete;
  StockVerifier& operator=(const StockVerifier&) = delete;

  /// Returns the reason why the witness of a finding is wrong: it is no stock, not as deep as said, or an earlier cutter
  /// was there. Nothing if none of these is found. Cost: a few nanoseconds for each earlier move that is far away.
  [[nodiscard]] std::optional<std::string> find_fault(std::size_t move, const MoveClaim& claim) const;

  /// Searches for stock that is deeper than tolerance + resolution in moves that claim to be clear, at random points and
  /// instants. Stock counts as smaller and cutters as wider by the resolution. The same in every run unless `seconds` is
  /// above 0, which is the minimum duration.
  [[nodiscard]] AttackResult attack(const std::vector<bool>& is_clear, double seconds) const;

 private:
  /// A point in a body of the tool at an instant, and its depth.
  struct Draw {
    Vec3 point = Vec3::Zero();
    double depth_mm = 0;
  };
  /// Returns a random point at least `least_mm` deep in the body that must be clear, or in a head; nothing: the try failed.
  [[nodiscard]] std::optional<Draw> draw_in_tool(std::size_t move, double t, double least_mm, Draws& draws) const;
  [[nodiscard]] std::optional<Draw> draw_in_head(const SolidDepth& head, std::size_t move, double t, double least_mm,
                                                 Draws& draws) const;
  /// Returns the reason why a point is not as deep as said in the body that it names.
  [[nodiscard]] std::optional<std::string> find_wrong_depth(std::size_t move, const MoveClaim& claim) const;

  /// Returns the cut that may come nearer to a point than a distance, of earlier programs and of moves below `before`.
  [[nodiscard]] std::optional<std::string> nearer(const Vec3& point, std::size_t before, double within_mm,
                                                  bool counts_unknown) const;

  const ClaimedStock& stock_;
  std::unique_ptr<const CutPrograms> programs_;
};

}  // namespace gouge
