#include "postproc/store/work_store.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace gouge::work_store_test {
namespace {

namespace fs = std::filesystem;

using testing_support::TemporaryFolder;

TEST(WorkStore, KeepsEveryByteOfEachStretchForTheNextToOpenIt) {
  const TemporaryFolder folder;
  const std::string file = folder.at("below/job.work");
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
  const TemporaryFolder folder;
  const std::string file = folder.at("below/job.work");
  WorkStore(file, 1).keep("moves", 0, "lost");
  std::ofstream(file, std::ios::trunc) << std::string(5000, 'x');
  WorkStore store(file, 1);
  EXPECT_EQ(store.find("moves", 0), std::nullopt);
  store.keep("moves", 0, "new");
  EXPECT_EQ(store.find("moves", 0), "new");
}

TEST(WorkStore, IsOfOneAtATimeAndKeepsNothingForAnother) {
  const TemporaryFolder folder;
  const std::string file = folder.at("below/job.work");
  WorkStore store(file, 1);
  store.keep("moves", 0, "mine");
  WorkStore other(file, 1);
  other.keep("moves", 0, "theirs");
  EXPECT_EQ(other.find("moves", 0), std::nullopt);
  EXPECT_EQ(store.find("moves", 0), "mine");
}

TEST(WorkStore, KeepsNothingWhereNoFolderCanBeMade) {
  const TemporaryFolder folder;
  const std::string file = folder.at("below/job.work");
  fs::create_directories(fs::path(file).parent_path().parent_path());
  std::ofstream(fs::path(file).parent_path()) << "a file";
  WorkStore store(file, 1);
  store.keep("moves", 0, "lost");
  EXPECT_EQ(store.find("moves", 0), std::nullopt);
}

TEST(WorkStore, IsRemovedWithWhatIsBesideIt) {
  const TemporaryFolder folder;
  const std::string file = folder.at("below/job.work");
  WorkStore(file, 1).keep("moves", 0, "done");
  remove_work_store(file);
  EXPECT_TRUE(fs::is_empty(fs::path(file).parent_path()));
  remove_work_store(file);
}

}  // namespace
}  // namespace gouge::work_store_test
