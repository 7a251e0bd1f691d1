#include "cli/resolve_tools.h"

#include <gtest/gtest.h>

namespace gouge {
namespace {

ToolLibrary library_with_holder() {
  ToolLibrary library;
  ToolAssembly tool;
  tool.number = 2;
  tool.cutter = FlatCutter{12.7, 38.1};
  tool.holder = {{31.75, 1.75 * 25.4, 38.1}};
  library.tools.push_back(tool);
  return library;
}

Toolpath path_in(LengthUnit unit) {
  Toolpath path;
  path.unit = unit;
  path.tools = {PathTool{2, "", {}, 0, 4}};
  return path;
}

TEST(ResolveTools, TellsTheHolderRoundedAndInThePathsUnit) {
  const ToolLibrary library = library_with_holder();
  const auto described = [&](LengthUnit unit) {
    const Result<ResolvedTools> resolved = resolve_tools(path_in(unit), &library, {}, "");
    EXPECT_TRUE(resolved.has_value());
    return resolved->facts.at(0).description;
  };
  EXPECT_EQ(described(LengthUnit::inch), "flat, holder to D1.75 in");
  EXPECT_EQ(described(LengthUnit::mm), "flat, holder to D44.45 mm");
}

}  // namespace
}  // namespace gouge
