#pragma once

#include <cstddef>
#include <vector>

// Arrays as long as a toolpath, which need not stay in memory. Above a certain size they are in a temporary file
// without a name (in $TMPDIR, else /var/tmp) that the program sees as memory. The system writes out what is not in use.
// Pages beyond a limit are released, so that the memory of the process does not grow with the path.

namespace gouge {

struct PagedLimits {
  std::size_t min_file_bytes = 0;  ///< smaller arrays are plain memory
  std::size_t resident_bytes = 0;  ///< of files the process may hold at once, about
};

/// Sets the limits for later allocations, instead of 64 MB and 512 MB. Allocated memory stays where it is. Returns the
/// limits before.
PagedLimits set_paged_limits(const PagedLimits& limits);

/// Zeros, or anything. Where no file can be had (no room, no such file system) it is plain memory. Throws bad_alloc.
[[nodiscard]] void* allocate_paged(std::size_t bytes);
void free_paged(void* start, std::size_t bytes) noexcept;

/// Returns the number of arrays stand in files now.
[[nodiscard]] std::size_t paged_arrays();

template <class Item>
struct PagedAllocator {
  using value_type = Item;

  PagedAllocator() = default;
  template <class Other>
  PagedAllocator(const PagedAllocator<Other>& /*other*/) {}

  [[nodiscard]] Item* allocate(std::size_t count) { return static_cast<Item*>(allocate_paged(count * sizeof(Item))); }
  void deallocate(Item* start, std::size_t count) noexcept { free_paged(start, count * sizeof(Item)); }

  template <class Other>
  bool operator==(const PagedAllocator<Other>& /*other*/) const {
    return true;
  }
};

/// A vector whose items stand in such memory. Several threads may read and write different items, as usual.
template <class Item>
using PagedVector = std::vector<Item, PagedAllocator<Item>>;

}  // namespace gouge
