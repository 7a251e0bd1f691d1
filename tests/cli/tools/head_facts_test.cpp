#include "cli/tools/head_facts.h"

#include <gtest/gtest.h>

#include <memory>

namespace gouge::head_facts_test {
namespace {

ToolAssembly tool_with(double gauge_length_mm, double holder_mm = 0) {
  ToolAssembly tool;
  tool.cutter = FlatCutter{10, 40};
  tool.gauge_length_mm = gauge_length_mm;
  if (holder_mm > 0) tool.holder = {{30, 30, holder_mm}};
  return tool;
}

/// Returns a path that moves with each of some tools.
Toolpath path_with(std::size_t tools) {
  Toolpath path;
  for (std::size_t i = 0; i < tools; ++i) {
    PathTool& tool = path.tools.emplace_back();
    tool.number = static_cast<int>(i) + 1;
    path.moves.emplace_back().tool = i;
  }
  return path;
}

Assumption place_of(const std::vector<ToolAssembly>& tools) {
  return head_facts(path_with(tools.size()), {tools.begin(), tools.end()}, "")[1];
}

TEST(HeadFacts, TheDistanceFromTheTipIsRightForToolsOfOneLength) {
  EXPECT_EQ(place_of({tool_with(0)}).basis, Basis::stated) << "one tool";
  EXPECT_EQ(place_of({tool_with(100), tool_with(100.004)}).basis, Basis::derived);
  EXPECT_EQ(place_of({tool_with(0, 60), tool_with(0, 60)}).basis, Basis::by_default) << "as long as their holders";
  EXPECT_EQ(place_of({tool_with(100), tool_with(0)}).basis, Basis::unknown);
  EXPECT_EQ(place_of({tool_with(0, 60), tool_with(0, 20)}).basis, Basis::contradicted);
  const Assumption differs = place_of({tool_with(100), tool_with(50)});
  EXPECT_EQ(differs.basis, Basis::contradicted);
  EXPECT_EQ(differs.evidence,
            "a head is equally far from the tip of each tool, but T1 is 100 mm long and T2 is 50 mm long");
}

TEST(HeadFacts, ToolsThatDoNotMoveHaveNoPlace) {
  Toolpath path = path_with(2);
  path.moves.resize(1);
  EXPECT_EQ(head_facts(path, {tool_with(100), tool_with(50)}, "")[1].basis, Basis::stated);
}

TEST(HeadFacts, ALengthOfTheSetUpTakesThePlaceOfThatOfTheLibrary) {
  Toolpath path = path_with(2);
  path.tools[1].gauge_length_mm = 100;
  EXPECT_EQ(head_facts(path, {tool_with(100), tool_with(0)}, "")[1].basis, Basis::derived);
}

TEST(HeadFacts, ALengthOfTheToolpathTakesThePlaceOfThatOfTheLibrary) {
  const auto fact = [](double first_mm, double second_mm, double cutter_mm = 0) {
    Toolpath path = path_with(2);
    path.tools[0].loaded_length_mm = first_mm;
    path.tools[1].loaded_length_mm = second_mm;
    if (cutter_mm > 0) path.tools[1].cutter.emplace().h_mm = cutter_mm;
    return head_facts(path, {tool_with(0, 70), tool_with(0, 70)}, "")[1];
  };
  EXPECT_EQ(fact(110, 110).basis, Basis::by_default);
  EXPECT_EQ(fact(110, 110.004).basis, Basis::by_default);
  EXPECT_EQ(fact(0, 110).basis, Basis::by_default) << "as long as in the library";
  EXPECT_EQ(fact(0, 75, 75).basis, Basis::by_default) << "the length of the cutter";
  EXPECT_EQ(fact(0, 100).basis, Basis::contradicted);
  EXPECT_EQ(fact(100, 100).evidence, "all tools are 100 mm long");
  const Assumption differs = fact(110, 100);
  EXPECT_EQ(differs.basis, Basis::contradicted);
  EXPECT_EQ(differs.evidence,
            "a head is equally far from the tip of each tool, but T1 is 110 mm long and T2 is 100 mm long by LENGTH in "
            "the toolpath");
}

TEST(HeadFacts, AToolThatIsLoadedWithSeveralLengthsHasNoPlaceOfItsHead) {
  Toolpath path = path_with(1);
  path.tools[0].has_other_length = true;
  EXPECT_EQ(head_facts(path, {tool_with(0, 70)}, "")[1].basis, Basis::contradicted);
  path.tools[0].gauge_length_mm = 100;
  EXPECT_EQ(head_facts(path, {tool_with(0, 70)}, "")[1].basis, Basis::stated) << "the set-up states the length";
}

TEST(HeadFacts, AStickOutOfTheToolpathMovesTheHead) {
  const auto fact = [](double first_mm, double second_mm, double gauge_length_mm = 0) {
    Toolpath path = path_with(2);
    path.tools[0].stickout_mm = first_mm;
    path.tools[1].stickout_mm = second_mm;
    const ToolAssembly tool = tool_with(gauge_length_mm, 70);
    return head_facts(path, {tool, tool}, "")[1];
  };
  EXPECT_EQ(fact(40, 40).basis, Basis::by_default);
  EXPECT_EQ(fact(40.004, 39.996).basis, Basis::by_default) << "rounded";
  EXPECT_EQ(fact(60, 60).evidence, "all tools are 130 mm long");
  EXPECT_EQ(fact(60, 60, 115).basis, Basis::derived);
  EXPECT_EQ(fact(40, 60).basis, Basis::contradicted);
  EXPECT_EQ(fact(40, 60, 115).evidence,
            "a head is equally far from the tip of each tool, but T1 is 115 mm long and T2 is 135 mm long by its "
            "stick-out in the toolpath");
}

TEST(HeadFacts, TheTurnIsKnownWhereTheAxisStandsOrAProgramStatesTheJoints) {
  Toolpath path = path_with(1);
  const auto turn = [&](const std::string& machine) { return head_facts(path, {tool_with(0)}, machine)[0]; };
  EXPECT_EQ(turn("").basis, Basis::derived) << "upright";
  EXPECT_EQ(turn("DMU").basis, Basis::by_default) << "a table may turn below an upright tool";
  path.moves[0].end.axis = Vec3(0.6, 0, 0.8);
  EXPECT_EQ(turn("").basis, Basis::by_default);
  EXPECT_EQ(turn("").object, "turn");
  path.has_turned_frame = true;
  EXPECT_EQ(turn("").basis, Basis::contradicted) << "the machine has the axes of the frame";
  path.joints = std::make_shared<const JointPath>();
  EXPECT_EQ(turn("DMU").basis, Basis::by_default) << "angles that are chosen";
  path.dialect = "gcode";
  EXPECT_EQ(turn("DMU").basis, Basis::stated);
}

}  // namespace
}  // namespace gouge::head_facts_test
