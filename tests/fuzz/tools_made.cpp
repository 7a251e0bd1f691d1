#include "tests/fuzz/tools_made.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "tests/fuzz/require.h"
#include "tests/support/verify_tool.h"
#include "toolmodels/compile_tool.h"

namespace gouge::fuzz {
namespace {

constexpr std::size_t kMaxCompiled = 4;  // compiling takes a thousand times as long as reading

}  // namespace

void require_sound(const ToolLibrary& library) {
  const std::string text = write_tool_library(library);
  const Result<ToolLibrary> back = read_tool_library("back", text);
  require(back.has_value());
  require(write_tool_library(*back) == text);
  require(back->tools.size() == library.tools.size() && back->holders.size() == library.holders.size());
  for (std::size_t i = 0; i < std::min(kMaxCompiled, library.tools.size()); ++i) {
    const Result<ToolVariants> variants =
        make_tool_variants(library.tools[i], i % 2 == 0 ? 0 : 0.3, 0, i % 2 == 0 ? 0 : 1);
    require(variants.has_value() || !variants.error().code.empty());
    if (variants)
      require(test::verify_tool(variants->bare).empty() && test::verify_tool(variants->against_part).empty());
  }
}

}  // namespace gouge::fuzz
