#include "cli/commands/tool_import.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "tests/support/source_folder.h"
#include "tests/support/temporary_folder.h"
#include "toolmodels/tool_library.h"

namespace gouge::tool_import_test {
namespace {

namespace fs = std::filesystem;

class ToolImport : public testing::Test {
 protected:
  void SetUp() override {
    arguments.tools_file = path("shop.json");
    EXPECT_TRUE(write_file(arguments.tools_file, R"({"units":"mm","tools":[],"holders":[{"name":"ER16",
      "segments":[{"lower_diameter":28,"upper_diameter":28,"length":40}]}]})")
                    .has_value());
  }

  [[nodiscard]] std::string path(const std::string& name) const { return folder_.at(name); }

  int run(const std::string& corpus_file) { return run_file(source_folder() + "/tests/corpus/tool/" + corpus_file); }
  int run_file(const std::string& file) {
    arguments.file = file;
    std::ostringstream out_stream, err_stream;
    const int status = run_tool_import(arguments, path("new.json"), out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return status;
  }

  ToolImportArguments arguments;
  std::string out, err;

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(ToolImport, ReportsWhatWasUnderstoodAndWhatWasAssumed) {
  EXPECT_EQ(run("freecad/bull_6.fctb"), kExitClean);
  EXPECT_EQ(err, "");
  EXPECT_EQ(out,
            "tool  name         cutter               flutes  assembly  holder\n"
            "-     Bull nose 6  bull-nose D 6 R 1.5  20      50        none\n" +
                out.substr(out.find("1 tool, lengths in mm")));
  EXPECT_NE(out.find("assumed or left out:\n  tool \"Bull nose 6\": no length below the holder is given; drawn up to "
                     "Length 50 mm, without a holder\n"),
            std::string::npos)
      << out;
}

TEST_F(ToolImport, TheHolderIsTakenFromALibraryOfOurs) {
  arguments.holder = "ER16";
  arguments.stickout = "30";
  EXPECT_EQ(run("freecad/bull_6.fctb"), kExitClean);
  const Result<ToolLibrary> library = read_tool_library("new.json", *read_file(path("new.json")));
  ASSERT_TRUE(library.has_value());
  EXPECT_EQ(library->tools.at(0).holder.at(0).lower_diameter_mm, 28);
  EXPECT_EQ(library->tools.at(0).shank.at(0).length_mm, 10);
  arguments.holder = "HSK";
  EXPECT_EQ(run("freecad/bull_6.fctb"), kExitUsage);
  EXPECT_NE(err.find("has no holder of that name; it has "), std::string::npos) << err;
  arguments.tools_file.clear();
  EXPECT_EQ(run("freecad/bull_6.fctb"), kExitUsage);
}

TEST_F(ToolImport, AToolThatIsLeftOutForAnErrorMakesTheStatusThree) {
  EXPECT_EQ(run("fusion-mill.tools"), kExitInput);
  EXPECT_NE(err.find("error: tool T8 \"Flutes longer than the tool\": LCF 60 mm is greater than OAL 50 mm"),
            std::string::npos)
      << err;
  EXPECT_TRUE(fs::exists(path("new.json"))) << "the others are written";
  EXPECT_NE(out.find("8 tools, lengths in mm\n"), std::string::npos) << out;
}

TEST_F(ToolImport, BitsOfALibraryAreFoundBesideIt) {
  EXPECT_EQ(run("freecad/shop.fctl"), kExitInput) << "two of its bits are not there";
  EXPECT_NE(out.find("3 tools"), std::string::npos) << out;
  EXPECT_NE(err.find("missing.fctb"), std::string::npos) << err;
}

TEST_F(ToolImport, WhatCannotBeReadIsRefusedAndNothingIsWritten) {
  EXPECT_EQ(run("no-such-file.json"), kExitInput);
  arguments.format = "nx";
  EXPECT_EQ(run("fusion-mill.json"), kExitInput);
  EXPECT_NE(err.find("expected an NX tool_database.dat or holder_database.dat [import-format]"), std::string::npos)
      << err;
  EXPECT_FALSE(fs::exists(path("new.json")));
  arguments.format.clear();
  ASSERT_TRUE(
      write_file(path("own.json"), R"({"units": "mm", "tools": [{"number": 1, "cutter": {"shape": "ball"}}]})"));
  EXPECT_EQ(run_file(path("own.json")), kExitInput);
  EXPECT_NE(err.find("is a tool library of gougecheck already; give it with --tools"), std::string::npos) << err;
}

}  // namespace
}  // namespace gouge::tool_import_test
