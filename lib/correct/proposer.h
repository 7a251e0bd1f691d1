#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/correct/path_corrector.h"
#include "lib/correct/plan_holes.h"
#include "lib/correct/plan_trims.h"
#include "lib/correct/reworked_path.h"
#include "lib/tilt/plan_tilts.h"

namespace gouge {

/// A move that must not change, with the reason.
struct KeptMove {
  std::size_t move = 0;
  std::string reason;
};

/// The steps that propose changes of a path, in their order. Curves that must change become chords. Runs are tilted,
/// and stretches are left out. Positions that still gouge are shifted. Chords become arcs again if possible, and holes
/// are lifted.
class Proposer {
 public:
  /// Plans the tilts and the stretches to leave out. All objects must outlive it. `stock` is the material before each
  /// move; null: stock is not examined.
  Proposer(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const CorrectOptions& correct,
           const ProgressCall& progress, std::shared_ptr<const StockAtMoves> stock = nullptr);

  Correction propose(const ProgressCall& progress);

  /// Makes the arc of a move straight in all later proposals.
  void make_straight(std::size_t move) { can_keep_arc_[move] = false; }

  /// Keeps moves from being changed. Left-out stretches and tilted runs to which some of them belong are given up. Then
  /// the other moves may change, because they may only be worse as an effect of these. If there are none, the moves stay
  /// as they are. Returns the moves that have been dealt with.
  std::vector<KeptMove> keep(const std::vector<KeptMove>& moves);
  void keep_all(const std::string& reason);

  [[nodiscard]] bool has_tilts() const { return !plan_.runs.empty(); }
  void give_up_tilts(const std::string& reason);

 private:
  void plan_tilting(const ProgressCall& progress);
  void rework();
  void plan_trimming();
  /// Returns the path after the last rework; null if the path was not reworked.
  [[nodiscard]] const ReworkedPath* last() const;
  /// Returns the path before stretches are left out.
  [[nodiscard]] const ReworkedPath* untrimmed() const;
  /// Returns the move among [first, last] of the path that gouges deepest; kNone if none gouges.
  [[nodiscard]] std::size_t deepest(std::size_t first, std::size_t last) const;
  /// Returns the move of the path of which move `i` of the plan is a piece.
  [[nodiscard]] std::size_t origin_of(std::size_t i) const;
  [[nodiscard]] std::vector<std::size_t> tilts_of(std::size_t move) const;
  [[nodiscard]] std::vector<std::size_t> trims_of(std::size_t move) const;
  void give_up_trim(const Trim& trim, const std::string& reason);
  void give_up_hole(std::size_t move);
  void keep_as_it_is(const KeptMove& kept);
  void keep_pieces(std::size_t move, const std::string& reason);
  void add_tilts(Correction& correction) const;
  void add_trims(Correction& correction) const;
  void add_holes(Correction& correction) const;

  const Toolpath& path_;
  const CheckResult& result_;
  const std::vector<const ToolVariants*>& tools_;
  MotionChecker checker_;
  const CorrectOptions& correct_;
  HolePlans holes_;
  std::vector<bool> can_keep_arc_, can_split_;
  std::optional<ReworkedPath> straight_;            // path with chords for curves; none: no curve must change
  std::optional<ReworkedPath> tilted_;              // the same path with tilted runs; none: no run is tilted
  TiltPlan plan_;                                   // tilts of the straight path
  std::optional<ReworkedPath> trimmed_;             // the same path with stretches left out; none: none is
  TrimPlan trims_;                                  // trims of the path before them (untrimmed)
  std::map<std::size_t, std::string> not_trimmed_;  // moves of the path that must not be left out, and why
  std::unique_ptr<PathCorrector> corrector_;
  std::vector<KeptMove> kept_;
};

}  // namespace gouge
