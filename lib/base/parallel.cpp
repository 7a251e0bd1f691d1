#include "lib/base/parallel.h"

#include <algorithm>

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace gouge {
namespace {

using Run = std::function<void(std::size_t)>;

#if defined(__SANITIZE_THREAD__)
// oneTBB is not built with the thread sanitizer, which would see races that are not there. The counter orders
// nothing between the threads, so that every race that is there can be seen.
void run_all(std::size_t chunks, unsigned threads, const Run& run) {
  std::atomic<std::size_t> next{0};
  std::mutex guard;
  std::exception_ptr thrown;
  const auto work = [&] {
    try {
      for (std::size_t k = 0; (k = next.fetch_add(1, std::memory_order_relaxed)) < chunks;) run(k);
    } catch (...) {
      next = chunks;
      const std::scoped_lock lock(guard);
      thrown = std::current_exception();
    }
  };
  std::vector<std::thread> workers;
  const unsigned all = std::max(2U, std::thread::hardware_concurrency());
  for (unsigned i = 0; i < (threads == 0 ? all : threads); ++i) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  if (thrown) std::rethrow_exception(thrown);
}
#else
void run_all(std::size_t chunks, unsigned threads, const Run& run) {
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, chunks, run); });
}
#endif

}  // namespace

void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const auto run = [&](std::size_t k) { body(k * chunk, std::min(count, (k + 1) * chunk)); };
  if (threads == 1 || chunks < 2) {
    for (std::size_t k = 0; k < chunks; ++k) run(k);
    return;
  }
  run_all(chunks, threads, run);
}

}  // namespace gouge
