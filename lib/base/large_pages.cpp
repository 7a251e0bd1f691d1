#include "lib/base/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace gouge {

void ask_for_large_pages(void* start, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kLarge = std::size_t{1} << 21U;
  if (bytes < 2 * kLarge) return;
  // Only large pages that lie completely inside the memory are affected: memory next to it belongs to others.
  const std::size_t before = (kLarge - reinterpret_cast<std::uintptr_t>(start) % kLarge) % kLarge;
  ::madvise(static_cast<char*>(start) + before, (bytes - before) / kLarge * kLarge, MADV_HUGEPAGE);
#else
  (void)start;
  (void)bytes;
#endif
}

}  // namespace gouge
