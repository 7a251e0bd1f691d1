#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/samples/box_stl.h"
#include "tests/samples/program.h"
#include "tests/samples/sample_folder.h"

// Corrections of files of three axes whose shank or holder gouges: they are tilted with axes of their own, or shifted where
// the cutter gouges too.

namespace gouge::testing_samples::correct_bodies_test {
namespace {

bool is_said(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

std::string tools_json(const std::string& shape, double shank, double holder) {
  return R"({"units":"mm","tools":[{"number":1,"cutter":{"shape":")" + shape +
         R"(","diameter":10,"length":20},"shank":[{"lower_diameter":)" + std::to_string(shank) +
         R"(,"upper_diameter":)" + std::to_string(shank) + R"(,"length":10}],"holder":[{"lower_diameter":)" +
         std::to_string(holder) + R"(,"upper_diameter":)" + std::to_string(holder) + R"(,"length":40}]}]})";
}

/// A floor at z = 0 from x = 0 to 100, and a wall from x = 50 of 30 mm.
class BesideAStep : public testing::Test {
 protected:
  BesideAStep() {
    write_text(folder_ + "/floor.stl", box_stl({0, 0, -20}, {100, 60, 0}));
    write_text(folder_ + "/wall.stl", box_stl({50, 0, -10}, {90, 60, 30}));
  }

  Outcome run(const std::string& command, const std::string& path, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words = {command,  path,       "--part",  "floor.stl",
                                      "--part", "wall.stl", "--tools", "tools.json"};
    words.insert(words.end(), more.begin(), more.end());
    return run_gougecheck(folder_, words);
  }

  const std::string folder_ = fresh_folder();
};

// The end of the feed is 1 mm in the wall, with flutes and shank alike.
constexpr const char* kIntoTheWall =
    "PARTNO/STEP\nUNITS/MM\nLOADTL/1\nRAPID\nGOTO/10,30,40\nFEDRAT/500,MMPM\nGOTO/10,30,0\nGOTO/46,30,0\n"
    "GOTO/46,30,40\nEND\nFINI\n";

TEST_F(BesideAStep, TheCutterIsNamedWhereItsShankIsAsDeep) {
  write_text(folder_ + "/path.apt", kIntoTheWall);
  for (const char* shape : {"flat", "ball"}) {
    write_text(folder_ + "/tools.json", tools_json(shape, 10, 40));
    const Outcome checked = run("check", "path.apt");
    EXPECT_EQ(checked.exit_status, 1);
    EXPECT_TRUE(is_said(checked.out, "gouge: 1.000 mm cutter T1 against part wall.stl at (50, ")) << checked.out;
  }
}

TEST_F(BesideAStep, ACutterThatGougesIsShiftedAlsoUnderADeeperShank) {
  write_text(folder_ + "/path.apt", kIntoTheWall);
  for (const char* shape : {"flat", "ball"}) {
    for (const double shank : {10.0, 10.2, 11.0, 9.9}) {
      write_text(folder_ + "/tools.json", tools_json(shape, shank, 10));
      const Outcome corrected = run("correct", "path.apt", {"-o", "out.apt"});
      EXPECT_EQ(corrected.exit_status, 0) << shape << " " << shank << "\n" << corrected.out << corrected.err;
      EXPECT_EQ(run("check", "out.apt").exit_status, 0) << shape << " " << shank;
    }
  }
}

TEST_F(BesideAStep, AShankOfItsOwnStrategyIsNotShifted) {
  write_text(folder_ + "/path.apt", kIntoTheWall);
  write_text(folder_ + "/tools.json", tools_json("flat", 10.2, 10));
  const Outcome left = run("correct", "path.apt", {"-o", "out.apt", "--strategy", "shank=axis"});
  EXPECT_EQ(left.exit_status, 1);
  EXPECT_TRUE(is_said(left.out, "no way out within --max-shift 20 mm; a lift of ")) << left.out;
  EXPECT_TRUE(is_said(left.out, " along the tool axis would free it: --max-shift 29.995 mm")) << left.out;
}

// Two positions in a row have the same tilt, and the last tilted one is upright again.
TEST_F(BesideAStep, AFileWithoutAxesIsTiltedInEveryDialect) {
  write_text(folder_ + "/wall.stl", box_stl({50, 0, -10}, {90, 60, 45}));
  write_text(folder_ + "/tools.json", tools_json("ball", 10, 40));
  const std::string moves =
      "LOADTL/1\nRAPID\nGOTO/30,10,80\nFEDRAT/500,MMPM\nGOTO/30,10,0\nGOTO/33,10,0\nGOTO/33,50,0\nGOTO/15,50,0\n"
      "GOTO/15,50,80\nEND\nFINI\n";
  for (const char* multax : {"", "MULTAX/OFF\n"}) {
    write_text(folder_ + "/path.apt", "PARTNO/STEP\nUNITS/MM\n" + std::string(multax) + moves);
    for (const char* dialect : {"apt", "mori", "nccs", "catia", "creo", "autodesk", "camplete"}) {
      const Outcome corrected = run("correct", "path.apt", {"-o", "out.apt", "--allow-multax", "--dialect", dialect});
      EXPECT_EQ(corrected.exit_status, 0) << dialect << "\n" << corrected.out << corrected.err;
      EXPECT_FALSE(is_said(corrected.err, "[not-tilted]")) << dialect << "\n" << corrected.err;
      EXPECT_TRUE(is_said(text_of(folder_ + "/out.apt"), "MULTAX/ON\nGOTO/")) << dialect;
      EXPECT_EQ(run("check", "out.apt", {"--dialect", dialect}).exit_status, 0) << dialect;
    }
  }
}

}  // namespace
}  // namespace gouge::testing_samples::correct_bodies_test
