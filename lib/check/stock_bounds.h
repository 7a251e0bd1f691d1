#pragma once

namespace gouge {

// Bounds of depths in remaining stock, for material as docs/method/stock.md defines it. mm.

/// Returns how much deeper material may be than what is proved with wider cutters and a smaller stock.
[[nodiscard]] constexpr double beyond_wider_cuts_mm(double resolution_mm) { return 2 * resolution_mm; }

/// Returns the depth that remaining stock does not exceed in a move that is clear of it.
[[nodiscard]] constexpr double largest_clear_stock_mm(double tolerance_mm, double resolution_mm) {
  return tolerance_mm + resolution_mm + beyond_wider_cuts_mm(resolution_mm);
}

}  // namespace gouge
