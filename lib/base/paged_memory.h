#pragma once

#include <cstddef>
#include <vector>

// Arrays as long as a toolpath, which need not stay in memory. While all of them together are small, they are in plain
// memory. A further large array is a temporary file without a name (in $TMPDIR, else /var/tmp), mapped into memory. The
// system writes unused pages to the file. Pages beyond a limit are released, so that the memory of the process does not
// grow with the path.

namespace gouge {

struct PagedLimits {
  std::size_t min_file_bytes = 0;  ///< arrays below this size are in plain memory
  std::size_t resident_bytes = 0;  ///< approximate maximum size of file pages that the process holds at once
  std::size_t plain_bytes = 0;     ///< maximum size of all larger arrays in plain memory together
};

/// Sets the limits for later allocations; initially they are 64 MB, 512 MB and 512 MB. Existing allocations stay where they
/// are. Returns the previous limits.
PagedLimits set_paged_limits(const PagedLimits& limits);

/// Allocates memory whose content is zeros or arbitrary. Uses plain memory, in large pages if the system has them, if no
/// file can be created (no space, no such file system). Throws bad_alloc.
[[nodiscard]] void* allocate_paged(std::size_t bytes);
void free_paged(void* start, std::size_t bytes) noexcept;

/// Returns the number of arrays that are in files now.
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

/// A vector whose items are in paged memory. Several threads may read and write different items, as in std::vector.
template <class Item>
using PagedVector = std::vector<Item, PagedAllocator<Item>>;

}  // namespace gouge
