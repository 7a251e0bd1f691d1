#include "lib/base/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace gouge {

void ask_for_large_pages(void* start, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  constexpr std::size_t kLarge = std::size_t{1} << 21U;
  if (bytes < 2 * kLarge) return;
  // Only large pages that lie wholly within: what is beside them belongs to others.
  const auto first = reinterpret_cast<std::uintptr_t>(start);
  const std::uintptr_t begin = (first + kLarge - 1) / kLarge * kLarge;
  const std::uintptr_t end = (first + bytes) / kLarge * kLarge;
  ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
  (void)start;
  (void)bytes;
#endif
}

}  // namespace gouge
