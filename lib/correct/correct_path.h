#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/result.h"
#include "lib/certify/check.h"
#include "lib/contact/left_stock.h"
#include "lib/correct/correct_pose.h"
#include "lib/path/path_change.h"
#include "lib/tilt/tilt_options.h"

// Moves a path out of its gouges and makes no move worse. The proof is not the search for the changes: the written file
// is read and checked again like any other. A change that fails this check is not made.

namespace gouge {

struct CorrectOptions {
  BodyStrategies strategies;
  TiltOptions tilt;
  bool may_add_axes = false;  ///< whether axes may be added to a file without any; such a file runs on machines of
                              ///< three axes
  double max_shift_mm = 20;
  std::optional<double> max_side_shift_mm;      ///< none: kSideShiftsPerDepth times the depth (correct_pose.h)
  double rapid_clearance_mm = 1;                ///< clearance of a rapid that must change, if there is room; at least 0
  const RewritableMoves* rewritable = nullptr;  ///< changes that the file can state; null: none
};

/// A changed or added position, for the list of changes.
struct ChangeRecord {
  std::size_t move = 0;  ///< index in the original path
  Strategy strategy = Strategy::weighted;
  bool is_inserted = false;
  Vec3 shift_mm = Vec3::Zero();  ///< shift of the position; of an inserted one from the motion's pose at that instant
  double depth_before_mm = 0;    ///< depth at the position; for an inserted or tilted one, depth of the motion there
  double depth_after_mm = 0;
  int iterations = 0;
  double tilt_rad = 0;        ///< angle between the old and the new axis there
  Pose pose;                  ///< the new position; for an arc that stays one, its end
  std::size_t cause = kNone;  ///< original move whose gouge it cures; kNone: no neighbour gouges
};

/// A move that still gouges or is buried, with the reason.
struct Uncorrected {
  std::size_t move = 0;
  std::size_t line = 0;
  double depth_mm = 0;
  std::string reason;
  bool is_changed = false;  ///< its own record was changed nevertheless, for a neighbour or to gouge less
};

/// Moves [first, last] that should have been tilted but were not, with the reason. They are lifted or left unchanged.
struct NotTilted {
  std::size_t first = 0, last = 0;
  std::string reason;
};

/// Moves [first_move, last_move] of which a part stays uncut.
struct Uncut {
  enum class Kind {
    left_out,  ///< the tool passes above them
    hole,      ///< a hole is less deep
    lifted,    ///< cuts are farther from their programmed place than the cutter's radius
  };
  std::size_t first_move = 0, last_move = 0;
  std::size_t first_line = 0, last_line = 0;
  std::size_t positions = 0;  ///< number of programmed positions that are not visited
  double length_mm = 0;       ///< length of the programmed feeds; for a hole, the missing depth
  Kind kind = Kind::left_out;
};

/// A rapid of a changed path that comes nearer than the clearance: a feed that became a rapid, or a rapid with a new
/// path.
struct LowRapid {
  std::size_t move = 0, line = 0;
  double keeps_mm = 0;  ///< certified distance to everything; if negative, maximum depth in part or fixtures
};

/// Changed moves [first_move, last_move] that leave stock on surface that they finished before.
struct StockStretch {
  std::size_t first_move = 0, last_move = 0;
  std::size_t first_line = 0, last_line = 0;
  LeftStock most;
};

/// A list of changes with its effects. Lines are those of the original path; 0 in a proposal.
struct Correction {
  std::vector<PathChange> changes;  ///< in path order, for write_corrected
  std::vector<ChangeRecord> records;
  std::vector<Uncorrected> uncorrected;
  std::vector<NotTilted> not_tilted;
  std::vector<Uncut> uncut;  ///< in path order
  // Results for the written path; empty in a proposal.
  std::vector<StockStretch> stock;
  std::vector<LowRapid> low_rapids;  ///< in path order (lib/correct/low_rapids.h)
};

/// Returns the proposed changes. Each motion that they touch was checked by itself and is no worse than before.
///
/// Requires `result` from check() with the same path and setup.
/// Ensures  (1) Except for tilts and left-out stretches, only positions at the ends of gouging moves are moved, and
///          only if they are themselves too deep. No shift is longer than max_shift, or longer than max_side_shift
///          across the tool axis. (2) The tool axis changes in the runs of lib/tilt, which surround gouging moves of a
///          body whose strategy is to tilt. Otherwise it changes only above a stretch that is left out
///          (lib/correct/plan_trims.h). (3) The proposal is the same at any number of threads.
/// Source   Thesis 5.3 (weighted, iterated). Tilting, lifting, inserting and taking back are our own:
///          docs/method/correction.md, docs/method/tilting.md.
[[nodiscard]] Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                      const CorrectOptions& correct, const ProgressCall& progress = {});

/// A path and the result of its check.
struct ChangedPath {
  Toolpath path;
  CheckResult result;
};
/// A function that applies a list of changes: it writes the path and reads it again. Its result is checked here.
using RewritePath = std::function<Result<Toolpath>(const std::vector<PathChange>&)>;

struct LawfulCorrection {
  Correction correction;
  ChangedPath after;
  std::optional<CheckResult> before = std::nullopt;  ///< with stock: the given result with the findings in stock
};

/// Returns the changes that keep the laws (laws.h) in the file that `rewrite` makes of them. That file is checked like
/// any other path. A change that makes a move worse there, or that cannot be written, is taken back. This is repeated
/// until no such change is left.
///
/// With setup.stock the moves are also freed from remaining stock, each with the material that the corrected path leaves
/// before it (stock_laws.h). `result` must then be that of a check without stock.
///
/// Ensures  The list `uncorrected` has every move that gouges or is buried in `after`, and no other.
/// Errors   Those of `rewrite` without any change. correct-law: a move is worse even without a change, which is an
///          error of the program.
/// Cost     That of correct_path; in addition, for each time that changes were taken back, a call of `rewrite` and a
///          check of its path.
[[nodiscard]] Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result,
                                                        const CheckSetup& setup, const CorrectOptions& correct,
                                                        const RewritePath& rewrite, const ProgressCall& progress = {});

}  // namespace gouge
