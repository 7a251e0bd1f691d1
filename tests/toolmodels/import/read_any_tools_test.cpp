#include "toolmodels/import/read_any_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "tests/support/temporary_folder.h"
#include "tests/toolmodels/import/import_helpers.h"
#include "toolmodels/tool_library.h"

namespace gouge::read_any_tools_test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1'000'000;

std::string bit(const std::string& name, const std::string& diameter) {
  return R"({"name":")" + name + R"(","shape-type":"Endmill","parameter":{"Diameter":")" + diameter +
         R"(","CuttingEdgeHeight":"18 mm","Length":"50 mm","ShankDiameter":"6 mm"}})";
}

Result<ReadTools> read_any_tools(const std::string& file, std::string_view bytes, std::uint64_t max_bytes) {
  SearchLog searches;
  return gouge::read_any_tools(file, bytes, max_bytes, searches);
}

/// Folders like those of FreeCAD, below one of the test's own.
class ToolFolders : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(fs::path(at(name)).parent_path());
    ASSERT_TRUE(write_file(at(name), text).has_value());
  }
  [[nodiscard]] std::string at(const std::string& name) const { return folder_.at(name); }
  [[nodiscard]] Result<ReadTools> read(const std::string& name) const {
    return read_any_tools(at(name), *read_file(at(name)), kMaxBytes);
  }

 private:
  testing_support::TemporaryFolder folder_;
};

TEST_F(ToolFolders, BitsAreFoundInFoldersOfAnyCase) {
  write("tools/LIBRARY/Mill.fctl", R"({"tools":[{"nr":1,"path":"em6.fctb"},{"nr":2,"path":"sub/EM8.fctb"}]})");
  write("tools/bIT/EM6.FCTB", bit("EM 6", "6 mm"));
  write("tools/bIT/Sub/em8.fctb", bit("EM 8", "8 mm"));
  const Result<ReadTools> tools = read("tools/LIBRARY/Mill.fctl");
  ASSERT_TRUE(tools.has_value()) << to_text(tools.error());
  ASSERT_EQ(tools->library.tools.size(), 2u);
  EXPECT_EQ(tools->library.with_number(2)->name, "EM 8");
  ASSERT_EQ(tools->besides.size(), 2u);
  EXPECT_EQ(tools->besides[0].path, at("tools/bIT/EM6.FCTB"));
}

TEST_F(ToolFolders, AFileOfExactlyThatNameGoesBeforeOneOfAnotherCase) {
  write("Library/Mill.fctl", R"({"tools":[{"nr":1,"path":"em6.fctb"}]})");
  write("bit/em6.fctb", bit("lower", "6 mm"));
  write("Bit/em6.fctb", bit("upper", "6 mm"));
  EXPECT_EQ(read("Library/Mill.fctl")->library.tools.at(0).name, "upper");
}

TEST_F(ToolFolders, FilesThatDifferInCaseAloneAreNotChosenFrom) {
  write("Library/Mill.fctl", R"({"tools":[{"nr":1,"path":"em6.fctb"},{"nr":2,"path":"em8.fctb"}]})");
  write("Library/EM6.fctb", bit("one", "6 mm"));
  write("Library/Em6.fctb", bit("other", "7 mm"));
  write("Library/em8.fctb", bit("EM 8", "8 mm"));
  const Result<ReadTools> tools = read("Library/Mill.fctl");
  ASSERT_TRUE(tools.has_value());
  EXPECT_EQ(tools->library.tools.size(), 1u);
  bool is_reported = false;
  for (const Diagnostic& note : tools->library.notes) {
    if (note.code != "import-beside") continue;
    is_reported = true;
    EXPECT_EQ(note.severity, Severity::warning);
    EXPECT_NE(
        note.message.find("'EM6.fctb' and 'Em6.fctb' differ from it in case alone; rename one of them; it is left out"),
        std::string::npos)
        << note.message;
  }
  EXPECT_TRUE(is_reported);
}

TEST_F(ToolFolders, ABitThatIsNowhereIsReportedWithBothPlaces) {
  write("Library/Mill.fctl", R"({"tools":[{"nr":1,"path":"em6.fctb"}]})");
  SearchLog searches;
  const Result<BesideFile> beside = read_beside(at("Library/Mill.fctl"), "em6.fctb", kMaxBytes, searches);
  ASSERT_FALSE(beside.has_value());
  EXPECT_EQ(to_text(beside.error()),
            at("Library/em6.fctb") + ": error: there is no such file, nor " + at("Bit/em6.fctb") + " [file-not-found]");
  EXPECT_EQ(read("Library/Mill.fctl").error().code, "library-empty");
}

