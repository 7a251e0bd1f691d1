#include "cli/tools/identities.h"

#include <gtest/gtest.h>

namespace gouge::identities_test {
namespace {

std::string identity_of(const ToolAssembly& tool, bool is_extended_up = false) {
  ToolFacts facts;
  identify_tool(tool, is_extended_up, facts);
  return facts.identity;
}

ToolAssembly tool_of(const Cutter& cutter) {
  ToolAssembly tool;
  tool.cutter = cutter;
  return tool;
}

ToolAssembly flat_with_holder() {
  ToolAssembly tool = tool_of(FlatCutter{6, 20});
  tool.holder = {{30, 30, 40}};
  return tool;
}

TEST(IdentifyTool, WordsNamesAndUnitsDoNotMatter) {
  const std::string flat = identity_of(tool_of(FlatCutter{6, 20}));
  EXPECT_EQ(flat.size(), 32U);
  ToolAssembly named = tool_of(BullNoseCutter{6, 0, 20});
  named.number = 7;
  named.name = "finisher";
  named.gauge_length_mm = 120;
  EXPECT_EQ(identity_of(named), flat);
  EXPECT_EQ(identity_of(tool_of(AptCutter{6, 0, 3, 0, 0, 0, 20})), flat);
  EXPECT_EQ(identity_of(tool_of(FlatCutter{6 / 25.4 * 25.4 * (1 + 1e-13), 20})), flat);
  EXPECT_EQ(identity_of(tool_of(BullNoseCutter{6, 3, 20})), identity_of(tool_of(BallCutter{6, 20})));
}

TEST(IdentifyTool, EveryChangeOfAContourMatters) {
  const std::string with_holder = identity_of(flat_with_holder());
  EXPECT_NE(identity_of(tool_of(FlatCutter{6, 20})), with_holder);
  ToolAssembly other = flat_with_holder();
  other.cutter = FlatCutter{6.00001, 20};
  EXPECT_NE(identity_of(other), with_holder);
  other = flat_with_holder();
  other.cutter = BullNoseCutter{6, 0.00001, 20};
  EXPECT_NE(identity_of(other), with_holder);
  other = flat_with_holder();
  std::swap(other.holder, other.shank);
  EXPECT_NE(identity_of(other), with_holder);
  EXPECT_NE(identity_of(flat_with_holder(), true), with_holder);
}

TEST(IdentifyTool, AToolWithoutAContourHasNone) { EXPECT_EQ(identity_of(tool_of(FlatCutter{-6, 20})), ""); }

}  // namespace
}  // namespace gouge::identities_test
