#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/samples/small_shop.h"

// Paths without a gouge, whose tool may be another one than the library describes: none of them is clean.

namespace gouge::testing_samples::tool_facts_test {
namespace {

constexpr const char* kSegment = R"({"lower_diameter": 20, "upper_diameter": 20, "length": 20)";

/// T1 "s" of 10 mm with `keys` besides, T2 "L" of 40 mm, the holder E, and `beside` next to them.
std::string library(const std::string& keys = "", const std::string& segment_keys = "",
                    const std::string& beside = "") {
  return R"({"units": "mm", "tools": [
    {"number": 1, "name": "s", "cutter": {"shape": "flat", "diameter": 10, "length": 60})" +
         keys + R"(},
    {"number": 2, "name": "L", "cutter": {"shape": "flat", "diameter": 40, "length": 60}}],
   "holders": [{"name": "E", "segments": [)" +
         kSegment + segment_keys + "}]}]" + beside + "}";
}

class ToolFacts : public testing::Test {
 protected:
  /// Returns the exit status of a check of the path along the plate, with the statement `tool` for its tool.
  int status(const std::string& tool, const std::string& tools, std::vector<std::string> more = {}) const {
    shop_.write("tools.json", tools);
    more.insert(more.end(), {"--tools", "tools.json"});
    const Outcome ran = shop_.check("result", path_text(stations(), "PARTNO/SHOP\nUNITS/MM\n" + tool + "\n"), more);
    EXPECT_EQ(shop_.run({"verify", "result.json", "-q"}).exit_status, 0) << ran.out;
    return ran.exit_status;
  }

  SmallShop shop_;
};

TEST_F(ToolFacts, KeysOfSharedPartsOfALibraryAreNotIgnored) {
  const std::string unit = R"(, "unit": "inch")", holder = R"(, "holder": "E")";
  EXPECT_EQ(status("LOADTL/1", library(holder)), 0);
  EXPECT_EQ(status("LOADTL/1", library(holder, unit)), 4);
  EXPECT_EQ(status("LOADTL/1", library("", unit)), 0) << "no tool has this holder";
  EXPECT_EQ(status("LOADTL/1", library("", unit), {"--holder", "E"}), 4);
  EXPECT_EQ(status("LOADTL/1", library("", "", unit)), 4);
  EXPECT_EQ(status("LOADTL/1", library(R"(, "holder": [])")), 4);
  EXPECT_EQ(status("LOADTL/1", library(R"(, "holder": [])"), {"--holder", "E"}), 0);
  EXPECT_EQ(status("LOADTL/1", library(holder, unit), {"--assume", "tool=T1"}), 0);
}

TEST_F(ToolFacts, ANameOfAnotherToolIsNotIgnored) {
  EXPECT_EQ(status("LOAD/TOOL,1,'s'", library()), 0);
  EXPECT_EQ(status("LOAD/TOOL,1,'L'", library()), 4);
  EXPECT_EQ(status("TPRINT/L\nLOADTL/1", library()), 4);
  shop_.write("before.apt", path_text({{50, 2}}, "PARTNO/SHOP\nUNITS/MM\nTPRINT/L\nLOADTL/1\n"));
  EXPECT_EQ(status("LOADTL/1", library(), {"--stock", "box=20", "--before", "before.apt"}), 4);
}

TEST_F(ToolFacts, TwoToolsOfOneNumberAreNotIgnored) {
  const std::string first = "CUTTER/10\nLOADTL/5\nGOTO/10,50,0\nGOTO/20,50,0\nCUTTER/6\n";
  EXPECT_EQ(status(first + "LOADTL/5", library()), 4);
  EXPECT_EQ(status(first + "LOADTL/6", library()), 0);
  EXPECT_EQ(status(first + "LOADTL/5", library(), {"--assume", "tool=T5"}), 0);
}

TEST_F(ToolFacts, AHolderBelowTheOneOfTheLibraryIsNotIgnored) {
  const std::string with_holder = library(R"(, "holder": "E")");
  EXPECT_EQ(status("LOADTL/1,LENGTH,40", with_holder), 4);
  EXPECT_EQ(status("LOADTL/1,LENGTH,90", with_holder), 0);
  EXPECT_EQ(status("TRNTYP/WORLD,0,0,0\nLOAD/TOOL,1\nCSI_SET_EXTENSION_LENGTH/40.", with_holder), 4);
  EXPECT_EQ(status("TRNTYP/WORLD,0,0,0\nLOAD/TOOL,1\nCSI_SET_EXTENSION_LENGTH/60.", with_holder), 0);
}

TEST_F(ToolFacts, AStatedLengthBelowTheHolderIsNotIgnored) {
  shop_.write("tools.json", library(R"(, "holder": "E")"));  // it begins 60 mm above the tip
  const auto program = [&](const std::string& length, const std::vector<std::string>& more) {
    shop_.write("m.h", "BEGIN PGM A MM\nTOOL DEF 1 L" + length + " R+5\nTOOL CALL 1 Z S100\n" +
                           "L X+50 Y+50 Z+50 R0 FMAX\nL Z+0 F100\nL Z+50 FMAX\nM30\nEND PGM A MM\n");
    std::vector<std::string> words = {"check",   "m.h",        "--part",   "part.stl",
                                      "--tools", "tools.json", "--assume", "placement"};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words).exit_status;
  };
  EXPECT_EQ(program("+45", {}), 4);
  EXPECT_EQ(program("+45", {"--assume", "tool=T1"}), 0);
  EXPECT_EQ(program("+60", {}), 0);
  EXPECT_EQ(program("+150", {}), 0);
  EXPECT_EQ(program("+0", {}), 0) << "no length to a gauge line";
}

TEST_F(ToolFacts, ALengthBeyondTheToolOfTheLibraryIsNotIgnored) {
  EXPECT_EQ(status("CUTTER/10,0,5,0,0,0,60\nLOADTL/1", library()), 0);
  EXPECT_EQ(status("CUTTER/10,0,5,0,0,0,75\nLOADTL/1", library()), 4);
  EXPECT_EQ(status("CUTTER/10,0,5,0,0,0,75\nLOADTL/1", library(), {"--holder", "E"}), 0) << "its end is in the holder";
}

TEST_F(ToolFacts, ARadiusThatAProgramStatesIsNotIgnored) {
  shop_.write("tools.json", library());
  const auto program = [&](const std::string& definition) {
    shop_.write("m.h",
                "BEGIN PGM A MM\n" + definition +
                    "TOOL CALL 1 Z S100\nL X+50 Y+50 Z+50 R0 FMAX\nL Z+0 F100\nL Z+50 FMAX\nM30\nEND PGM A MM\n");
    return shop_.run({"check", "m.h", "--part", "part.stl", "--tools", "tools.json", "--assume", "placement"})
        .exit_status;
  };
  EXPECT_EQ(program(""), 0);
  EXPECT_EQ(program("TOOL DEF 1 L+0 R+5\n"), 0);
  EXPECT_EQ(program("TOOL DEF 1 L+0 R+20\n"), 4);
}

}  // namespace
}  // namespace gouge::testing_samples::tool_facts_test
