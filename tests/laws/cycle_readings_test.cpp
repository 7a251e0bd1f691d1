// Where a drilling cycle leaves the tool: parts and clamps that only a wrong reading passes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "postproc/cldata/interpreting/interpreter.h"
#include "postproc/formats/toolpath_format.h"
#include "tests/laws/reading.h"
#include "tests/support/shapes.h"

namespace gouge::cycle_readings_test {
namespace {

const std::string kNx =
    "TOOL PATH/A,TOOL,B\nTLDATA/MILL,10,0,50,0,0\nMSYS/0,0,0,1,0,0,0,1,0\nLOAD/TOOL,1\nGOTO/0,0,30\n";

std::string nx_holes(const std::string& retract) {
  return kNx + "CYCLE/DRILL,RAPTO,3,FEDTO,-5" + retract +
         "\nGOTO/0,0,0\nGOTO/60,0,0\nCYCLE/OFF\nGOTO/60,0,60\nEND-OF-PATH\n";
}

std::string creo_holes(const std::string& retract) {
  return "$$* Pro/CLfile\nUNITS / MM\nLOADTL / 1\nGOTO / 0, 0, 30\nCYCLE / DRILL, DEPTH, 5, MMPM, 100, CLEAR, 3" +
         retract + "\nGOTO / 0, 0, 0\nGOTO / 60, 0, 0\nCYCLE / OFF\nGOTO / 60, 0, 60\nFINI\n";
}

const std::vector<ToolVariants> kMill = {make_tool_variants({1, "", FlatCutter{10, 50}, {}}, 0, 0, 0).value()};

// A clamp over the second hole, higher than what the file states: only a tool that comes from above meets it.
const IndexedMesh& clamp() {
  static const IndexedMesh mesh = shapes::box({50, -20, 65}, {70, 20, 70});
  return mesh;
}

TEST(Retract, ThatIsStatedIsWhereTheToolCrosses) {
  const IndexedMesh wall = shapes::box({30, -20, -5}, {32, 20, 15});
  EXPECT_EQ(verdict(read_as(nx_holes(""), ""), wall), "gouge");
  EXPECT_EQ(verdict(read_as(nx_holes(",RTRCTO,2"), ""), wall), "not-checked") << "a retract below the clearance";
  EXPECT_EQ(verdict(read_as(nx_holes(",RTRCTO,20"), ""), wall), "clean");
  EXPECT_EQ(verdict(read_as(creo_holes(""), ""), wall, kMill), "gouge");
  EXPECT_EQ(verdict(read_as(creo_holes(", RETURN, 20"), ""), wall, kMill), "clean");
}

TEST(Retract, ToAPlaneWithoutItsHeightIsNotChecked) {
  for (const char* retract : {",RTRCTO,AUTO", ",RTRCTO", ",RETURN,20"}) {
    EXPECT_EQ(verdict(read_as(nx_holes(retract), ""), clamp()), "not-checked") << retract;
  }
  for (const char* retract : {", RETURN, 0", ", RETURN, 0.0", ", RETURN", ", RTRCTO, 20"}) {
    EXPECT_EQ(verdict(read_as(creo_holes(retract), ""), clamp(), kMill), "not-checked") << retract;
  }
}

TEST(Retract, ToAPlaneWithoutItsHeightLeavesThePlungesChecked) {
  const Toolpath path = read_as(nx_holes(",RTRCTO,AUTO"), "");
  std::string checked;
  for (const Move& move : path.moves) checked += move.not_checked_reason.empty() ? '1' : '0';
  // Alone; down to the clearance, the plunge, up; across and down, the plunge, up; away.
  EXPECT_EQ(checked,
            "1"
            "110"
            "010"
            "0");
  EXPECT_EQ(path.moves.at(3).not_checked_reason,
            "a drilling cycle rises to a retract plane whose height it does not state");
  EXPECT_EQ(path.moves.at(4).not_checked_reason, "starts at an unknown retract height after a drilling cycle");
  EXPECT_TRUE(path.moves.at(5).has_start);
  const IndexedMesh deep = shapes::box({50, -20, -20}, {70, 20, -4});
  EXPECT_EQ(check_states(path, deep, kMill).at(5), MoveState::gouge);
}

Toolpath read_with_plane(const std::string& text, double plane_mm) {
  ReadOptions options;
  options.retract_plane_mm = plane_mm;
  ReadOutcome outcome = read_toolpath("real.apt", text, options);
  EXPECT_TRUE(outcome.toolpath);
  return outcome.toolpath ? std::move(*outcome.toolpath) : Toolpath{};
}

TEST(Retract, ToAPlaneWhoseHeightTheUserStatesIsChecked) {
  const IndexedMesh wall = shapes::box({30, -20, -5}, {32, 20, 15});
  for (const char* retract : {",RTRCTO,AUTO", ",RTRCTO"}) {
    EXPECT_EQ(verdict(read_with_plane(nx_holes(retract), 20), wall), "clean") << retract;
    EXPECT_EQ(verdict(read_with_plane(nx_holes(retract), 10), wall), "gouge") << retract;
  }
  EXPECT_EQ(verdict(read_with_plane(creo_holes(", RETURN, 0"), 20), wall, kMill), "clean");
}

TEST(Retract, ToAStatedPlaneCountsFromThePositionsOfItsHoles) {
  const Toolpath path = read_with_plane(nx_holes(",RTRCTO,AUTO"), 50);
  EXPECT_NEAR(path.moves.at(3).end.tip.z(), 50, 1e-12);
  EXPECT_EQ(format_of(path).records(path)->of_move.size(), path.moves.size()) << "as a correction reads the file again";
}

TEST(Retract, ToAStatedPlaneIsNotReadWhereTheCycleContradictsIt) {
  EXPECT_EQ(verdict(read_with_plane(nx_holes(",RETURN,20"), 50), clamp()), "not-checked") << "a height of another kind";
  const Toolpath low = read_with_plane(nx_holes(",RTRCTO,AUTO"), 2);
  EXPECT_EQ(verdict(low, clamp()), "not-checked") << "below the clearance";
  const auto is_about_plane = [](const Diagnostic& note) {
    return note.message.find("--retract-plane") != std::string::npos;
  };
  EXPECT_EQ(std::ranges::count_if(low.notes, is_about_plane), 1);
}

TEST(Retract, WordsOfCampleteWithoutANumberAreNoHeightOfZero) {
  const std::string text = "CSI_TOOL_PATH/A\nUNITS/MM\nCUTTER/10, 0, 0, 0, 0, 0, 30\nLOADTL/1\nGOTO/0, 0, 30\n";
  const Toolpath path = read_as(text + "CYCLE/DRILL, FEDTO, 5, RAPTO, AUTO\nGOTO/0, 0, 0\nFINI\n", "apt-camplete");
  EXPECT_EQ(path.moves.at(1).not_checked_reason, "a cycle whose words are not understood: CYCLE in line 6");
}

const std::string kApt = "UNITS/MM\nCUTTER/10\nLOADTL/1\nGOTO/-20,0,20\n";
const std::string kCycle = "CYCLE/DRILL,FEDTO,8,RAPTO,2,RTRCTO,20\nGOTO/60,0,0\n";

// The step is from hole to hole, not from where the cycle left the tool.
TEST(Step, FromAHoleGoesOnFromThatHole) {
  const IndexedMesh part = shapes::box({-50, -50, -20}, {50, 50, -7});
  const std::string tail = "CYCLE/OFF\nGOTO/0,0,50\nFINI\n";
  for (const char* second : {"GOTO/40,0,0\n", "GODLTA/-20,0,0\n", "GODLTA/0,20,0\nGODLTA/-20,-20,0\n"}) {
    EXPECT_EQ(verdict(read_as(kApt + kCycle + second + tail, ""), part), "gouge") << second;
  }
  const Toolpath steps = read_as(kApt + kCycle + "GODLTA/-20,0,0\n" + tail, "");
  const Toolpath absolute = read_as(kApt + kCycle + "GOTO/40,0,0\n" + tail, "");
  ASSERT_EQ(steps.moves.size(), absolute.moves.size());
  for (std::size_t i = 0; i < steps.moves.size(); ++i) {
    EXPECT_EQ(steps.moves[i].end.tip, absolute.moves[i].end.tip) << i;
    EXPECT_EQ(steps.moves[i].has_start, absolute.moves[i].has_start) << i;
  }
}

TEST(Step, FromAHoleWhoseRetractIsNotKnownGoesOnFromThatHole) {
  const std::string text = kApt + "CYCLE/DRILL,FEDTO,8,RAPTO,2,RTRCTO,AUTO\nGOTO/60,0,0\n";
  const Toolpath path = read_as(text + "GODLTA/-20,0,0\nCYCLE/OFF\nGOTO/0,0,50\nFINI\n", "");
  EXPECT_EQ(path.moves.at(path.moves.size() - 3).end.tip, Vec3(40, 0, -8));
}

// From the last position of the program, or from where the tool is: which one counts no file states.
TEST(Step, AfterTheLastHoleIsNotRead) {
  const std::string step = "CYCLE/OFF\nGODLTA/-20,0,-3\nGOTO/0,0,50\nFINI\n";
  const IndexedMesh none = shapes::box({500, 500, 0}, {501, 501, 1});
  EXPECT_EQ(verdict(read_as(kApt + kCycle + step, ""), none), "not-checked");
  const std::string flush = "CYCLE/DRILL,FEDTO,8,RAPTO,0\nGOTO/60,0,0\n";
  EXPECT_EQ(verdict(read_as(kApt + flush + step, ""), none), "clean") << "both places are the same";
  const std::string again = "CYCLE/OFF\nGOTO/60,0,20\nGODLTA/-20,0,-3\nFINI\n";
  EXPECT_EQ(verdict(read_as(kApt + kCycle + again, ""), none), "clean") << "a position stands between";
}

const std::string kOpen =
    "UNITS/MM\nCUTTER/10,0,5,0,0,0,50\nLOADTL/1\nGOTO/0,0,50\nCYCLE/DRILL,FEDTO,7,RAPTO,3,RTRCTO,50\nGOTO/10,0,0\n"
    "LOADTL/2\nGOTO/20,0,0\nFINI\n";

// The issue of a real file: an end mill's contour read as holes, through a post.
TEST(OpenCycle, DoesNotSwallowTheMillingAfterIt) {
  const std::string text =
      "CYCLE/DRILL,FEDTO,7.65,MMPM,125.68,RAPTO,3.,RTRCTO,100.,DWELL,0\nGOTO/0,0,0\nCUTTER/10.,0,5.,0,0,0,73.\n"
      "LOAD/TOOL,2\nRAPID/\nGOTO/40.,0,2.5\nCIRCLE/60.,0,0,0,0,1.\nGOTO/40.,0,0.\nGOTO/80.,30.,0.\nGOTO/80.,-30.,0.\n";
  const IndexedMesh post = shapes::box({79, -1, -30}, {81, 1, 20});
  for (const char* head : {"UNITS/MM\nCUTTER/10.,0,5.,0,0,0,73.\nLOAD/TOOL,1\n",
                           "UNIT/MM\nTRNTYP/WORLD,0,0,0\nCUTTER/10.,0,5.,0,0,0,73.\nLOAD/TOOL,1\n"}) {
    const Toolpath path = read_as(head + text + "FINI\n", "");
    EXPECT_EQ(verdict(path, post), "not-checked");
    EXPECT_NE(path.moves.back().not_checked_reason.find("never ended: CYCLE in line"), std::string_view::npos);
    const Toolpath ended = read_as(
        head + text.substr(0, text.find("CUTTER")) + "CYCLE/OFF\n" + text.substr(text.find("CUTTER")) + "FINI\n",
        "apt-solidworks-cam");
    EXPECT_EQ(verdict(ended, post), "gouge");
  }
}

TEST(OpenCycle, IsNamedByItsLineInCopiesOfThePath) {
  Toolpath copy;
  {
    const Toolpath path = read_as(kOpen, "");
    copy = path;
  }
  EXPECT_EQ(copy.moves.back().not_checked_reason,
            "a hole, or a motion of its own, as its cycle is never ended: CYCLE in line 5");
}

}  // namespace
}  // namespace gouge::cycle_readings_test
