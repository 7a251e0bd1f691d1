#include "lib/base/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace gouge {

void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const auto run = [&](std::size_t k) { body(k * chunk, std::min(count, (k + 1) * chunk)); };
  if (threads == 1 || chunks < 2) {
    for (std::size_t k = 0; k < chunks; ++k) run(k);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run); });
}

}  // namespace gouge
