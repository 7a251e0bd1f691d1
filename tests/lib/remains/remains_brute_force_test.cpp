// The meshes of the remaining stock beside random points at many instants of random programs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "lib/mesh/mesh_findings.h"
#include "lib/remains/remaining_stock.h"
#include "lib/surface/surface.h"
#include "lib/tool/evaluate.h"
#include "lib/validate/validate_mesh.h"
#include "tests/lib/stock/block.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/tools.h"

namespace gouge::remains_brute_force_test {
namespace {

constexpr int kInstants = 60;
constexpr std::size_t kPointsOfProgram = 3000;

std::size_t wanted_programs() {
  const char* const given = std::getenv("GOUGE_STOCK_PROGRAMS");
  return given == nullptr ? 6 : static_cast<std::size_t>(std::strtoull(given, nullptr, 10));
}

/// How near tools came to a point, from samples of every motion.
struct Nearest {
  double cutters_mm = 1e9;  ///< no cutter of a motion that cuts came nearer
  double tools_mm = 1e9;    ///< a tool came as near as this, at an instant of the samples
};

Nearest nearest_to(const Vec3& point, const Toolpath& path, const MotionLaw& law, const ToolVariants& tool) {
  Nearest nearest;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Motion motion = law.of(path, i);
    const bool cuts = path.moves[i].has_start && path.moves[i].kind != MoveKind::rapid;
    // Between two instants a cutter may be nearer by half of the way between them.
    const double way = motion.path_length_mm(0, 1, 0) + motion.turn_rad() * 80;
    for (int n = 0; n <= kInstants; ++n) {
      const Pose pose = motion.at(static_cast<double>(n) / kInstants);
      nearest.tools_mm = std::min(nearest.tools_mm, signed_distance_mm(tool.bare, pose, point));
      if (cuts)
        nearest.cutters_mm =
            std::min(nearest.cutters_mm, signed_distance_mm(tool.cutting, pose, point) - 0.5 * way / kInstants);
    }
  }
  return nearest;
}

TEST(RemainsBruteForce, EveryPointThatIsLeftIsInTheOuterMeshAndNoOtherPointIsInTheInnerOne) {
  const MotionLaw law;
  const StockOptions options;
  const Vec3 low(-15, -15, -15), high(15, 15, 0);
  const StockSolid stock = StockSolid::box(low, high);
  const std::vector<ToolVariants> tools = block::small_tools();
  test::Scatter scatter(45);
  std::size_t left = 0, inside = 0, between = 0, slivers = 0;
  for (std::size_t program = 0; program < wanted_programs(); ++program) {
    const ToolVariants& tool = tools[program % tools.size()];
    const Toolpath path = block::random_program(scatter, program % 2 == 1, 14);
    const std::vector<StockTool> all{{&tool, true}};
    const CutHistory history(path, law, all, options);
    const Result<RemainingStock> found =
        remaining_stock(history, stock, path.moves.size(), options.resolution_mm, {1.2, 1e-5}, {});
    ASSERT_TRUE(found.has_value()) << found.error().message;
    for (const IndexedMesh* mesh : {&found->perhaps, &found->surely})
      EXPECT_TRUE(validate_mesh(*mesh, find_mesh_findings(*mesh)).is_sound()) << program;
    slivers += found->sliver_cells;
    const Surface outer(found->perhaps), inner(found->surely);
    for (std::size_t k = 0; k < kPointsOfProgram; ++k) {
      Vec3 point = scatter.point(15);
      // Half of the points are near the surface of the outer mesh, where both bounds are tight.
      if (k % 2 == 0) {
        point = found->perhaps.vertices[scatter.below(found->perhaps.vertices.size())] + scatter.point(0.1);
        if ((point.array() <= low.array()).any() || (point.array() >= high.array()).any()) continue;
      } else {
        point.z() = scatter.in(-15, 0);
      }
      const Nearest nearest = nearest_to(point, path, law, tool);
      const bool is_inside = inner.winds_around(point), is_outside = !outer.winds_around(point);
      if (nearest.cutters_mm > (found->sliver_cells > 0 ? options.resolution_mm : 0)) {
        ++left;
        EXPECT_FALSE(is_outside) << "program " << program << ", " << point.transpose() << ", " << nearest.cutters_mm;
      }
      if (is_inside) {
        ++inside;
        EXPECT_GT(nearest.tools_mm, 0) << "program " << program << ", " << point.transpose();
        EXPECT_FALSE(is_outside);
      } else if (!is_outside) {
        ++between;
      }
    }
  }
  std::cout << left << " points left, " << inside << " surely, " << between << " between, " << slivers << " slivers\n";
  EXPECT_GT(left, wanted_programs() * kPointsOfProgram / 10);
  EXPECT_GT(inside, wanted_programs() * kPointsOfProgram / 20);
}

}  // namespace
}  // namespace gouge::remains_brute_force_test