TEST(ReadAnyTools, LibrariesOfOtherProgramsAreReadWithTheirWarnings) {
  const Result<ReadTools> fusion = read_any_tools("shop.tools", test::corpus("fusion-mill.tools"), kMaxBytes);
  ASSERT_TRUE(fusion.has_value()) << to_text(fusion.error());
  const ImportedTools imported = *import_fusion("shop.tools", test::corpus("fusion-mill.tools"), {});
  EXPECT_EQ(write_tool_library(fusion->library), write_tool_library(imported.library));
  EXPECT_EQ(fusion->library.notes.size(), imported.notes.size());
  EXPECT_FALSE(has_error(fusion->library.notes)) << "a tool that is left out is a warning";
  const Result<ReadTools> one = read_any_tools("b.fctb", bit("EM 6", "6 mm"), kMaxBytes);
  ASSERT_TRUE(one.has_value()) << to_text(one.error());
  EXPECT_EQ(one->library.tools.size(), 1u);
}

TEST(ReadAnyTools, OurOwnLibraryIsReadAsEver) {
  const std::string ours =
      R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":"ball","diameter":8,"length":20}}]})";
  EXPECT_EQ(read_any_tools("t.json", ours, kMaxBytes)->library.tools.size(), 1u);
  EXPECT_EQ(read_any_tools("t.json", R"({"tools":[{"number":1,"cutter":{}}]})", kMaxBytes).error().code,
            "library-field");
  EXPECT_EQ(read_any_tools("t.json", R"({"units":"mm","tools":[)", kMaxBytes).error().code, "library-syntax");
}

TEST(ReadAnyTools, ATableOfCamoticsIsRead) {
  const std::string table =
      R"({"1":{"number":1,"units":"metric","shape":"cylindrical","length":20,"diameter":3,"description":"EM 3"},
          "2":{"units":"imperial","shape":"ballnose","length":1,"diameter":0.25},
          "4":{"units":"metric","shape":"conical","length":10,"diameter":20},
          "5":{"units":"metric","shape":"spheroid","length":10,"diameter":5}})";
  for (const std::string& bytes : {table, R"({"units":"metric","tools":)" + table + "}"}) {
    const Result<ReadTools> read = read_any_tools("t.json", bytes, kMaxBytes);
    ASSERT_TRUE(read.has_value()) << to_text(read.error());
    ASSERT_EQ(read->library.tools.size(), 3u);
    EXPECT_EQ(read->library.tools[0].name, "EM 3");
    EXPECT_EQ(read->library.tools[1].number, 2);
    const std::string text = write_tool_library(read->library);
    for (const char* part : {"\"ball\"", "6.35", "\"chamfer\""}) EXPECT_NE(text.find(part), std::string::npos) << text;
    const auto is_left_out = [](const Diagnostic& note) {
      return note.message.find("shape spheroid") != std::string::npos;
    };
    EXPECT_TRUE(std::ranges::any_of(read->library.notes, is_left_out));
  }
}

TEST(ReadAnyTools, ATableOfLinuxcncIsReadWithAnUncertainty) {
  const Result<ReadTools> read = read_any_tools(
      "tool.tbl", "; shop\nT1 P1 D6.0 Z+52.3 ;6 mm end mill\n\nT2 P2 Z10\nT99 P3 X1 D8 Z+40 Q0\n", kMaxBytes);
  ASSERT_TRUE(read.has_value()) << to_text(read.error());
  ASSERT_EQ(read->library.tools.size(), 2u) << "T2 has no diameter";
  EXPECT_EQ(read->library.tools[0].name, "6 mm end mill");
  EXPECT_EQ(read->library.tools[1].number, 99);
  EXPECT_NE(read->library.tools[0].uncertainty.find("states D and Z alone"), std::string::npos);
  EXPECT_FALSE(read_any_tools("a.nc", "T1 M6\nG0 X1\n", kMaxBytes).has_value()) << "a program is no table";
}

TEST(ReadAnyTools, ATableOfLinuxcncKeepsItsUncertaintyInOurFormat) {
  const Result<ReadTools> read = read_any_tools("tool.tbl", "T1 P1 D6 Z50\n", kMaxBytes);
  ASSERT_TRUE(read.has_value());
  const Result<ToolLibrary> again = read_tool_library("lib.json", write_tool_library(read->library));
  ASSERT_TRUE(again.has_value()) << to_text(again.error());
  EXPECT_EQ(again->tools[0].uncertainty, read->library.tools[0].uncertainty);
  ASSERT_EQ(again->notes.size(), 1u);
  EXPECT_EQ(again->notes[0].code, "library-uncertain");
}

