#pragma once

#include "cli/options/job_options.h"
#include "lib/certify/settle_stock.h"
#include "lib/check/prepared_scene.h"

namespace gouge {

/// Adds the question of --excess to the stock of a job; does nothing without it. The scene must outlive the stock.
/// Errors: a part is no closed solid (excess-open-part). Requires: find_wrong_stock finds nothing.
[[nodiscard]] Outcome load_excess(const JobArguments& arguments, const PreparedScene& scene, StockSetup& stock);

}  // namespace gouge
