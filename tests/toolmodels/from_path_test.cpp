#include "toolmodels/from_path.h"

#include <gtest/gtest.h>

namespace gouge::from_path_test {
namespace {

double top_of(const ToolAssembly& tool) { return make_profile(tool)->elements.back().b.y(); }

Result<ToolFromPath> tool_of(std::optional<int> number, const std::string& name, const CutterStatement& cutter,
                             const std::vector<ToolSegment>& holder, double flute_length_mm = 0) {
  PathTool tool;
  tool.number = number;
  tool.name = name;
  tool.cutter = cutter;
  tool.flute_length_mm = flute_length_mm;
  return make_tool_from_path(tool, holder);
}

TEST(FromPath, OneNumberIsAFlatCutterOfAssumedLength) {
  const Result<ToolFromPath> made = tool_of(7, "", {{.d_mm = 16}, 1}, {});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(top_of(made->tool), 80);
  ASSERT_EQ(made->notes.size(), 1u);
  EXPECT_EQ(made->notes[0].severity, Severity::note);
  EXPECT_EQ(made->notes[0].message, "tool T7: the file gives the cutter no length; it is checked up to 80 mm");
}

TEST(FromPath, ShortToolsAreAssumedFiftyMillimetresLong) {
  const Result<ToolFromPath> made = tool_of(7, "", {{.d_mm = 2, .r_mm = 1}, 2}, {});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(top_of(made->tool), 50);
}

TEST(FromPath, AHeightWithinTheTipIsReplacedAndReported) {
  // CUTTER/.5,.25,0,0,0,0,.25 in inches, as a real file has it.
  const Result<ToolFromPath> made = tool_of(std::nullopt, "ball", {{.d_mm = 12.7, .r_mm = 6.35, .h_mm = 6.35}, 7}, {});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(top_of(made->tool), 63.5);
  ASSERT_EQ(made->notes.size(), 1u);
  EXPECT_EQ(made->notes[0].message,
            "tool \"ball\": its height h = 6.35 mm ends within the tip; it is checked up to 63.5 mm");
}

TEST(FromPath, AboveTheFlutesTheToolIsShank) {
  const Result<ToolFromPath> made = tool_of(1, "", {{.d_mm = 10, .h_mm = 60}, 7}, {}, 22);
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(length_mm(made->tool.cutter), 22);
  ASSERT_EQ(made->tool.shank.size(), 1u);
  EXPECT_EQ(made->tool.shank[0].length_mm, 38);
  EXPECT_EQ(made->tool.shank[0].lower_diameter_mm, 10);
  EXPECT_EQ(top_of(made->tool), 60);
}

TEST(FromPath, TaperGoesOnAboveTheFlutes) {
  const Result<ToolFromPath> made = tool_of(1, "", {{.d_mm = 10, .beta_deg = 5, .h_mm = 60}, 7}, {}, 20);
  const Result<Profile> whole = make_cutter_profile(AptCutter{10, 0, 0, 0, 0, 5, 60});
  ASSERT_TRUE(made.has_value());
  EXPECT_NEAR(made->tool.shank[0].upper_diameter_mm, 2 * whole->elements.back().a.x(), 1e-12);
}

TEST(FromPath, TheHolderStandsOnTop) {
  const Result<ToolFromPath> made = tool_of(1, "", {{.d_mm = 10, .h_mm = 60}, 7}, {{40, 50, 30}});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(top_of(made->tool), 90);
  EXPECT_EQ(make_profile(made->tool)->elements.back().body, Body::holder);
}

TEST(FromPath, TheHolderStandsAtTheStatedStickOut) {
  PathTool tool{1, "", CutterStatement{{.d_mm = 10, .h_mm = 84}, 7}, 32};
  tool.stickout_mm = 60;
  const Result<ToolFromPath> made = make_tool_from_path(tool, {{40, 50, 30}});
  ASSERT_TRUE(made.has_value());
  EXPECT_EQ(stickout_mm(made->tool), 60);
  const Result<ToolFromPath> bare = make_tool_from_path(tool, {});
  ASSERT_TRUE(bare.has_value());
  EXPECT_EQ(height_mm(bare->tool), 84) << "without a holder nothing hides the rest of the shank";
}

TEST(FromPath, ContradictingNumbersAreReported) {
  const CutterStatement cutter{{.d_mm = 12, .r_mm = 2, .e_mm = 7, .f_mm = 2, .h_mm = 60}, 7};
  const Result<ToolFromPath> made = tool_of(1, "", cutter, {});
  ASSERT_TRUE(made.has_value());
  ASSERT_EQ(made->notes.size(), 1u);
  EXPECT_EQ(made->notes[0].code, "cutter-contradiction");
}

TEST(FromPath, ImpossibleNumbersAreAnErrorThatNamesTheTool) {
  const Result<ToolFromPath> made = tool_of(4, "", {{.d_mm = 10, .r_mm = 6}, 2}, {});
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().message,
            "tool T4: cutter: corner_radius 6 mm is larger than half the diameter; at most 5 mm is possible");
  EXPECT_FALSE(tool_of(4, "", {{}, 1}, {}).has_value()) << "CUTTER/0";
  EXPECT_FALSE(tool_of(4, "", {{.d_mm = -3}, 1}, {}).has_value());
}

TEST(FromPath, NegativeTaperOfAssumedLengthDoesNotClose) {
  EXPECT_TRUE(tool_of(4, "", {{.d_mm = 10, .beta_deg = -10}, 7}, {}).has_value());
}

}  // namespace
}  // namespace gouge::from_path_test
