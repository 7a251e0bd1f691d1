#include "lib/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace gouge {
namespace {

using Run = std::function<void(std::size_t)>;

std::atomic<unsigned> default_threads{0};

// True in a thread that works on a chunk: it does nested work alone.
thread_local bool is_at_work = false;

unsigned threads_for(unsigned wanted) {
  if (wanted == 0) wanted = default_threads;
  return wanted == 0 ? std::max(1U, std::thread::hardware_concurrency()) : wanted;
}

// The chunks of one call and the threads that work on them. The counter orders nothing between the threads, so the
// thread sanitizer can see every race.
class Crew {
 public:
  Crew(std::size_t chunks, const Run& run) : chunks_(chunks), run_(run) {}

  // If the system refuses more threads, the existing ones do all of the work: the result is the same.
  void work(std::size_t threads) {
    {
      std::vector<std::jthread> others;
      try {
        others.reserve(threads - 1);
        while (others.size() + 1 < threads) others.emplace_back([this] { work_at_chunks(); });
      } catch (const std::exception&) {
      }
      work_at_chunks();
    }
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void work_at_chunks() noexcept {
    is_at_work = true;
    try {
      for (std::size_t k = 0; (k = next_.fetch_add(1, std::memory_order_relaxed)) < chunks_;) run_(k);
    } catch (...) {
      next_ = chunks_;
      const std::scoped_lock lock(guard_);
      if (!thrown_) thrown_ = std::current_exception();
    }
    is_at_work = false;
  }

  std::size_t chunks_;
  const Run& run_;
  std::atomic<std::size_t> next_{0};
  std::mutex guard_;
  std::exception_ptr thrown_;
};

}  // namespace

void set_default_threads(unsigned threads) { default_threads = threads; }

unsigned usable_threads() { return is_at_work ? 1 : threads_for(0); }

void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads,
                    const std::function<void(std::size_t, std::size_t)>& body) {
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const auto run = [&](std::size_t k) { body(k * chunk, std::min(count, (k + 1) * chunk)); };
  const std::size_t workers = is_at_work ? 1 : std::min<std::size_t>(threads_for(threads), chunks);
  if (workers < 2) {
    for (std::size_t k = 0; k < chunks; ++k) run(k);
    return;
  }
  Crew(chunks, run).work(workers);
}

void for_each_chunk(std::size_t count, std::size_t chunk, unsigned threads, std::string_view stage,
                    const ProgressCall& progress, const std::function<void(std::size_t, std::size_t)>& body) {
  if (!progress) return for_each_chunk(count, chunk, threads, body);
  progress(stage, 0, count);
  std::mutex reported;
  std::size_t done = 0;
  for_each_chunk(count, chunk, threads, [&](std::size_t first, std::size_t last) {
    body(first, last);
    const std::scoped_lock lock(reported);
    done += last - first;
    progress(stage, done, count);
  });
}

}  // namespace gouge
