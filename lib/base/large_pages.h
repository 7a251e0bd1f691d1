#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace gouge {

/// Requests that the system use large pages for this memory; they are faster to allocate and to access. It is only a
/// hint, and helps only before the memory is first written.
void ask_for_large_pages(void* start, std::size_t bytes);

/// Reserves memory for `count` items of an empty vector, in large pages if the system has them.
template <typename Item>
void reserve_large(std::vector<Item>& items, std::size_t count) {
  items.reserve(count);
  ask_for_large_pages(items.data(), count * sizeof(Item));
}

/// Allocator for vectors in large pages, if the system has them. Items that are added without a value stay
/// uninitialized. It is for callers that set all items anyway and would otherwise touch each of them twice.
template <typename Item>
struct LargePageAllocator {
  using value_type = Item;

  LargePageAllocator() = default;
  template <typename Other>
  LargePageAllocator(const LargePageAllocator<Other>& /*other*/) {}

  [[nodiscard]] Item* allocate(std::size_t count) {
    Item* const start = std::allocator<Item>().allocate(count);
    ask_for_large_pages(start, count * sizeof(Item));
    return start;
  }
  void deallocate(Item* start, std::size_t count) noexcept { std::allocator<Item>().deallocate(start, count); }

  template <typename Made>
  void construct(Made* item) noexcept {
    ::new (static_cast<void*>(item)) Made;
  }
  template <typename Made, typename... Arguments>
  void construct(Made* item, Arguments&&... arguments) {
    ::new (static_cast<void*>(item)) Made(std::forward<Arguments>(arguments)...);
  }

  template <typename Other>
  bool operator==(const LargePageAllocator<Other>& /*other*/) const {
    return true;
  }
};

template <typename Item>
using LargePageVector = std::vector<Item, LargePageAllocator<Item>>;

}  // namespace gouge
