#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/option_table.h"
#include "cli/values/parse_stock.h"
#include "lib/base/result.h"
#include "lib/stock/stock_options.h"

namespace CLI {
class App;
}

namespace gouge {

struct JobArguments;

/// The options of the remaining stock, as typed.
struct StockArguments {
  std::string stock;                              ///< "box", "box=2", "part+3" or the name of a file; empty: none
  std::vector<std::string> before;                ///< "op10.apt,tools=lib.json,place=0,0,5", in the order of time
  std::string stock_tolerance, stock_resolution;  ///< empty: those of StockOptions
  std::string stock_cell;                         ///< empty: default_stock_cell
  std::string write_stock;                        ///< file for the mesh of the remaining stock; empty: none
  std::string excess;                             ///< empty: not asked for
};

/// A program that ran before, as typed behind --before.
struct BeforeText {
  std::string path, tools, place;  ///< tools and place: empty if they are not given
  [[nodiscard]] std::string typed() const;
};

/// Splits the text of --before. A comma of a file's name stays in it.
[[nodiscard]] BeforeText split_before(const std::string& typed);

/// Errors (code usage) name the option, the typed text and the expected one.
[[nodiscard]] Result<StockShape> understand_stock_shape(const std::string& typed);
[[nodiscard]] Result<StockOptions> understand_stock_options(const StockArguments& arguments);

/// Returns the side of the cells of the meshes of the remaining stock, mm; 0: the default.
[[nodiscard]] Result<double> understand_stock_cell(const StockArguments& arguments);
/// Returns the name of the second file of --write-stock: "left.surely.stl" for "left.stl".
[[nodiscard]] std::string surely_file_of(const std::string& file);
/// Returns the length of --excess in mm; none: not asked for. Errors as above.
[[nodiscard]] Result<std::optional<double>> understand_excess(const StockArguments& arguments);

/// Returns the rows of the options of stock; of `check` and `correct`.
[[nodiscard]] const OptionRows<JobArguments>& stock_options();
/// Returns the rows of the options about material that a path leaves; of `check` alone.
[[nodiscard]] const OptionRows<JobArguments>& left_stock_options();

/// Finds a wrong value, or an option that excludes --stock, before any input is read. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_stock(const JobArguments& arguments);

}  // namespace gouge
