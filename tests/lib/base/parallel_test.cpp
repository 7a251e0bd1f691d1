#include "lib/base/parallel.h"

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace gouge::parallel_test {
namespace {

// How often each of [0, count) was done, and by how many threads.
struct Done {
  std::vector<int> times;
  std::size_t threads = 0;
};

Done done_by(std::size_t count, std::size_t chunk, unsigned threads) {
  Done done{std::vector<int>(count), 0};
  std::mutex guard;
  std::set<std::thread::id> seen;
  for_each_chunk(count, chunk, threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) ++done.times[i];
    const std::scoped_lock lock(guard);
    seen.insert(std::this_thread::get_id());
  });
  done.threads = seen.size();
  return done;
}

TEST(Parallel, EverythingIsDoneOnceAtAnyNumberOfThreads) {
  for (const unsigned threads : {0U, 1U, 2U, 7U, 100U}) {
    for (const std::size_t count : {0U, 1U, 5U, 1000U})
      EXPECT_EQ(done_by(count, 3, threads).times, std::vector<int>(count, 1)) << count << " by " << threads;
  }
}

TEST(Parallel, OneThreadIsTheCallersAndSoIsTheDefaultOnceItIsOne) {
  EXPECT_EQ(done_by(1000, 1, 1).threads, 1U);
  set_default_threads(1);
  const auto caller = std::this_thread::get_id();
  for_each_chunk(1000, 1, 0, [&](std::size_t, std::size_t) { EXPECT_EQ(std::this_thread::get_id(), caller); });
  set_default_threads(0);
}

TEST(Parallel, ChunksOfAChunkAreDoneByItsThread) {
  std::atomic<int> done{0};
  for_each_chunk(8, 1, 4, [&](std::size_t, std::size_t) {
    const auto outer = std::this_thread::get_id();
    for_each_chunk(8, 1, 4, [&](std::size_t, std::size_t) {
      EXPECT_EQ(std::this_thread::get_id(), outer);
      ++done;
    });
  });
  EXPECT_EQ(done, 64);
}

TEST(Parallel, AnExceptionReachesTheCallerAndTheNextCallWorks) {
  for (const unsigned threads : {1U, 4U}) {
    EXPECT_THROW(for_each_chunk(100, 1, threads,
                                [](std::size_t first, std::size_t) {
                                  if (first == 50) throw std::runtime_error("fifty");
                                }),
                 std::runtime_error);
    EXPECT_EQ(done_by(10, 1, threads).times, std::vector<int>(10, 1));
  }
}

TEST(Parallel, WhereNoThreadMayBeginTheCallerDoesAll) {
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr unsigned kNobody = 65534;  // the limit does not hold for root
    const bool is_other =
        ::geteuid() != 0 || (::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
    const rlimit none{1, 1};
    if (!is_other || ::setrlimit(RLIMIT_NPROC, &none) != 0) ::_exit(2);
    const Done done = done_by(1000, 3, 8);
    ::_exit(done.threads == 1 && done.times == std::vector<int>(1000, 1) ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace gouge::parallel_test
