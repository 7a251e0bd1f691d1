#include "lib/base/paged_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <thread>
#include <utility>

#include "lib/base/parallel.h"

namespace gouge::paged_memory_test {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20U;

/// Limits of one test.
class Limits {
 public:
  explicit Limits(const PagedLimits& limits) : before_(set_paged_limits(limits)) {}
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;
  ~Limits() { set_paged_limits(before_); }

 private:
  PagedLimits before_;
};

std::size_t resident_file_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t all = 0, resident = 0, of_files = 0;
  file >> all >> resident >> of_files;
  return of_files * 4096;
}

std::uint64_t item(std::uint64_t k) { return k * 0x9e3779b97f4a7c15ULL; }

PagedVector<std::uint64_t> filled(std::size_t count) {
  PagedVector<std::uint64_t> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back(item(k));
  return all;
}

std::size_t wrong_items(const PagedVector<std::uint64_t>& all) {
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < all.size(); ++k) wrong += all[k] == item(k) ? 0U : 1U;
  return wrong;
}

TEST(PagedMemory, StandsInAFileFromTheLimitOn) {
  const Limits limits({kMegabyte, kMegabyte});
  const PagedVector<char> small(kMegabyte - 1);
  EXPECT_EQ(paged_arrays(), 0U);
  {
    const PagedVector<char> large(kMegabyte);
    EXPECT_EQ(paged_arrays(), 1U);
  }
  EXPECT_EQ(paged_arrays(), 0U);
}

TEST(PagedMemory, StaysInPlainMemoryWhileAllArraysTogetherAreSmall) {
  const Limits limits({kMegabyte, kMegabyte, 4 * kMegabyte});
  const PagedVector<char> plain(2 * kMegabyte);
  auto freed = std::make_unique<PagedVector<char>>(2 * kMegabyte);
  EXPECT_EQ(paged_arrays(), 0U);
  const PagedVector<char> in_file(kMegabyte);
  EXPECT_EQ(paged_arrays(), 1U);
  freed.reset();
  const PagedVector<char> plain_again(2 * kMegabyte);
  EXPECT_EQ(paged_arrays(), 1U) << "the freed array makes room";
  const PagedVector<char> larger(5 * kMegabyte);
  EXPECT_EQ(paged_arrays(), 2U);
}

TEST(PagedMemory, KeepsWhatIsWrittenWhileItGrowsAndItsPagesAreLetGo) {
  const Limits limits({1, 0});
  PagedVector<std::uint64_t> all = filled(4 * kMegabyte);
  EXPECT_EQ(wrong_items(all), 0U);
  const PagedVector<std::uint64_t> copy = all;
  all.front() = 1;
  EXPECT_EQ(wrong_items(copy), 0U);
  const PagedVector<std::uint64_t> moved = std::move(all);
  EXPECT_EQ(wrong_items(moved), 1U);
}

TEST(PagedMemory, IsFreedAsItWasMadeWhateverTheLimitIsThen) {
  PagedVector<std::uint64_t> plain = filled(1000);
  const Limits limits({1, 0});
  PagedVector<std::uint64_t> paged = filled(1000);
  {
    const Limits none({static_cast<std::size_t>(-1), 0});
    paged = PagedVector<std::uint64_t>();
    EXPECT_EQ(paged_arrays(), 0U);
  }
  plain = PagedVector<std::uint64_t>();
}

TEST(PagedMemory, HoldsNoMoreThanTheLimitOfWhatNobodyUses) {
  const Limits limits({kMegabyte, 16 * kMegabyte});
  const PagedVector<std::uint64_t> all = filled(32 * kMegabyte);
  for (int k = 0; k < 500 && resident_file_bytes() > 64 * kMegabyte; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_LE(resident_file_bytes(), 64 * kMegabyte);
  EXPECT_EQ(wrong_items(all), 0U);
}

TEST(PagedMemory, TakesWhatManyThreadsWriteMeanwhile) {
  const Limits limits({1, 0});
  PagedVector<std::uint64_t> all(8 * kMegabyte);
  for_each_chunk(all.size(), 1000, 4, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) all[k] = item(k);
  });
  EXPECT_EQ(wrong_items(all), 0U);
}

TEST(PagedMemory, IsPlainWhereThereIsNoRoomForAFile) {
  const Limits limits({1, 0});
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before != nullptr ? before : "";
  ::setenv("TMPDIR", "/no/such/folder", 1);
  EXPECT_EQ(wrong_items(filled(100'000)), 0U);
  const PagedVector<char> array(1000);
  EXPECT_EQ(paged_arrays(), 0U);
  before != nullptr ? ::setenv("TMPDIR", kept.c_str(), 1) : ::unsetenv("TMPDIR");
}

}  // namespace
}  // namespace gouge::paged_memory_test
