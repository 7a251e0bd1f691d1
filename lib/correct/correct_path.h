#pragma once

#include <string>
#include <vector>

#include "lib/check/check_path.h"
#include "lib/correct/correct_pose.h"
#include "lib/path/path_change.h"

// Proposes the changes that take a path out of its gouges. The proof that they do is not here: the written
// file is read and checked again like any other.

namespace gouge {

struct CorrectOptions {
  Strategy strategy = Strategy::weighted;
  double max_shift_mm = 20;
  double rapid_clearance_mm = 1;  ///< how far a rapid that must change keeps off, where there is room; at least 0
  const HeadChecker* heads = nullptr;  ///< bodies that move with the tool, where there are any
};

/// One changed or added position, for the change list.
struct ChangeRecord {
  std::size_t move = 0;  ///< of the path as it was
  Strategy strategy = Strategy::weighted;
  bool is_inserted = false;
  Vec3 shift_mm = Vec3::Zero();  ///< inserted: from where the motion was at that instant
  double depth_before_mm = 0;    ///< at the position (inserted: of the motion there)
  double depth_after_mm = 0;
  int iterations = 0;
};

/// A gouging move that stays as it is, and why.
struct Uncorrected {
  std::size_t move = 0;
  double depth_mm = 0;
  std::string reason;
};

struct Correction {
  std::vector<PathChange> changes;  ///< in path order, for write_corrected
  std::vector<ChangeRecord> records;
  std::vector<Uncorrected> uncorrected;
};

/// Requires `result` from check_path with the same path, tools, scene and options, and from check_heads where
/// there
///          are heads.
/// Ensures  (1) only positions at the ends of gouging moves are moved, and only when they are themselves too
/// deep.
///          (2) no position moves further than max_shift; the tool axis of a position is never changed.
///          (3) the same proposal at any number of threads.
/// Source   thesis 5.3 (weighted, iterated); lifting and inserting are ours: docs/algorithms/correction.md.
[[nodiscard]] Correction correct_path(const Toolpath& toolpath, const CheckResult& result,
                                      const std::vector<const ToolForms*>& tools, const PreparedScene& scene,
                                      const CheckOptions& options, const CorrectOptions& correct,
                                      const ProgressCall& progress = {});

}  // namespace gouge
