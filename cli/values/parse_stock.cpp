#include "cli/values/parse_stock.h"

#include <string_view>

#include "cli/values/parse_lengths.h"

namespace gouge {
namespace {

constexpr std::string_view kBox = "box", kBoxWith = "box=", kPartWith = "part+";

}  // namespace

bool names_stock_file(const std::string& typed) {
  return !typed.empty() && typed != kBox && !typed.starts_with(kBoxWith) && !typed.starts_with(kPartWith);
}

std::optional<StockShape> parse_stock_shape(const std::string& typed) {
  if (names_stock_file(typed)) return StockShape{};
  if (typed == kBox) return StockShape{StockShape::Kind::box, 0};
  const bool is_box = typed.starts_with(kBoxWith);
  const std::optional<double> length = parse_length_mm(typed.substr((is_box ? kBoxWith : kPartWith).size()));
  if (!length || *length < 0) return std::nullopt;
  return StockShape{is_box ? StockShape::Kind::box : StockShape::Kind::part, *length};
}

}  // namespace gouge
