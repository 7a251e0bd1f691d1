#include "cli/options/stock_arguments.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "cli/options/job_options.h"
#include "cli/terminal/length_text.h"
#include "lib/base/similar_name.h"

namespace gouge {
namespace {

constexpr const char* kOption = "--stock";
constexpr double kFinestStock_mm = 0.001;  // a finer resolution only takes longer
constexpr std::string_view kTools = ",tools=", kPlace = ",place=";
constexpr std::string_view kStl = ".stl";

bool is_stl_name(const std::string& file) {
  if (file.size() <= kStl.size()) return false;
  const std::string_view end = std::string_view(file).substr(file.size() - kStl.size());
  return std::ranges::equal(end, kStl, [](char a, char b) { return a == b || a == b - 'a' + 'A'; });
}

}  // namespace

std::string BeforeText::typed() const {
  return path + (tools.empty() ? "" : std::string(kTools) + tools) + (place.empty() ? "" : std::string(kPlace) + place);
}

BeforeText split_before(const std::string& typed) {
  const std::size_t at_tools = typed.find(kTools), at_place = typed.find(kPlace);
  const auto value = [&](std::string_view key, std::size_t at, std::size_t other) {
    if (at == std::string::npos) return std::string();
    const std::size_t begin = at + key.size();
    return typed.substr(begin, other > begin && other != std::string::npos ? other - begin : std::string::npos);
  };
  return {typed.substr(0, std::min(at_tools, at_place)), value(kTools, at_tools, at_place),
          value(kPlace, at_place, at_tools)};
}

Result<StockShape> understand_stock_shape(const std::string& typed) {
  const std::optional<StockShape> shape = parse_stock_shape(typed);
  if (!shape) return usage_error(kOption, typed, kStockForms);
  std::error_code ignored;
  if (!names_stock_file(typed) || is_stl_name(typed) || std::filesystem::exists(typed, ignored)) return *shape;
  // A misspelt form, such as bx=2, parts+2 or boxx.
  const bool is_form = typed.find_first_of("=+") != std::string::npos;
  const bool is_name = typed.find_first_of("./") == std::string::npos;
  const std::string similar = is_name && !is_form ? find_similar_name(typed, {"box"}) : "";
  if (!similar.empty())
    return usage_error(kOption, typed, std::string(kStockForms) + "; did you mean " + similar + "?");
  if (is_form) return usage_error(kOption, typed, kStockForms);
  return *shape;
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

Result<double> understand_stock_cell(const StockArguments& arguments) {
  if (arguments.stock_cell.empty()) return 0.0;
  const Result<StockOptions> options = understand_stock_options(arguments);
  if (!options) return options.error();
  Result<double> cell = understand_length("--stock-cell", arguments.stock_cell, Minimum::above_zero);
  if (cell && *cell < options->resolution_mm)
    return usage_error("--stock-cell", arguments.stock_cell,
                       "a length of at least --stock-resolution, since finer cells show nothing more");
  return cell;
}

std::string surely_file_of(const std::string& file) {
  const std::size_t stem = file.size() - kStl.size();
  return file.substr(0, stem) + ".surely" + file.substr(stem);
}

const OptionRows<JobArguments>& stock_options() {
  using A = JobArguments;
  static const OptionRows<A> rows = {
      {.name = "--stock",
       .field = &A::stock,
       .type = "FILE",
       .group = "Check",
       .help =
           "Check rapids, shank, holder and heads against the material that earlier moves left of this stock: a closed "
           "STL file, box or box=MARGIN (the box about the parts), or part+ALLOWANCE",
       .scope = Scope::project,
       .recorded = Recorded::repeated},
      {.name = "--before",
       .field = &A::before,
       .type = "FILE",
       .help = "Program that cut this stock before the toolpath (repeatable, in the order of time). Its tools and its "
               "place in the coordinates of the toolpath are appended: op10.apt,tools=op10.json,place=0,0,-5,180,0,0 "
               "(default: the tools of --tools, the same coordinates)",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .needs = "--stock"},
      {.name = "--stock-tolerance",
       .field = &A::stock_tolerance,
       .type = "LENGTH",
       .help =
           "Maximum depth that remaining stock may have in a body of the tool (default 0.1). Clear moves are proved to "
           "this depth and three times --stock-resolution",
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
       .needs = "--stock"}};
  return rows;
}

const OptionRows<JobArguments>& left_stock_options() {
  using A = JobArguments;
  static const OptionRows<A> rows = {
      {.name = "--excess",
       .field = &A::excess,
       .type = "LENGTH",
       .group = "Check",
       .help = "Find where more than this length of material is left on the part after the whole program; such a place "
               "gives exit status 1, and one for which it is open gives 4",
       .scope = Scope::project,
       .recorded = Recorded::repeated,
       .needs = "--stock"},
      {.name = "--stock-cell",
       .field = &A::stock_cell,
       .type = "LENGTH",
       .help =
           "Side of the cells of which --write-stock and the 3D view make the remaining stock (default: 1/150 of the "
           "diagonal of the stock)",
       .scope = Scope::project,
       .needs = "--stock"},
      {.name = "--write-stock",
       .field = &A::write_stock,
       .type = "FILE",
       .group = kOutputGroup,
       .help =
           "Write the material that is left after the path as two closed meshes (binary STL): FILE (NAME.stl) "
           "contains all that may be there, for --stock of the next set-up; NAME.surely.stl has only what is surely there",
       .needs = "--stock"}};
  return rows;
}

std::optional<Diagnostic> find_wrong_stock(const JobArguments& arguments) {
  if (arguments.stock.empty()) return std::nullopt;
  if (const Result<StockShape> shape = understand_stock_shape(arguments.stock); !shape) return shape.error();
  if (const Result<StockOptions> options = understand_stock_options(arguments); !options) return options.error();
  for (const std::string& typed : arguments.before) {
    const BeforeText before = split_before(typed);
    // A misspelt key, such as ,tool=, would be a part of the file's name.
    std::error_code ignored;
    const std::size_t comma = before.path.rfind(',');
    const bool has_key = comma != std::string::npos && before.path.find('=', comma) != std::string::npos &&
                         !std::filesystem::exists(before.path, ignored);
    if (before.path.empty() || has_key || before.typed().size() != typed.size())
      return usage_error("--before", typed, "FILE, FILE,tools=FILE or FILE,tools=FILE,place=X,Y,Z[,RX,RY,RZ]");
    if (before.place.empty()) continue;
    if (const auto place = understand_place("--before", before.place); !place) return place.error();
  }
  if (const Result<double> cell = understand_stock_cell(arguments); !cell) return cell.error();
  if (!arguments.write_stock.empty() && !is_stl_name(arguments.write_stock))
    return usage_error("--write-stock", arguments.write_stock,
                       "a file whose name ends with .stl; a mesh does not go to standard output");
  return std::nullopt;
}

}  // namespace gouge
