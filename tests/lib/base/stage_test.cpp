#include "lib/base/stage.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace gouge::stage_test {
namespace {

struct Report {
  std::string stage;
  std::size_t done, total;
};

ProgressCall into(std::vector<Report>& reports) {
  return [&reports](std::string_view stage, std::size_t done, std::size_t total) {
    reports.push_back({std::string(stage), done, total});
  };
}

TEST(Stage, CountsItemsWhoseWorkIsDone) {
  std::vector<Report> reports;
  const ProgressCall call = into(reports);
  Stage stage(call, "reading part.stl", 100, 600);
  stage.add(300);
  stage.add(300);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0].done, 0U);
  EXPECT_EQ(reports[1].done, 50U);
  EXPECT_EQ(reports[2].done, 100U);
  EXPECT_EQ(reports[2].total, 100U);
  EXPECT_EQ(reports[2].stage, "reading part.stl");
}

TEST(Stage, ReportsAThousandTimesAtTheMostAndNeverBackwards) {
  constexpr std::size_t kItems = 10'000'000;
  for (const unsigned threads : {1U, 4U}) {
    std::vector<Report> reports;
    const ProgressCall call = into(reports);
    Stage stage(call, "indexing the parts", kItems);
    for_each_chunk(kItems, 50'000, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) stage.pass(i);
    });
    EXPECT_GT(reports.size(), 100U);
    EXPECT_LE(reports.size(), 1001U);
    for (std::size_t k = 1; k < reports.size(); ++k) EXPECT_LT(reports[k - 1].done, reports[k].done);
    EXPECT_GT(reports.back().done, kItems * 99 / 100);
    EXPECT_LE(reports.back().done, kItems);
  }
}

TEST(Stage, MoreWorkThanWasExpectedIsNoMoreThanAll) {
  std::vector<Report> reports;
  const ProgressCall call = into(reports);
  Stage stage(call, "sorting", 10, 0);
  stage.add(50);
  stage.add(50);
  ASSERT_EQ(reports.size(), 2U);
  EXPECT_EQ(reports[1].done, 10U);
}

TEST(Stage, IsSilentWhereNobodyAsks) {
  const ProgressCall nobody;
  Stage stage(nobody, "reading", 10);
  stage.add(10);
}

}  // namespace
}  // namespace gouge::stage_test
