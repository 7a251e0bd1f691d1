#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "lib/base/files.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/support/source_folder.h"

namespace gouge::bad_input_test {
namespace {

std::string only_error(const std::string& text) {
  const ReadOutcome outcome = read_toolpath("bad.apt", text);
  EXPECT_FALSE(outcome.toolpath);
  EXPECT_EQ(outcome.errors.size(), 1u);
  return outcome.errors.empty() ? std::string() : to_text(outcome.errors.front());
}

TEST(BadPath, AnErrorInALastLineWithoutAnEndMayBeACut) {
  const std::string cut = "; this is the last line, without an end: the file may be cut off";
  const std::string start = "UNITS/MM\nGOTO/1,2,3\n";
  EXPECT_NE(only_error(start + "GOTO/4,5").find(cut), std::string::npos);
  EXPECT_EQ(only_error(start + "GOTO/4,5\n").find(cut), std::string::npos);
  EXPECT_EQ(only_error(start + "GOTO/4,5\nGOTO/6,7,8").find(cut), std::string::npos) << "another line";
}

TEST(BadPath, NoFileOfCutterPositions) {
  EXPECT_EQ(only_error(""),
            "bad.apt: error: the file is empty; expected APT CL data, an NX CLSF, a binary NCCS or a Mastercam NCI "
            "file, or a program of a machine with --control [path-empty]");
  EXPECT_EQ(only_error("UNITS/MM\nFINI\n"),
            "bad.apt: error: holds no position; expected APT CL data, an NX CLSF, a binary NCCS or a Mastercam NCI "
            "file, or a program of a machine with --control; the first line is \"UNITS/MM\" [path-no-motion]");
  EXPECT_EQ(only_error("1.0 2.0 3.0\n4.0 5.0 6.0\n"),
            "bad.apt: error: holds columns of numbers without words, so what they mean is not stated; expected "
            "GOTO/x,y,z,i,j,k [path-not-cl-data]");
  EXPECT_EQ(only_error("\n\n\n"),
            "bad.apt: error: holds no position; expected APT CL data, an NX CLSF, a binary NCCS or a Mastercam NCI "
            "file, or a program of a machine with --control [path-no-motion]");
}

TEST(BadPath, BytesThatAreNoText) {
  EXPECT_EQ(only_error(std::string("GOTO/1,2,3\nGO\0TO/1,2,3\n", 23)),
            "bad.apt:2: error: is not text: byte 0 at position 13; expected APT CL data, an NX CLSF, a binary NCCS or "
            "a Mastercam NCI file, or a program of a machine with --control [path-binary]");
  const std::string ncl("\x11\x00\xe8\x1c\x00\x00\x00\x00    ", 12);
  EXPECT_EQ(only_error(ncl),
            "bad.apt:1: error: the file ends within this record, or the record has no length: it is cut short or "
            "damaged [path-unterminated]");
}

TEST(BadPath, NumbersThatAreNone) {
  for (const char* number : {"1.2.3", "nan", "1e400", "-inf", "1,,2", "12mm"}) {
    const std::string text = "GOTO/0,0,0\nGOTO/1,2," + std::string(number) + "\n";
    const std::string error = only_error(text);
    EXPECT_NE(error.find("bad.apt:2: error: GOTO: "), std::string::npos) << error;
    EXPECT_NE(error.find("is not a finite number; expected x,y,z or x,y,z,i,j,k in numbers [path-number]"),
              std::string::npos)
        << error;
  }
}

TEST(BadPath, DecimalCommasAreNamed) {
  for (const char* text : {"GOTO/1,5,2,25,3,5\n", "GOTO/1,5,2,25\n"})
    EXPECT_NE(only_error(text).find("; write a decimal point, not a comma, if that is meant"), std::string::npos)
        << text;
  EXPECT_EQ(only_error("GOTO/1.5,2,25,3\n").find("comma"), std::string::npos) << "it has a point";
}

TEST(BadPath, WrongCountsAndAxes) {
  EXPECT_EQ(only_error("GOTO/1,2,3,0,1\n"),
            "bad.apt:1: error: GOTO has 5 numbers; expected x,y,z or x,y,z,i,j,k [path-count]");
  EXPECT_EQ(only_error("GOTO/\n"), "bad.apt:1: error: GOTO has 0 numbers; expected x,y,z or x,y,z,i,j,k [path-count]");
  EXPECT_EQ(only_error("GOTO/1,2,3,0,0,0\n"),
            "bad.apt:1: error: GOTO: the tool axis has length 0.000000; expected a unit vector i,j,k (length 1 within "
            "0.001) [path-axis]");
  EXPECT_EQ(only_error("GOTO/1,2,3,0,0,1.002\n"),
            "bad.apt:1: error: GOTO: the tool axis has length 1.002000; expected a unit vector i,j,k (length 1 within "
            "0.001) [path-axis]");
  EXPECT_EQ(only_error("MULTAX\nGOTO/1,2,3,4,5,6,7,8,9\n"),
            "bad.apt:2: error: GOTO has 9 numbers; expected x,y,z or x,y,z,i,j,k [path-count]");
  EXPECT_EQ(
      only_error("GOTO/1,2,3e9\n"),
      "bad.apt:1: error: GOTO: a coordinate is beyond 10000000 mm; expected a position within a machine [path-range]");
}

TEST(BadPath, ToolsThatCannotBe) {
  EXPECT_EQ(only_error("CUTTER/10,6\nGOTO/1,2,3\n"),
            "bad.apt:1: error: CUTTER: corner radius 6 is larger than half the diameter 10; expected d or d,r or "
            "d,r,e,f,alpha,beta,h [path-cutter]");
  EXPECT_EQ(only_error("CUTTER/10,1,4\nGOTO/1,2,3\n"),
            "bad.apt:1: error: CUTTER: found 3 numbers; expected d or d,r or d,r,e,f,alpha,beta,h [path-cutter]");
  EXPECT_EQ(only_error("LOADTL/1.5\nGOTO/1,2,3\n"),
            "bad.apt:1: error: LOADTL: \"1.5\" is not a tool number; expected a whole number [path-statement]");
}

TEST(BadPath, AFileCutWithinAStatement) {
  EXPECT_EQ(only_error("GOTO/1,2,3\nGOTO/1,2,$\n"),
            "bad.apt:2: error: the file ends within a statement that a $ continues; expected its next line: the file "
            "is cut short [path-unterminated]");
}

TEST(BadPath, PartProgramsAreRefusedOnce) {
  for (const char* text :
       {"partno x\npl1=plane/1,0,0,4\ngo/to,pl1\n", "TP(1) =POINT/60.85,25.475\n", "d=.5\ngoto/1,2,3\n",
        "tllft,gofwd/pl5,on,pl2\n", "goto/setpt2\n", "from/setpt1,-1,0,0\n", "cutter/d\n"}) {
    EXPECT_NE(only_error(text).find("is an APT part program ("), std::string::npos) << text;
  }
  EXPECT_EQ(only_error("partno x\npl1=plane/1,0,0,4\ngo/to,pl1\n"),
            "bad.apt:2: error: is an APT part program (\"pl1=plane\"); expected CL data with positions in numbers: run "
            "it through an APT system and check the CL file that gives [path-part-program]");
}

TEST(BadPath, AtMostTwentyErrorsAreListed) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "GOTO/1,2\n";
  const ReadOutcome outcome = read_toolpath("bad.apt", text);
  ASSERT_EQ(outcome.errors.size(), 21u);
  EXPECT_EQ(to_text(outcome.errors.back()), "bad.apt: error: and 10 more errors [path-more-errors]");
}

TEST(BadPath, FramesThatAreNone) {
  EXPECT_EQ(
      only_error("TOOL PATH/A,TOOL,B\nMSYS/0,0,0,1,0,0,1,0,0\nGOTO/1,2,3\nEND-OF-PATH\n"),
      "bad.apt:2: error: MSYS: the axes are not two unit vectors at right angles; expected X and Y axis [path-frame]");
  EXPECT_EQ(
      only_error("TOOL PATH/A,TOOL,B\nMSYS/0,0,0\nGOTO/1,2,3\nEND-OF-PATH\n"),
      "bad.apt:2: error: MSYS has 3 arguments; expected 9 numbers: the origin, the X axis and the Y axis [path-frame]");
}

TEST(BadPath, GodltaNeedsAPlaceToMoveFrom) {
  EXPECT_EQ(only_error("GODLTA/0,0,1\n"),
            "bad.apt:1: error: GODLTA moves on from a position that is not known; expected a FROM or GOTO before it "
            "[path-statement]");
}

// Limits that keep the memory of reading a small multiple of the file.
TEST(BadPath, MoreThanAnyCamSystemWrites) {
  std::string list = "GOTO/0,0,0\nGOTO/";
  for (int i = 0; i < 50000; ++i) list += "1,1,";
  EXPECT_EQ(only_error(list + "1,1\n"),
            "bad.apt:2: error: GOTO has 100000 arguments or more; expected a statement as CAM systems write it: divide "
            "it into several [path-count]");
  std::string tools;
  for (int i = 1; i <= 10001; ++i) tools += "LOADTL/" + std::to_string(i) + "\nGOTO/1,1,1\n";
  EXPECT_EQ(only_error(tools),
            "bad.apt:20002: error: more than 10000 different tools; expected those of a machine: divide the file by "
            "operations [path-tools]");
}

// One small file for each kind of bad input; the start of its name is the code it must be refused with.
TEST(BadPath, EveryFileOfTheCorpusIsRefusedWithItsCode) {
  const std::filesystem::path folder = source_folder() + "/tests/corpus/apt";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const Result<std::string> bytes = read_file(entry.path().string());
    ASSERT_TRUE(bytes.has_value());
    const ReadOutcome outcome = read_toolpath(name, *bytes);
    ASSERT_FALSE(outcome.errors.empty()) << name;
    EXPECT_EQ(outcome.errors.front().code, name.substr(0, name.find("--"))) << to_text(outcome.errors.front());
    ++files;
  }
  EXPECT_GE(files, 12u);
}

}  // namespace
}  // namespace gouge::bad_input_test
