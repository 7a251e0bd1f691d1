#include "cli/overwriting.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gouge {
namespace {

TEST(Overwriting, OutputsAreNeitherInputsNorOneAnother) {
  const std::string folder = testing::TempDir() + "overwriting";
  std::filesystem::create_directories(folder);
  const std::string path = folder + "/a.apt", part = folder + "/part.stl", same = folder + "/./b/../part.stl";
  std::ofstream(path) << "GOTO/0,0,0";
  std::ofstream(part) << "solid";
  std::filesystem::create_directories(folder + "/b");
  const auto told = [&](const std::vector<FileOption>& outputs) {
    const auto error = find_overwriting({{"the toolpath", path}, {"the part", part}}, outputs);
    return error ? error->message : std::string();
  };
  EXPECT_EQ(told({{"--csv", folder + "/new.csv"}, {"--json", "-"}, {"--sarif", ""}, {"--junit", "-"}}), "");
  EXPECT_EQ(told({{"--csv", path}}), "--csv '" + path + "' is the toolpath itself; name another file");
  EXPECT_EQ(told({{"--json", same}}), "--json '" + same + "' is the part itself; name another file");
  EXPECT_EQ(told({{"--csv", folder + "/x"}, {"--json", folder + "/b/../x"}}),
            "--json '" + folder + "/b/../x' is the file of --csv as well; name another file");
}

TEST(Overwriting, EveryInputOfAJobIsSpared) {
  JobArguments job;
  job.path = "path.apt";
  job.parts = {"part.stl"};
  job.fixtures = {"vise.stl"};
  job.heads = {"head.stl"};
  job.tools_file = "tools.json";
  EXPECT_FALSE(find_overwriting(job, "corrected.apt"));
  for (const char* file : {"path.apt", "part.stl", "vise.stl", "head.stl", "tools.json"}) {
    EXPECT_TRUE(find_overwriting(job, file)) << file;
    for (std::string JobArguments::*output :
         {&JobArguments::json_file, &JobArguments::csv_file, &JobArguments::sarif_file, &JobArguments::junit_file}) {
      JobArguments writing = job;
      writing.*output = file;
      EXPECT_TRUE(find_overwriting(writing, "")) << file;
    }
  }
}

}  // namespace
}  // namespace gouge
