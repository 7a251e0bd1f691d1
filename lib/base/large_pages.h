#pragma once

#include <cstddef>
#include <vector>

namespace gouge {

/// Asks the system to back this memory by large pages, which are quicker to get and to look up. Only a hint,
/// and only of use before the memory is first written.
void ask_for_large_pages(void* start, std::size_t bytes);

/// Memory for `count` items of an empty vector, in large pages where there are.
template <typename Item>
void reserve_large(std::vector<Item>& items, std::size_t count) {
  items.reserve(count);
  ask_for_large_pages(items.data(), count * sizeof(Item));
}

}  // namespace gouge
