#include "toolmodels/bsp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lib/tool/evaluate.h"
#include "tests/toolmodels/sample_tools.h"
#include "toolmodels/compile_tool.h"

namespace gouge {
namespace {

using test::SplitMix64;

double size_of(const CompiledTool& tool) {
  return std::max({tool.r_max_mm, tool.z_max_mm, -tool.z_min_mm});
}

// Everything that is compiled in a real check, grown forms included.
std::vector<CompiledTool> all_forms() {
  std::vector<CompiledTool> all;
  for (const ToolAssembly& tool : test::sample_tools()) {
    const Result<ToolForms> forms = make_tool_forms(tool, 0.3, 0.5, 2);
    EXPECT_TRUE(forms.has_value());
    for (const CompiledTool* form : {&forms->bare, &forms->against_part, &forms->against_fixture,
                                     &forms->with_clearance, &forms->non_cutting})
      if (!form->elements.empty()) all.push_back(*form);
  }
  return all;
}

Vec2 random_point(SplitMix64& random, const CompiledTool& tool, std::size_t i) {
  const double size = size_of(tool);
  if (i % 16 == 0) return {0, random.uniform(tool.z_min_mm - size, tool.z_max_mm + size)};
  if (i % 16 == 1) return {random.uniform(0, 50 * size), random.uniform(-50 * size, 50 * size)};
  if (i % 4 == 2) {
    const BoundaryElement& e = tool.elements[random.next() % tool.elements.size()];
    const double spread = size * std::pow(10.0, random.uniform(-12, -1));
    const Vec2 p = e.a + random.uniform(0, 1) * (e.b - e.a);
    return {std::abs(p.x() + random.uniform(-spread, spread)), p.y() + random.uniform(-spread, spread)};
  }
  return {random.uniform(0, 1.5 * tool.r_max_mm),
          random.uniform(tool.z_min_mm - 0.3 * size, tool.z_max_mm + 0.3 * size)};
}

TEST(Bsp, GivesTheDistanceOfTheBruteForce) {
  SplitMix64 random(1);
  for (const CompiledTool& tool : all_forms()) {
    double worst = 0;
    Vec2 where = Vec2::Zero();
    for (std::size_t i = 0; i < 300000; ++i) {
      const Vec2 q = random_point(random, tool, i);
      const ToolAnswer fast = evaluate(tool, q.x(), q.y());
      const ToolAnswer slow = evaluate_brute_force(tool, q.x(), q.y());
      const double scale = size_of(tool) + q.norm();
      const double error = std::abs(fast.signed_distance_mm - slow.signed_distance_mm) / scale;
      if (error > worst) {
        worst = error;
        where = q;
      }
    }
    std::cout << tool.name << ": " << tool.elements.size() << " elements, " << tool.nodes.size()
              << " nodes, depth " << bsp_depth(tool.nodes) << ", worst " << worst << "\n";
    EXPECT_LE(worst, 1e-12) << tool.name << " at " << where.transpose();
  }
}

TEST(Bsp, ToolsAreSound) {
  for (const CompiledTool& tool : all_forms())
    EXPECT_EQ(verify_tool(tool), std::vector<std::string>{}) << tool.name;
}

}  // namespace
}  // namespace gouge
