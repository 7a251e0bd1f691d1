#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

// Sorting for a block tree: sixteen bytes for each triangle, divided in two repeatedly. A cut is a histogram and one
// pass without branches that a processor could predict wrongly. Only the order that the tree needs is established.

namespace gouge::detail {

/// A triangle and the middle of its box.
struct alignas(16) Entry {
  std::array<float, 3> middle{};
  std::uint32_t triangle = 0;
};

/// Smallest and largest middles of some entries.
struct EntryBox {
  std::array<float, 3> low{}, high{};

  [[nodiscard]] float width(std::size_t axis) const { return high[axis] - low[axis]; }
  /// Returns the widest axis; of equally wide ones the first.
  [[nodiscard]] std::size_t widest_axis() const;
};

/// Returns the box of every `step`th entry. Requires at least one entry.
[[nodiscard]] EntryBox box_of(std::span<const Entry> entries, std::size_t step = 1);

/// Moves the `rank` entries that come first along one axis before the others; of equal positions, lower triangles come
/// first. The axis is the widest in a sample of the entries. The order on either side depends only on the previous
/// order.
///
/// Requires 0 < rank < entries.size() <= scratch.size(), and finite middles.
/// Cost     O(n).
void cut_entries(std::span<Entry> entries, std::span<Entry> scratch, std::size_t rank);

}  // namespace gouge::detail
