#include "postproc/image/tool_drawing.h"

#include <gtest/gtest.h>

#include "tests/postproc/image/small_scene.h"

namespace gouge::tool_drawing_test {
namespace {

std::size_t count_in(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(ToolDrawing, ShowsEachBodyInItsColourWithTheTipBelow) {
  const SmallScene scene;
  const std::string svg = tool_drawing(scene.tool.bare, "T<1>");
  EXPECT_EQ(count_in(svg, "<svg role=\"img\" aria-label=\"T&lt;1&gt;\""), 1U) << svg;
  for (const char* body : {"cutter", "shank", "holder"})
    EXPECT_GE(count_in(svg, std::string("<polygon class=\"") + body + "\""), 1U) << svg;
  EXPECT_EQ(count_in(svg, "nan"), 0U);
  EXPECT_EQ(svg, tool_drawing(scene.tool.bare, "T<1>"));
}

}  // namespace
}  // namespace gouge::tool_drawing_test
