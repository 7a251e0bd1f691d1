#include "lib/hierarchy/cut_entries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "tests/support/scatter.h"

namespace gouge::detail::cut_entries_test {
namespace {

std::vector<Entry> random_entries(std::size_t count, unsigned seed, int places) {
  test::Scatter random(seed);
  std::vector<Entry> entries(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    entries[i].triangle = i;
    for (float& x : entries[i].middle)
      x = static_cast<float>(random.next() % static_cast<unsigned>(places)) / 7.0F - 40.0F;
  }
  return entries;
}

bool comes_first(const Entry& a, const Entry& b, std::size_t axis) {
  return a.middle[axis] < b.middle[axis] || (!(b.middle[axis] < a.middle[axis]) && a.triangle < b.triangle);
}

std::set<std::uint32_t> first_triangles(const std::vector<Entry>& entries, std::size_t rank) {
  std::set<std::uint32_t> triangles;
  for (std::size_t i = 0; i < rank; ++i) triangles.insert(entries[i].triangle);
  return triangles;
}

TEST(CutEntries, WhatComesFirstIsWhatASortPutsFirst) {
  for (const int places : {1, 2, 5, 1000, 1000000}) {
    for (const std::size_t count : {2U, 3U, 17U, 64U, 1000U, 5000U}) {
      for (const std::size_t rank : {std::size_t{1}, count / 2, count - 1}) {
        std::vector<Entry> entries = random_entries(count, static_cast<unsigned>(count) + 1, places);
        const std::size_t axis = box_of(entries, std::max(std::size_t{1}, count / 512)).widest_axis();
        std::vector<Entry> sorted = entries, scratch(count);
        std::sort(sorted.begin(), sorted.end(),
                  [axis](const Entry& a, const Entry& b) { return comes_first(a, b, axis); });
        cut_entries(entries, scratch, rank);
        ASSERT_EQ(first_triangles(entries, rank), first_triangles(sorted, rank)) << count << " " << rank;
        ASSERT_EQ(first_triangles(entries, count).size(), count);
      }
    }
  }
}

TEST(CutEntries, SizesFarApartAndHardlyApartAreCut) {
  for (const float size : {1e-38F, 1e-20F, 1e18F, 1e36F}) {
    std::vector<Entry> entries = random_entries(100, 3, 50), scratch(100);
    for (Entry& e : entries) e.middle = {0, e.middle[1] * size, 0};
    cut_entries(entries, scratch, 50);
    float last = -3e38F, first = 3e38F;
    for (std::size_t i = 0; i < 50; ++i) last = std::max(last, entries[i].middle[1]);
    for (std::size_t i = 50; i < 100; ++i) first = std::min(first, entries[i].middle[1]);
    EXPECT_LE(last, first) << size;
    EXPECT_EQ(first_triangles(entries, 100).size(), 100U);
  }
}

TEST(CutEntries, EntriesThatNoSampleSeesAreCutAllTheSame) {
  // The box uses every tenth of 5120 entries; here those are all in one place, or nearly.
  for (const float spread : {0.0F, 1e-30F, 1e-6F, 1.0F}) {
    for (const float far : {1.0F, 1e9F}) {
      std::vector<Entry> entries(5120), scratch(5120);
      for (std::uint32_t i = 0; i < entries.size(); ++i) {
        const float side = i % 2 == 0 ? -far : far;
        entries[i] = {{i % 10 == 0 ? spread * static_cast<float>(i) : side * static_cast<float>(i), 0, 0}, i};
      }
      std::vector<Entry> sorted = entries;
      std::sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) { return comes_first(a, b, 0); });
      cut_entries(entries, scratch, 2048);
      EXPECT_EQ(first_triangles(entries, 2048), first_triangles(sorted, 2048)) << spread << " " << far;
      EXPECT_EQ(first_triangles(entries, 5120).size(), 5120U);
    }
  }
}

TEST(CutEntries, TheWidestAxisIsCut) {
  std::vector<Entry> entries(4), scratch(4);
  entries[0] = {{0, 9, 0}, 0};
  entries[1] = {{1, 0, 5}, 1};
  entries[2] = {{2, 8, 1}, 2};
  entries[3] = {{3, 1, 4}, 3};
  EXPECT_EQ(box_of(entries).widest_axis(), 1U);
  cut_entries(entries, scratch, 2);
  EXPECT_EQ(first_triangles(entries, 2), (std::set<std::uint32_t>{1, 3}));
}

}  // namespace
}  // namespace gouge::detail::cut_entries_test
