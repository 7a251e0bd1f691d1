#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

// The sorting behind a block tree: sixteen bytes a triangle, cut in two again and again. A cut is a histogram and one
// pass without branches that a processor could predict wrongly. Only as much is put in order as the tree requests.

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
  /// Returns the widest axis, the lowest of equal ones.
  [[nodiscard]] std::size_t widest_axis() const;
};

/// Samples every `step`th entry. Requires at least one.
[[nodiscard]] EntryBox box_of(std::span<const Entry> entries, std::size_t step = 1);

/// Moves the `rank` entries that come first along one axis (ties: lower triangles first) before the others.
/// The axis is the widest by a sample of the entries; the order on either side depends on nothing but the
/// order before.
///
/// Requires 0 < rank < entries.size() <= scratch.size(), and finite middles.
/// Cost     O(n).
void cut_entries(std::span<Entry> entries, std::span<Entry> scratch, std::size_t rank);

}  // namespace gouge::detail
