#pragma once

#include <optional>
#include <string>

#include "cli/options/option_table.h"
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
  std::string stock_tolerance, stock_resolution;  ///< empty: those of StockOptions
};

/// The shape of the stock, understood.
struct StockShape {
  enum class Kind { box, part, file } kind = Kind::file;
  double allowance_mm = 0;
};

/// Returns whether the text of --stock is the name of a file.
[[nodiscard]] bool names_stock_file(const std::string& typed);

/// Errors (code usage) name the option, the typed text and the expected one.
[[nodiscard]] Result<StockShape> understand_stock_shape(const std::string& typed);
[[nodiscard]] Result<StockOptions> understand_stock_options(const StockArguments& arguments);

/// Returns the rows of the options; of `check` and `correct`.
[[nodiscard]] const OptionRows<JobArguments>& stock_options();

/// Finds a wrong value, or an option that excludes --stock, before any input is read. Code: usage.
[[nodiscard]] std::optional<Diagnostic> find_wrong_stock(const JobArguments& arguments);

}  // namespace gouge
