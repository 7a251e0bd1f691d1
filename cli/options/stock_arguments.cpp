#include "cli/options/stock_arguments.h"

#include <algorithm>
#include <string_view>

#include "cli/options/job_options.h"
#include "cli/terminal/length_text.h"

namespace gouge {
namespace {

constexpr const char* kOption = "--stock";
constexpr const char* kExpected =
    "box, box=LENGTH or part+LENGTH with a length of 0 to 100 m, or the name of an STL file (./NAME if it begins alike)";
constexpr double kFinestStock_mm = 0.001;  // a finer resolution only takes longer
constexpr std::string_view kBox = "box", kBoxWith = "box=", kPartWith = "part+";

}  // namespace

bool names_stock_file(const std::string& typed) {
  return !typed.empty() && typed != kBox && !typed.starts_with(kBoxWith) && !typed.starts_with(kPartWith);
}

Result<StockShape> understand_stock_shape(const std::string& typed) {
  if (names_stock_file(typed)) return StockShape{};
  if (typed == kBox) return StockShape{StockShape::Kind::box, 0};
  const bool is_box = typed.starts_with(kBoxWith);
  const std::string_view prefix = is_box ? kBoxWith : kPartWith;
  const Result<double> length = understand_length(kOption, typed.substr(prefix.size()), Minimum::zero);
  if (!length) return usage_error(kOption, typed, kExpected);
  return StockShape{is_box ? StockShape::Kind::box : StockShape::Kind::part, *length};
}

Result<std::optional<double>> understand_excess(const StockArguments& arguments) {
  if (arguments.excess.empty()) return std::optional<double>();
  const Result<double> length = understand_length("--excess", arguments.excess, Minimum::above_zero);
  if (!length) return length.error();
  if (*length < kFinestStock_mm) return usage_error("--excess", arguments.excess, "a length from 0.001 mm");
  return std::optional<double>(*length);
}

Result<StockOptions> understand_stock_options(const StockArguments& arguments) {
  StockOptions options;
  if (!arguments.stock_tolerance.empty()) {
    const Result<double> tolerance =
        understand_length("--stock-tolerance", arguments.stock_tolerance, Minimum::above_zero);
    if (!tolerance) return tolerance.error();
    options.tolerance_mm = *tolerance;
    options.resolution_mm = std::min(options.resolution_mm, 0.5 * *tolerance);
  }
  const Result<std::optional<double>> excess = understand_excess(arguments);
  if (!excess) return excess.error();
  if (*excess) options.resolution_mm = std::min(options.resolution_mm, 0.5 * **excess);
  if (arguments.stock_resolution.empty()) return options;
  const Result<double> resolution =
      understand_length("--stock-resolution", arguments.stock_resolution, Minimum::above_zero);
  if (!resolution) return resolution.error();
  const bool is_coarse = *resolution > options.tolerance_mm || (*excess && *resolution > **excess);
  if (is_coarse || *resolution < kFinestStock_mm)
    return usage_error("--stock-resolution", arguments.stock_resolution,
                       *excess
                           ? "a length from 0.001 mm to --stock-tolerance and --excess, since thinner material "
                             "counts as removed"
                           : "a length from 0.001 mm to --stock-tolerance, since thinner material counts as removed");
  options.resolution_mm = *resolution;
  return options;
}

const OptionRows<JobArguments>& stock_options() {
  using A = JobArguments;
  static const OptionRows<A> rows = {
      {.name = "--stock",
       .field = &A::stock,
       .type = "FILE",
       .group = "Check",
       .help = "Check rapids, shank and holder against the material that earlier moves left of this stock: a closed "
               "STL file, box or box=MARGIN (the box about the parts), or part+ALLOWANCE",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--stock-tolerance",
       .field = &A::stock_tolerance,
       .type = "LENGTH",
       .help = "Maximum depth that remaining stock may have in a body of the tool (default 0.1)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .needs = "--stock"},
      {.name = "--stock-resolution",
       .field = &A::stock_resolution,
       .type = "LENGTH",
       .help = "Length by which cutters count as wider, so that material thinner than twice this counts as removed "
               "(default: half the tolerance or half of --excess, at most 0.05)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .needs = "--stock"},
      {.name = "--excess",
       .field = &A::excess,
       .type = "LENGTH",
       .help = "Find where more than this length of material is left on the part after the whole program; such a place "
               "gives exit status 1, and one for which it is open gives 4",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .needs = "--stock"}};
  return rows;
}

std::optional<Diagnostic> find_wrong_stock(const JobArguments& arguments) {
  if (arguments.stock.empty()) return std::nullopt;
  if (const Result<StockShape> shape = understand_stock_shape(arguments.stock); !shape) return shape.error();
  if (const Result<StockOptions> options = understand_stock_options(arguments); !options) return options.error();
  if (!arguments.heads.empty())
    return make_error(
        "usage", "--stock does not examine the bodies of --head; leave out --head and check it in a run of its own");
  if (!arguments.certificate_file.empty())
    return make_error("usage",
                      "--certificate does not prove that moves are clear of the stock; leave out --stock for it");
  return std::nullopt;
}

}  // namespace gouge
