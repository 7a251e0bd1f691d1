#include "cli/machine/program_files.h"
#include "cli/machine/program_facts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "tests/support/temporary_folder.h"

namespace gouge::program_files_test {
namespace {

namespace fs = std::filesystem;

using Texts = std::vector<std::string>;

class ProgramFiles : public ::testing::Test {
 protected:
  ProgramFiles() {
    fs::create_directories(folder_ / "O9.nc");  // a folder is no program
  }

  /// Writes files that hold their names.
  void add(const Texts& names) const {
    for (const std::string& name : names) ASSERT_TRUE(write_file((folder_ / name).string(), name));
  }
  [[nodiscard]] Texts called(const std::string& name) const {
    SearchLog searches;
    return with_files_beside({}, (folder_ / "main.nc").string(), 1000, searches,
                             [](const std::string&, const Result<std::string>&) {})
        ->read_beside(name);
  }

  testing_support::TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
};

TEST_F(ProgramFiles, OfANumberHaveAnyZerosAndEndings) {
  for (const char* file : {"O2", "O0002.nc", "o00002.NC", "O2.txt", "O002.cnc"}) {
    add({file});
    EXPECT_EQ(called("O2"), Texts{file});
    fs::remove(folder_ / file);
  }
  add({"O20.nc", "O2.bak", "O2a.nc", "2.nc"});
  EXPECT_EQ(called("O2"), Texts{});
  EXPECT_EQ(called("O9"), Texts{});
}

TEST_F(ProgramFiles, ThatMayBothBeMeantAreBothRead) {
  add({"O2.nc", "O00002.nc"});
  EXPECT_EQ(called("O2"), (Texts{"O00002.nc", "O2.nc"}));
}

TEST_F(ProgramFiles, OfANameWithAnEndingAreThatFileAlone) {
  add({"pos.ngc", "pos.ngc.nc", "pos.nc", "POS.ngc"});
  EXPECT_EQ(called("pos.ngc"), Texts{"pos.ngc"});
  EXPECT_EQ(called("pos"), (Texts{"pos.nc", "pos.ngc"}));
  EXPECT_EQ(called("../pos.ngc"), Texts{});
}

TEST(ToolLengths, MayBeginWithAByteOrderMark) {
  for (const std::string table : {"tool,length\n6,120.5\n", "T6 Z120.5\n"}) {
    const auto lengths = parse_tool_lengths("lengths.csv", "\xef\xbb\xbf" + table);
    ASSERT_TRUE(lengths) << lengths.error().message;
    EXPECT_EQ(lengths->lengths_mm, (std::map<int, double>{{6, 120.5}}));
  }
}

TEST(ToolLengths, OfALinuxCncTableStandBesideDiameters) {
  const auto table = parse_tool_lengths("mill.tbl", "T1 P1 D12.7 Z+80\nT2 P2 Z60\nT3 P3 D-1 Z60\n");
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_EQ(table->lengths_mm, (std::map<int, double>{{1, 80}, {2, 60}, {3, 60}}));
  EXPECT_EQ(table->diameters_mm, (std::map<int, double>{{1, 12.7}}));
  EXPECT_FALSE(parse_tool_lengths("mill.tbl", "T1 Dx Z80\n"));
}

}  // namespace
}  // namespace gouge::program_files_test
