#include "cli/batch/settled_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace gouge::settled_files_test {
namespace {

namespace fs = std::filesystem;

using testing_support::TemporaryFolder;

void add(const std::string& file, const std::string& text) { std::ofstream(file, std::ios::app) << text; }

TEST(SettledFiles, CountOnceNobodyHasWrittenThemForASecond) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), file = temporary.at("a.apt");
  SettledFiles files(folder);
  add(file, "GOTO/1,2,3\n");
  EXPECT_TRUE(files.look(10).empty());
  EXPECT_TRUE(files.is_unsettled());
  EXPECT_TRUE(files.look(10.9).empty());
  add(file, "GOTO/1,2,4\n");
  EXPECT_TRUE(files.look(11.1).empty());
  EXPECT_TRUE(files.look(12).empty());
  const FileStamps settled = files.look(12.2);
  ASSERT_TRUE(settled.contains(file));
  EXPECT_EQ(settled.at(file).bytes, 22);
  EXPECT_FALSE(files.is_unsettled());
  // A file that is written again is another file.
  add(file, "FINI\n");
  EXPECT_TRUE(files.look(20).empty());
  EXPECT_NE(files.look(21), settled);
  fs::remove(file);
  EXPECT_TRUE(files.look(30).empty());
  EXPECT_FALSE(files.is_unsettled());
}

TEST(SettledFiles, GoByOurClockNotByTheTimesOfFiles) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path(), file = temporary.at("old.apt");
  SettledFiles files(folder);
  add(file, "FINI\n");
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1000));
  EXPECT_TRUE(files.look(5).empty());
  EXPECT_EQ(files.look(6).size(), 1U);
}

TEST(SettledFiles, PassOverHiddenAndTemporaryOnesAndWhatThePatternLeavesOut) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path();
  for (const char* name : {"a.apt", "b.cls", ".c.apt", "d.apt~", "e.apt.tmp", "f.apt.part", "g.apt.lock"})
    add(folder + "/" + name, "FINI\n");
  fs::create_directories(folder + "/below.apt");
  const auto settled = [](SettledFiles files) {
    static_cast<void>(files.look(0));
    std::string names;
    for (const auto& [path, stamp] : files.look(1)) names += fs::path(path).filename().string() + " ";
    return names;
  };
  EXPECT_EQ(settled(SettledFiles(folder)), "a.apt b.cls ");
  EXPECT_EQ(settled(SettledFiles(folder + "/*.apt")), "a.apt ");
}

TEST(SettledFiles, HoldLinksThatLeadNowhere) {
  const TemporaryFolder temporary;
  fs::create_symlink("nowhere.apt", temporary.at("dead.apt"));
  SettledFiles files(temporary.path());
  static_cast<void>(files.look(0));
  const FileStamps settled = files.look(1);
  ASSERT_EQ(settled.size(), 1U);
  EXPECT_EQ(settled.begin()->first, temporary.at("dead.apt"));
}

TEST(SettledFiles, AreThoseOfAFolderAndBelowItWithoutResultsOfBatches) {
  const TemporaryFolder temporary;
  const std::string folder = temporary.path();
  for (const char* below : {"op10/deep", "own/corrected", "other/corrected", ".hidden"})
    fs::create_directories(folder + "/" + below);
  add(folder + "/other/summary.json", "{}");
  for (const char* name : {"a.apt", "op10/deep/b.apt", "own/corrected/c.apt", "other/corrected/d.apt", ".hidden/e.apt"})
    add(folder + "/" + name, "FINI\n");
  SettledFiles files(folder, folder + "/own");
  static_cast<void>(files.look(0));
  const FileStamps settled = files.look(1);
  EXPECT_EQ(settled.size(), 2U);
  EXPECT_TRUE(settled.contains(folder + "/op10/deep/b.apt"));
  EXPECT_EQ(files.folders().size(), 3U);
  SettledFiles like(folder + "/*.apt");
  static_cast<void>(like.look(0));
  EXPECT_EQ(like.look(1).size(), 1U) << "a pattern is of one folder";
}

TEST(SettledInputs, CountOnceNoneHasChangedForASecond) {
  const TemporaryFolder temporary;
  const std::string part = temporary.at("part.stl");
  SettledInputs inputs({part}, 10);
  EXPECT_TRUE(inputs.look(10).empty());
  add(part, "solid");
  EXPECT_TRUE(inputs.look(11).empty());
  EXPECT_TRUE(inputs.is_unsettled());
  EXPECT_EQ(inputs.look(12).size(), 1U);
  EXPECT_FALSE(inputs.is_unsettled());
  fs::remove(part);
  EXPECT_EQ(inputs.look(13).size(), 1U);
  EXPECT_TRUE(inputs.look(14).empty());
}

}  // namespace
}  // namespace gouge::settled_files_test
