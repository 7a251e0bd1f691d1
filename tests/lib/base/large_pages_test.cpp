#include "lib/base/large_pages.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace gouge::large_pages_test {
namespace {

TEST(LargePages, ReservedMemoryIsThereForAllItems) {
  for (const std::size_t count : {0U, 1U, 1000U, 3000000U}) {
    std::vector<int> items;
    reserve_large(items, count);
    EXPECT_GE(items.capacity(), count);
    const int* const start = items.data();
    items.resize(count);
    EXPECT_EQ(items.data(), start);
    std::iota(items.begin(), items.end(), 0);
    EXPECT_TRUE(count == 0 || items.back() == static_cast<int>(count) - 1);
  }
}

TEST(LargePages, AskingChangesNothingInTheMemoryNorBesideIt) {
  std::vector<int> items(4000000);
  std::iota(items.begin(), items.end(), 0);
  for (const std::size_t shift : {0U, 1U, 77U, 1000U}) {
    ask_for_large_pages(items.data() + shift, (items.size() - 2 * shift) * sizeof(int));
  }
  for (std::size_t i = 0; i < items.size(); ++i) ASSERT_EQ(items[i], static_cast<int>(i));
}

}  // namespace
}  // namespace gouge::large_pages_test
