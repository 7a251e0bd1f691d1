#pragma once

#include <optional>
#include <string>

#include "lib/stock/stock_shape.h"

namespace gouge {

/// Returns whether the text of a stock is the name of a file, not "box", "box=LENGTH" or "part+LENGTH".
[[nodiscard]] bool names_stock_file(const std::string& typed);

/// Parses "box", "box=2", "part+3" or the name of a file. Requires a text. Nothing: the length is wrong.
[[nodiscard]] std::optional<StockShape> parse_stock_shape(const std::string& typed);

/// The forms that parse_stock_shape accepts, for messages.
inline constexpr const char* kStockForms =
    "box, box=LENGTH or part+LENGTH with a length of 0 to 100 m, or the name of an STL file (./NAME if it begins alike)";

}  // namespace gouge
