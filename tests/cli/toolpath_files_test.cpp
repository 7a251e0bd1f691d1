#include "cli/batch/toolpath_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/temporary_folder.h"

namespace gouge::toolpath_files_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(NamesOfToolpaths, AreStemsWhereTheseDiffer) {
  EXPECT_EQ(names_of_toolpaths({"ops/op10.apt", "op20.cls"}), (Names{"op10", "op20"}));
}

TEST(NamesOfToolpaths, GetTheEndingOrTheFoldersThatDiffer) {
  EXPECT_EQ(names_of_toolpaths({"a/op10.apt", "b/op10.cls"}), (Names{"op10.apt", "op10.cls"}));
  EXPECT_EQ(names_of_toolpaths({"a/op10.apt", "b/op10.apt", "op20.apt"}), (Names{"a-op10", "b-op10", "op20"}));
  EXPECT_EQ(names_of_toolpaths({"x/a/op.apt", "y/a/op.apt"}), (Names{"x-a-op", "y-a-op"}));
}

TEST(NamesOfToolpaths, LeaveOutTheVersionsOfCreo) {
  EXPECT_EQ(names_of_toolpaths({"a/op10.ncl.1", "b/op20.apt"}), (Names{"op10", "op20"}));
  EXPECT_EQ(names_of_toolpaths({"op10.ncl.1", "op10.ncl.2"}), (Names{"op10.ncl.1", "op10.ncl.2"}));
}

TEST(NamesOfToolpaths, StayEqualForOneFileGivenTwice) {
  EXPECT_EQ(names_of_toolpaths({"op.apt", "./op.apt"}), (Names{"op.apt", "op.apt"}));
}

struct ToolpathFolder : testing::Test {
  testing_support::TemporaryFolder temporary;
  fs::path root = temporary.path();

  void put(const std::string& name) const {
    fs::create_directories((root / name).parent_path());
    std::ofstream(root / name) << "x";
  }
};

TEST_F(ToolpathFolder, HasTheToolpathsInItAndBelowIt) {
  for (const char* name :
       {"b.APT", "a/c.ncl.1", "a/part.stl", "tools.json", ".old/d.apt", ".e.apt", "night/corrected/f.apt", "g.ngc",
        "old/corrected/h.apt", "old/summary.json", "broken/corrected/i.apt", "broken/results.sqlite"})
    put(name);
  const auto found = expand_folders({root.string(), "h.xyz"}, (root / "night").string(), false);
  ASSERT_TRUE(found);
  EXPECT_EQ(*found, (Names{root / "a/c.ncl.1", root / "b.APT", "h.xyz"}));
  const auto programs = expand_folders({root.string()}, (root / "night").string(), true);
  ASSERT_TRUE(programs);
  EXPECT_EQ(*programs, (Names{root / "g.ngc"}));
}

TEST_F(ToolpathFolder, WithoutToolpathsIsRefused) {
  put("part.stl");
  const auto found = expand_folders({root.string()}, "night", false);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, "usage");
  EXPECT_NE(found.error().message.find("has no toolpath; expected files with an ending such as .apt"),
            std::string::npos);
}

}  // namespace
}  // namespace gouge::toolpath_files_test
