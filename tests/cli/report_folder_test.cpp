#include "cli/report_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace gouge {
namespace {

namespace fs = std::filesystem;

TEST(ReportFolder, OnlyFilesOfAnOlderReportAreRemoved) {
  const std::string folder = testing::TempDir() + "gouge_report_folder_" + std::to_string(::getpid());
  fs::create_directories(folder + "/event_5.png");
  const std::set<std::string> foreign = {"event_10.png", "event_.png",  "event_2.PNG",  "event_02.png", "event_0.png",
                                         "my.png",       "result.jsonl", "event_2.png~", "moves.csv.bak"};
  for (const std::string& name : foreign) std::ofstream(folder + "/" + name) << "mine";
  for (const char* name : {"event_1.png", "event_2.png", "event_3.png", "before_after.png", "heat_map.png",
                           "depth_along_path.png", "report.html", "result.json", "moves.csv"})
    std::ofstream(folder + "/" + name) << "ours";
  std::vector<NamedFile> written(4);
  written[0].name = "report.html";
  written[1].name = "result.json";
  written[2].name = "moves.csv";
  written[3].name = "event_1.png";
  EXPECT_TRUE(remove_older_report(folder, written).empty());
  std::set<std::string> expected = foreign;
  expected.insert({"report.html", "result.json", "moves.csv", "event_1.png", "event_5.png"});
  std::set<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder)) left.insert(entry.path().filename().string());
  EXPECT_EQ(left, expected) << "event_5.png is a folder";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace gouge
