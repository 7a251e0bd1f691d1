#include "lib/base/checkpoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

namespace gouge::checkpoints_test {
namespace {

using Chunk = std::pair<std::size_t, std::size_t>;

class InMemory : public CheckpointStore {
 public:
  explicit InMemory(std::size_t items) : items_(items) {}
  [[nodiscard]] std::size_t items() const override { return items_; }
  [[nodiscard]] std::optional<std::string> find(std::string_view stage, std::size_t stretch) override {
    const auto found = all.find({std::string(stage), stretch});
    return found == all.end() ? std::nullopt : std::optional(found->second);
  }
  void keep(std::string_view stage, std::size_t stretch, std::string_view bytes) override {
    all[{std::string(stage), stretch}] = bytes;
  }

  std::map<std::pair<std::string, std::size_t>, std::string> all;

 private:
  std::size_t items_;
};

/// Squares of the numbers up to `count`, and which chunks were worked out for them.
struct Squares {
  std::vector<std::size_t> all;
  std::set<Chunk> chunks;

  Squares(std::size_t count, std::size_t chunk, CheckpointStore* kept, unsigned threads = 3) : all(count) {
    CheckpointForm form;
    form.write = [&](std::size_t first, std::size_t last) {
      return std::string(reinterpret_cast<const char*>(&all[first]), (last - first) * sizeof(std::size_t));
    };
    form.read = [&](std::size_t first, std::size_t last, std::string_view bytes) {
      if (bytes.size() != (last - first) * sizeof(std::size_t)) return false;
      bytes.copy(reinterpret_cast<char*>(&all[first]), bytes.size());
      return true;
    };
    std::mutex guard;
    for_each_checkpointed_chunk(count, chunk, threads, "squares", {}, kept, form,
                                [&](std::size_t first, std::size_t last) {
                                  for (std::size_t k = first; k < last; ++k) all[k] = k * k;
                                  const std::scoped_lock lock(guard);
                                  chunks.emplace(first, last);
                                });
  }
};

TEST(CheckpointStore, HasTheChunksAndResultsOfWorkThatIsNotKept) {
  const Squares plain(1003, 8, nullptr);
  for (const std::size_t items : {1U, 8U, 9U, 100U, 1002U}) {
    InMemory kept(items);
    const Squares first(1003, 8, &kept);
    EXPECT_EQ(first.all, plain.all) << items;
    EXPECT_EQ(first.chunks, plain.chunks) << items;
    const Squares again(1003, 8, &kept);
    EXPECT_EQ(again.all, plain.all) << items;
    EXPECT_TRUE(again.chunks.empty()) << items;
  }
}

TEST(CheckpointStore, DoesWhatIsMissingOrDoesNotReadAsItsStretch) {
  const Squares plain(1000, 8, nullptr);
  InMemory kept(80);
  Squares(1000, 8, &kept);
  ASSERT_EQ(kept.all.size(), 13U);
  kept.all.erase({"squares", 3});
  kept.all[{"squares", 5}] = "no squares";
  const Squares again(1000, 8, &kept);
  EXPECT_EQ(again.all, plain.all);
  EXPECT_EQ(again.chunks.size(), 20U);
  EXPECT_TRUE(again.chunks.contains({240, 248}) && again.chunks.contains({472, 480}));
  EXPECT_TRUE(Squares(1000, 8, &kept).chunks.empty());
}

TEST(CheckpointStore, KeepsNothingOfWorkOfOneStretch) {
  InMemory kept(1000);
  Squares(1000, 8, &kept);
  EXPECT_TRUE(kept.all.empty());
}

TEST(CheckpointStore, ReportsAllOfTheWorkInOrder) {
  InMemory kept(16);
  std::vector<std::size_t> done;
  const auto report = [&](std::string_view stage, std::size_t now, std::size_t total) {
    EXPECT_EQ(stage, "squares");
    EXPECT_EQ(total, 100U);
    done.push_back(now);
  };
  for_each_checkpointed_chunk(100, 4, 2, "squares", report, &kept,
                              {[](std::size_t, std::size_t) { return std::string(); },
                               [](std::size_t, std::size_t, std::string_view) { return true; }},
                              [](std::size_t, std::size_t) {});
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
  EXPECT_EQ(done.front(), 0U);
  EXPECT_EQ(done.back(), 100U);
}

}  // namespace
}  // namespace gouge::checkpoints_test
