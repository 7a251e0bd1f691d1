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

/// Proposes changes of a path, one kind upon the other. Curves that must change become chords. Runs are tilted, and
/// stretches are left out. Positions that still gouge are shifted. Arcs come back where they can, and holes are lifted.
class Proposer {
 public:
  /// All must outlive it.
  Proposer(const Toolpath& path, const CheckResult& result, const CheckSetup& setup, const CorrectOptions& correct,
           const ProgressCall& progress);

  Correction propose(const ProgressCall& progress);

  /// Makes a proposed arc straight from now on. Returns false where none was proposed.
  [[nodiscard]] bool give_up_arc(const std::vector<PathChange>& changes, std::size_t move);

  /// Returns where the move is of a tilted run, that run is tilted no more; else the move stays as it is.
  void keep(std::size_t move, const std::string& reason);
  void keep_all(const std::string& reason);

 private:
  void plan_tilting(const ProgressCall& progress);
  void rework();
  void plan_trimming();
  /// Returns the path reworked last; null: the path is as it was.
  [[nodiscard]] const ReworkedPath* last() const;
  /// Returns the path before stretches are left out.
  [[nodiscard]] const ReworkedPath* untrimmed() const;
  /// Returns which of the moves [first, last] of the path gouges deepest; kNone: none does.
  [[nodiscard]] std::size_t deepest(std::size_t first, std::size_t last) const;
  /// Maps a move of the plan: which move of the path it is a piece of.
  [[nodiscard]] std::size_t origin_of(std::size_t i) const;
  [[nodiscard]] bool give_up_tilt(std::size_t move, const std::string& reason);
  [[nodiscard]] bool give_up_trim(std::size_t move, const std::string& reason);
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
  std::optional<ReworkedPath> straight_;            // curves as chords; none: it has none that must change
  std::optional<ReworkedPath> tilted_;              // and runs tilted; none: no run is
  TiltPlan plan_;                                   // of the straight path
  std::optional<ReworkedPath> trimmed_;             // and stretches left out; none: none is
  TrimPlan trims_;                                  // of the path tilted, straight, or as it is
  std::map<std::size_t, std::string> not_trimmed_;  // moves of the path that must not be, and why
  std::unique_ptr<PathCorrector> corrector_;
  std::vector<std::pair<std::size_t, std::string>> kept_;
};

}  // namespace gouge
