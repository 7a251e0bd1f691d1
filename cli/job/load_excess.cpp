#include "cli/job/load_excess.h"

#include <utility>

namespace gouge {

Outcome load_excess(const JobArguments& arguments, const PreparedScene& scene, StockSetup& stock) {
  const Result<std::optional<double>> asked = understand_excess(arguments);
  if (!asked) return asked.error();
  if (!*asked) return Done{};
  if (!scene.is_within_reach)
    return make_error("excess-out-of-reach",
                      "--excess: a part reaches beyond 100 m, where no bound is proved; expected parts nearer to the "
                      "origin");
  Result<PartColumns> parts = PartColumns::of(scene.obstacle(Against::part).surfaces);
  if (!parts) return parts.error();
  stock.excess = ExcessSetup{**asked, std::move(*parts), !arguments.report_folder.empty()};
  return Done{};
}

}  // namespace gouge
