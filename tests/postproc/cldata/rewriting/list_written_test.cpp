#include "postproc/cldata/rewriting/list_written.h"

#include <gtest/gtest.h>

#include "postproc/formats/read_toolpath.h"
#include "postproc/formats/write_corrected.h"

namespace gouge::list_written_test {
namespace {

constexpr const char* kText =
    "UNITS/MM\nLOADTL/1\nCUTTER/10,0\nGOTO/0,0,0\nPPRINT one\nGOTO/10,0,0\nGOTO/20,0,0\nFINI\n";

std::vector<std::string> written(const std::vector<PathChange>& changes) {
  const ReadOutcome before = read_toolpath("a.apt", kText);
  const ReadOutcome after = read_toolpath("b.apt", write_corrected(*before.toolpath, changes).value());
  std::vector<std::string> all;
  for (const WrittenStatement& w : list_written(*before.toolpath, changes, *after.toolpath))
    all.push_back(std::string(written_name(w.kind)) + " " + std::to_string(w.line));
  return all;
}

TEST(ListWritten, NothingIsListedWithoutChanges) { EXPECT_TRUE(written({}).empty()); }

TEST(ListWritten, AMovedPositionIsOneChangedRecord) {
  EXPECT_EQ(written({{1, Pose{Vec3(10, 0, 1), Vec3::UnitZ()}, {}}}), (std::vector<std::string>{"changed 6"}));
}

TEST(ListWritten, AnInsertedPositionIsAddedWithTheLineOfTheNewFile) {
  EXPECT_EQ(written({{2, std::nullopt, {Pose{Vec3(15, 0, 1), Vec3::UnitZ()}}}}), (std::vector<std::string>{"added 7"}));
}

TEST(ListWritten, NamesAreThoseOfTheReport) { EXPECT_STREQ(written_name(WrittenKind::removed), "removed"); }

}  // namespace
}  // namespace gouge::list_written_test
