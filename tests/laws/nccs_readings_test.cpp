// Records of binary NCCS files read in the right way and in the wrong one: the part distinguishes the two.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "postproc/formats/read_toolpath.h"
#include "tests/postproc/cldata/nccs_file.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::nccs_readings_test {
namespace {

constexpr Minor kOff{72}, kLeft{8}, kDrill{163}, kRapto{280}, kFedto{281};

Toolpath read(const std::string& bytes, const std::string& dialect = "") {
  ReadOptions options;
  if (!dialect.empty()) options.dialect = dialect_called(dialect);
  ReadOutcome outcome = read_toolpath("a.cl", bytes, options);
  for (const Diagnostic& error : outcome.errors) ADD_FAILURE() << to_text(error);
  if (!outcome.toolpath) return {};
  outcome.toolpath->tools.resize(1);
  for (Move& move : outcome.toolpath->moves) move.tool = 0;
  return std::move(*outcome.toolpath);
}

MoveVerdicts verdicts(const Toolpath& path, const IndexedMesh& part) {
  Scene scene;
  scene.parts.push_back(part);
  const ToolVariants tool = tools::ball(1);
  return whole_check(path, &tool, scene, {}).verdicts;
}

/// "clean", or the state of the first move that is not.
std::string verdict_of(const Toolpath& path, const IndexedMesh& part) {
  for (const MoveVerdict& v : verdicts(path, part)) {
    if (v.state != MoveState::clean) return state_name(v.state);
  }
  return "clean";
}

IndexedMesh plate(double top) { return shapes::box({-50, -50, top - 5}, {50, 50, top}); }

// A hole of 12.5 below its position; the way back up to 2.
NccsFile hole(const std::vector<NccsFile::Argument>& depth) {
  std::vector<NccsFile::Argument> arguments = {kDrill, kFedto};
  arguments.insert(arguments.end(), depth.begin(), depth.end());
  arguments.insert(arguments.end(), {kRapto, 2.0});
  NccsFile file;
  file.multax(true).points({0, 0, 30, 0, 0, 1}).post(1054, arguments).points({10, 0, 0, 0, 0, 1});
  return file;
}

TEST(NccsReading, ThePositionOfAHoleIsItsTop) {
  const Toolpath path = read(hole({12.5}).bytes());
  EXPECT_EQ(verdict_of(path, plate(-12.6)), "clean");
  EXPECT_EQ(verdict_of(path, plate(-12.4)), "gouge");
  Toolpath from_bottom = path;  // were it the bottom, all would be higher by the depth
  for (Move& move : from_bottom.moves) {
    if (move.kind == MoveKind::cycle) move.end.tip.z() += 12.5;
  }
  EXPECT_EQ(verdict_of(from_bottom, plate(-12.4)), "clean") << "which would be wrong";
}

TEST(NccsReading, ADiameterAndAnAngleAreNoDepth) {
  const Toolpath path = read(hole({10.0, 40.0}).bytes());  // 5 / tan 20
  EXPECT_EQ(verdict_of(path, plate(-13.8)), "clean");
  EXPECT_EQ(verdict_of(path, plate(-13.7)), "gouge");
  EXPECT_EQ(verdict_of(read(hole({10.0}).bytes()), plate(-13.7)), "clean") << "which would be wrong";
}

TEST(NccsReading, CutcomIsOnUntilOff) {
  NccsFile file;
  file.multax(true).points({0, 0, 9, 0, 0, 1}).post(1007, {kLeft}).points({5, 0, 9, 0, 0, 1});
  const IndexedMesh below = plate(0);
  EXPECT_EQ(verdict_of(read(file.bytes()), below), "not-checked");
  NccsFile then = file;
  then.post(1007, {kOff}).points({6, 0, 9, 0, 0, 1}).points({6, 0, -1, 0, 0, 1});
  file.points({6, 0, 9, 0, 0, 1}).points({6, 0, -1, 0, 0, 1});
  const auto last = [&](const NccsFile& f) {
    return std::string(state_name(verdicts(read(f.bytes()), below).back().state));
  };
  EXPECT_EQ(last(then), "gouge");
  EXPECT_EQ(last(file), "not-checked");
}

// A quarter of a circle whose vector points down; the post stands in the middle of the other three.
TEST(NccsReading, AnArcIsRunTheShortWay) {
  const IndexedMesh post = shapes::box({-14.24, -14.24, -5}, {-14.04, -14.04, 5});
  NccsFile file;
  file.multax(false).points({20, 0, 0}).circle({0, 0, 0, 0, 0, -1, 20}).points({0, 20, 0});
  EXPECT_EQ(verdict_of(read(file.bytes()), post), "clean");
  const std::string text =
      "REMARK a.as NCLCAM 2019.00\nMULTAX/OFF\nGOTO/20.,0.,0.\nCIRCLE/0.,0.,0.,0.,0.,-1.,20.\nGOTO/0.,20.,0.\nFINI\n";
  EXPECT_EQ(verdict_of(read(text), post), "clean");
  EXPECT_EQ(verdict_of(read(text, "apt-creo"), post), "gouge");
}

TEST(NccsReading, TheVectorsOfExpandedMotionAreNoPlaces) {
  const IndexedMesh block = shapes::box({89, 90, 91}, {91, 92, 93});
  NccsFile file;
  file.multax(true).expanded({0, 0, 9, 0, 0, 1, 5, 0, 9, 0, 0, 1});
  EXPECT_EQ(verdict_of(read(file.bytes()), block), "clean");
  NccsFile wrong;
  wrong.multax(false).points({0, 0, 9, 0, 0, 1, 90, 91, 92});
  EXPECT_EQ(verdict_of(read(wrong.bytes()), block), "gouge");
}

}  // namespace
}  // namespace gouge::nccs_readings_test
