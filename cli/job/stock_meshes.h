#pragma once

#include <string>

#include "cli/job/job.h"
#include "lib/certify/settle_stock.h"
#include "lib/remains/remaining_stock.h"

namespace gouge {

/// The material that is left after the path of a job, with the files of --write-stock.
struct StockMeshes {
  RemainingStock remaining;  ///< without --write-stock only `perhaps`, for the 3D view
  std::string perhaps_stl, surely_stl;

  /// Returns the facts for the report, which refer to this object, and notes about files that are not written.
  [[nodiscard]] StockLeft facts(const JobArguments& arguments) const;
  [[nodiscard]] Diagnostics notes(const JobArguments& arguments) const;
};

/// Makes the meshes in the unit and the place of the files of the parts. So the same options read them back.
/// Errors: those of remaining_stock.
[[nodiscard]] Result<StockMeshes> make_stock_meshes(const JobArguments& arguments, const Job& job,
                                                    const StockSetup& stock, const ProgressCall& progress);

}  // namespace gouge
