#include "postproc/store/work_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gouge::work_store_test {
namespace {

namespace fs = std::filesystem;

std::string fresh_file() {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::temp_directory_path() / ("gouge_" + std::string(info->name()));
  fs::remove_all(folder);
  return (folder / "below" / "job.work").string();
}

TEST(WorkStore, KeepsEveryByteOfEachStretchForTheNextToOpenIt) {
  const std::string file = fresh_file();
  const std::string bytes("any\0bytes\xff", 10);
  {
    WorkStore store(file, 100);
    EXPECT_EQ(store.items(), 100U);
    EXPECT_FALSE(store.is_used());
    EXPECT_FALSE(fs::exists(file));
    EXPECT_EQ(store.find("moves", 0), std::nullopt);
    store.keep("moves", 0, bytes);
    store.keep("moves", 1, "first");
    store.keep("moves", 1, "second");
    store.keep("heads", 0, "");
    EXPECT_TRUE(store.is_used());
  }
  WorkStore again(file, 100);
  EXPECT_EQ(again.find("moves", 0), bytes);
  EXPECT_EQ(again.find("moves", 1), "second");
  EXPECT_EQ(again.find("heads", 0), "");
  EXPECT_EQ(again.find("heads", 1), std::nullopt);
}

TEST(WorkStore, BeginsAnewWhereTheFileIsDamaged) {
  const std::string file = fresh_file();
  WorkStore(file, 1).keep("moves", 0, "lost");
  std::ofstream(file, std::ios::trunc) << std::string(5000, 'x');
  WorkStore store(file, 1);
  EXPECT_EQ(store.find("moves", 0), std::nullopt);
  store.keep("moves", 0, "new");
  EXPECT_EQ(store.find("moves", 0), "new");
}

TEST(WorkStore, IsOfOneAtATimeAndKeepsNothingForAnother) {
  const std::string file = fresh_file();
  WorkStore store(file, 1);
  store.keep("moves", 0, "mine");
  WorkStore other(file, 1);
  other.keep("moves", 0, "theirs");
  EXPECT_EQ(other.find("moves", 0), std::nullopt);
  EXPECT_EQ(store.find("moves", 0), "mine");
}

TEST(WorkStore, KeepsNothingWhereNoFolderCanBeMade) {
  const std::string file = fresh_file();
  fs::create_directories(fs::path(file).parent_path().parent_path());
  std::ofstream(fs::path(file).parent_path()) << "a file";
  WorkStore store(file, 1);
  store.keep("moves", 0, "lost");
  EXPECT_EQ(store.find("moves", 0), std::nullopt);
}

TEST(WorkStore, IsRemovedWithWhatIsBesideIt) {
  const std::string file = fresh_file();
  WorkStore(file, 1).keep("moves", 0, "done");
  remove_work_store(file);
  EXPECT_TRUE(fs::is_empty(fs::path(file).parent_path()));
  remove_work_store(file);
}

}  // namespace
}  // namespace gouge::work_store_test
