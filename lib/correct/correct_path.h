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

// Takes a path out of its gouges and makes nothing worse. The proof of that is not the search for the changes. The
// written file is read and checked again like any other, and a change that fails this check is not made.

namespace gouge {

struct CorrectOptions {
  BodyStrategies strategies;
  TiltOptions tilt;
  bool may_add_axes = false;  ///< to a file that states none: it runs on machines of three axes
  double max_shift_mm = 20;
  std::optional<double> max_side_shift_mm;  ///< none: kSideShiftsPerDepth times the depth (free_pose.h)
  double rapid_clearance_mm = 1;  ///< how far a rapid that must change keeps off, where there is room; at least 0
  const RewritableMoves* rewritable = nullptr;  ///< changes that the file can state as such; null: none
};

/// One changed or added position, for the change list.
struct ChangeRecord {
  std::size_t move = 0;  ///< of the path as it was
  Strategy strategy = Strategy::weighted;
  bool is_inserted = false;
  Vec3 shift_mm = Vec3::Zero();  ///< inserted: from where the motion was at that instant
  double depth_before_mm = 0;    ///< at the position (inserted or tilted: of the motion there)
  double depth_after_mm = 0;
  int iterations = 0;
  double tilt_rad = 0;        ///< between the axis as it was there and as it is
  Pose pose;                  ///< where the position is now; of an arc that stays one, its end
  std::size_t cause = kNone;  ///< the move of the path as it was whose gouge it cures; kNone: none is beside it
};

/// A move that still gouges, or is buried, and why.
struct Uncorrected {
  std::size_t move = 0;
  std::size_t line = 0;
  double depth_mm = 0;
  std::string reason;
  bool is_changed = false;  ///< its own record was changed all the same, for a neighbour's sake or to gouge less
};

/// Moves [first, last] that should have been tilted, and why they are not: they are lifted, or left.
struct NotTilted {
  std::size_t first = 0, last = 0;
  std::string reason;
};

/// Moves [first_move, last_move] of which a part stays uncut.
struct Uncut {
  enum class Kind {
    left_out,  ///< the tool passes above them
    hole,      ///< a hole is drilled less deep
    lifted,    ///< cuts are farther from their programmed place than the cutter's radius
  };
  std::size_t first_move = 0, last_move = 0;
  std::size_t first_line = 0, last_line = 0;
  std::size_t positions = 0;  ///< programmed ones that are not visited
  double length_mm = 0;       ///< of the programmed feeds; of a hole what is missing of its depth
  Kind kind = Kind::left_out;
};

/// A move that became rapids, or that is one and runs elsewhere, and comes nearer than the clearance.
struct LowRapid {
  std::size_t move = 0, line = 0;
  double keeps_mm = 0;  ///< certified: nothing is nearer; negative: it is no deeper in part or fixtures
};

/// Changed moves [first_move, last_move] after which some of what they finished stands out.
struct StockStretch {
  std::size_t first_move = 0, last_move = 0;
  std::size_t first_line = 0, last_line = 0;
  LeftStock most;
};

/// Lines of its lists are those of the path as it was; 0 in a proposal.
struct Correction {
  std::vector<PathChange> changes;  ///< in path order, for write_corrected
  std::vector<ChangeRecord> records;
  std::vector<Uncorrected> uncorrected;
  std::vector<NotTilted> not_tilted;
  std::vector<Uncut> uncut;  ///< in path order
  // Result for the path as it is written; empty in a proposal.
  std::vector<StockStretch> stock;
  std::vector<LowRapid> low_rapids;  ///< in path order (lib/correct/low_rapids.h)
};

/// Returns the changes as they are proposed. Each motion that they touch has been checked by itself and is no worse
/// than it was.
///
/// Requires `result` from check() with the same path and setup.
/// Ensures  (1) Except for tilts and left-out stretches, only positions at the ends of gouging moves are moved. They
///          are moved only when they are themselves too deep. None goes further than max_shift, nor further than
///          max_side_shift across the tool axis. (2) The tool axis changes in the runs of lib/tilt alone: about moves
///          of which a body gouges whose strategy is to tilt. It also changes above a stretch that is left out
///          (lib/correct/plan_trims.h). (3) The same proposal at any number of threads.
/// Source   Thesis 5.3 (weighted, iterated); tilting, lifting, inserting and taking back are ours:
///          docs/method/correction.md, docs/method/tilting.md.
[[nodiscard]] Correction correct_path(const Toolpath& toolpath, const CheckResult& result, const CheckSetup& setup,
                                      const CorrectOptions& correct, const ProgressCall& progress = {});

/// A path and its verdict.
struct ChangedPath {
  Toolpath path;
  CheckResult result;
};
/// The path after a list of changes: written, read again and checked here.
using RewritePath = std::function<Result<Toolpath>(const std::vector<PathChange>&)>;

struct LawfulCorrection {
  Correction correction;
  ChangedPath after;
};

/// Returns the changes that keep the laws (laws.h) in the file that `rewrite` makes of them, checked like any other
/// path. A change that makes a move worse there, or that cannot be written, is taken back until no such change is left.
///
/// Ensures  The list `uncorrected` holds every move that gouges or is buried in `after`, and no other.
/// Errors   Those of `rewrite` for no changes at all. With correct-law a move is worse even then, which is an error of
///          the program.
/// Cost     As correct_path, and a call of `rewrite` and a check of its path for every time something was taken back.
[[nodiscard]] Result<LawfulCorrection> correct_lawfully(const Toolpath& toolpath, const CheckResult& result,
                                                        const CheckSetup& setup, const CorrectOptions& correct,
                                                        const RewritePath& rewrite, const ProgressCall& progress = {});

}  // namespace gouge
