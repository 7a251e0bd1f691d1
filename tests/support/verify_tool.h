#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lib/tool/evaluate.h"

namespace gouge::test {

inline std::string named(std::size_t element) { return "element " + std::to_string(element); }

inline void verify_elements(const CompiledTool& tool, std::vector<std::string>& broken) {
  for (std::size_t i = 0; i < tool.elements.size(); ++i) {
    const BoundaryElement& e = tool.elements[i];
    if (std::abs(e.normal.norm() - 1) > 1e-12) broken.push_back(named(i) + " has no unit normal");
    if (e.a.x() < 0 || e.b.x() < 0) broken.push_back(named(i) + " crosses the axis");
    if (e.is_reflex && e.support.z_lo_mm <= e.support.z_hi_mm)
      broken.push_back(named(i) + " is reflex and claims support");
    if (i > 0 && tool.elements[i - 1].b != e.a) broken.push_back(named(i) + " does not join the one before");
    if (i > 0 && e.kind == ElementKind::vertex && tool.elements[i - 1].kind == ElementKind::vertex)
      broken.push_back(named(i) + " is a second vertex at one point");
  }
}

inline void verify_nodes(const CompiledTool& tool, std::vector<std::string>& broken) {
  std::vector<int> parents(tool.nodes.size());
  std::vector<bool> is_owner(tool.elements.size());
  for (std::size_t i = 0; i < tool.nodes.size(); ++i)
    for (const std::int32_t child : {tool.nodes[i].negative, tool.nodes[i].positive}) {
      const auto index = static_cast<std::size_t>(child >= 0 ? child : ~child);
      if (child >= 0 && (index <= i || index >= tool.nodes.size()))
        broken.push_back("node " + std::to_string(i) + " has a child that does not stand behind it");
      else if (child >= 0)
        ++parents[index];
      else if (index >= tool.elements.size())
        broken.push_back("node " + std::to_string(i) + " names an element that is not there");
      else
        is_owner[index] = true;
    }
  for (std::size_t i = 1; i < parents.size(); ++i)
    if (parents[i] != 1) broken.push_back("node " + std::to_string(i) + " has not one parent");
  for (std::size_t i = 0; i < is_owner.size(); ++i)
    if (!is_owner[i] && !tool.nodes.empty()) broken.push_back(named(i) + " owns no region");
}

/// Returns the broken invariants of a compiled tool; empty for a valid tool. The invariants: indices are in range,
/// every element is owned by a leaf, normals are unit vectors, and elements join. Extent and core must be those of the
/// elements.
[[nodiscard]] inline std::vector<std::string> verify_tool(const CompiledTool& tool) {
  std::vector<std::string> broken;
  if (tool.elements.empty()) {
    if (!tool.nodes.empty()) broken.push_back("there are nodes but no elements");
    return broken;
  }
  verify_elements(tool, broken);
  verify_nodes(tool, broken);
  if (!broken.empty()) return broken;
  if (tool.elements.size() > 1 && tool.nodes.empty() == tool.stretches.empty())
    return {"there are elements but neither nodes nor stretches, or both"};
  if (tool.z_min_mm >= tool.z_max_mm || tool.r_max_mm <= 0) broken.push_back("the extent is empty");
  const double depth = -evaluate(tool, tool.core.x(), tool.core.y()).signed_distance_mm;
  if (tool.core.x() > 0 || tool.core_depth_mm <= 0 || std::abs(depth - tool.core_depth_mm) > 0)
    broken.push_back("the core is not inside");
  return broken;
}

}  // namespace gouge::test
