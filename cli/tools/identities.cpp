#include "cli/tools/identities.h"

#include <algorithm>

#include "lib/base/number_text.h"
#include "lib/base/sha256.h"
#include "toolmodels/tool_library.h"

namespace gouge {
namespace {

constexpr std::size_t kDigits = 32;

}  // namespace

std::string placement_identity(const RigidTransform& place, LengthUnit stl_unit) {
  std::string text = unit_name(stl_unit);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) text += ' ' + exact_text(place.rotation(row, column));
    text += ' ' + exact_text(place.shift[row]);
  }
  return sha256_of(text).substr(0, kDigits);
}

void identify_tool(const ToolAssembly& tool, bool is_extended_up, ToolFacts& facts) {
  ToolLibrary library;
  library.tools = {tool};
  ToolAssembly& bare = library.tools.front();
  bare.number.reset();
  bare.name.clear();
  bare.gauge_length_mm = 0;
  for (ToolExtension& extension : bare.extensions) extension.name.clear();
  facts.identity = sha256_of(write_tool_library(library) + (is_extended_up ? "extended up" : "")).substr(0, kDigits);
  const auto counts_as = [&](Body body) {
    return std::ranges::any_of(tool.extensions, [&](const ToolExtension& one) { return one.counts_as == body; });
  };
  facts.bodies = {Body::cutter};
  if (!tool.shank.empty() || counts_as(Body::shank)) facts.bodies.push_back(Body::shank);
  if (!tool.holder.empty() || counts_as(Body::holder)) facts.bodies.push_back(Body::holder);
}

}  // namespace gouge