TEST(ReadAnyTools, WrongRowsOfATableOfLinuxcncAreNamedByTheirLine) {
  const Result<ImportedTools> made =
      import_tools("tool.tbl", "T1 P1 D6 Z50\nT-1 P2 D3 Z4\nT3 P3 D10,5 Z50\nT4 P4 D0 Z5\n", std::nullopt, {});
  ASSERT_TRUE(made.has_value()) << to_text(made.error());
  EXPECT_EQ(made->library.tools.size(), 1u);
  const std::string notes = test::notes_of(*made, "import-field");
  EXPECT_NE(notes.find("tool.tbl:2: error"), std::string::npos) << notes;
  EXPECT_NE(notes.find("its number is '-1'; expected a whole number from 0"), std::string::npos) << notes;
  EXPECT_NE(notes.find("D, its diameter, is '10,5'; expected a number with a decimal point"), std::string::npos)
      << notes;
  EXPECT_NE(notes.find("tool.tbl:4: error"), std::string::npos) << notes;
}

TEST(ReadAnyTools, AStickOutCountsInATableOfLinuxcncAndIsNamedWhereItDoesNot) {
  ImportOptions options;
  options.stickout_mm = 20;
  options.holder = {{20, 20, 30}};
  const Result<ImportedTools> table = import_tools("tool.tbl", "T1 P1 D6 Z50\n", std::nullopt, options);
  ASSERT_TRUE(table.has_value() && table->library.tools.size() == 1);
  EXPECT_DOUBLE_EQ(length_mm(table->library.tools[0].cutter), 20);
  const std::string fusion = R"({"data":[{"type":"flat end mill","unit":"millimeters","description":"x",)"
                             R"("geometry":{"DC":6,"LCF":18,"OAL":60,"LB":40,"SFDM":6}}]})";
  const Result<ImportedTools> stated = import_tools("a.json", fusion, std::nullopt, options);
  ASSERT_TRUE(stated.has_value() && stated->library.tools.size() == 1);
  EXPECT_NE(test::notes_of(*stated, "import-guess").find("--stickout has no effect: the file states LB 40 mm"),
            std::string::npos)
      << test::all_notes(*stated);
}

TEST(ReadAnyTools, AnyOtherFileIsRefusedWithWhatWasExpected) {
  const std::string expected =
      "expected a tool library of gougecheck (JSON), Fusion (.json or .tools), FreeCAD (.fctl or .fctb), NX "
      "(tool_database.dat), CAMotics (.json) or LinuxCNC (.tbl)";
  const auto error = [](const std::string& bytes) { return to_text(read_any_tools("t", bytes, kMaxBytes).error()); };
  EXPECT_EQ(error(""), "t: error: the file is empty; " + expected + " [library-foreign]");
  EXPECT_EQ(error("<?xml version='1.0'?><tools/>"),
            "t: error: the file is XML; " + expected + ", so export the tools as one of these [library-foreign]");
  EXPECT_EQ(error("GOTO/1,2,3\n"), "t: error: the file is a toolpath (CL data); " + expected + " [library-foreign]");
  EXPECT_EQ(error("tools\n"), "t: error: the file is no tool library; " + expected + " [library-foreign]");
  EXPECT_EQ(error(R"({"tools":[{"key":"flat","diameter":6}]})"),
            "t: error: the JSON in this file is no tool library; " + expected + " [library-foreign]");
  EXPECT_NE(
      error("#CLASS MILL\nFORMAT LIBRF DIA FLEN\nDATA | a | 6 | 20\n").find("gougecheck tool import t -o LIB.json"),
      std::string::npos);
}

TEST(ReadAnyTools, PassesOverAByteOrderMark) {
  const std::string table = "T6 P6 D6.0 Z+52.3 ;6 mm end mill\n";
  ASSERT_EQ(recognise_format(table), ImportFormat::linuxcnc);
  EXPECT_EQ(recognise_format("\xef\xbb\xbf" + table), ImportFormat::linuxcnc);
  const auto made = import_tools("a.tbl", "\xef\xbb\xbf" + table, std::nullopt, {});
  ASSERT_TRUE(made) << made.error().message;
  EXPECT_EQ(made->notes.size(), import_tools("a.tbl", table, std::nullopt, {})->notes.size());
}

}  // namespace
}  // namespace gouge::read_any_tools_test
