#pragma once

#include "cli/job/claimed_result.h"
#include "cli/job/job.h"
#include "cli/job/load_stock.h"
#include "cli/options/baseline.h"

namespace gouge {

/// Stock and acceptances of a check, which its job does not have.
struct BesideJob {
  const LoadedStock* stock = nullptr;  ///< null: it had no stock
  const LoadedBaseline& baseline;
};

/// The record that follows from the moves that a result lists and from its inputs.
struct ExpectedRecord {
  ResultRecord record;
  /// True if the listed moves establish how the path fits the part. They do not if clean moves, which are not listed, may
  /// be deep enough to count as gouges of a path that does not fit.
  bool is_fit_known = true;
};

/// Makes the record of a result anew, without its searches for depths: findings by lib/verify, totals from the listed
/// moves, and everything about toolpath, tools, meshes and facts from the inputs. Sections about stock, excess, laws and
/// stick-out, and cures of findings, are empty.
/// Requires a result without contradictions in its file, whose toolpath has as many moves as the result.
/// Cost     A search at some 450 positions, for the facts about placement.
[[nodiscard]] ExpectedRecord make_expected_record(const Job& job, const BesideJob& beside, const ClaimedResult& result,
                                                  const ProgressCall& progress);

}  // namespace gouge
