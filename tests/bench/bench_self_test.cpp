#include <gtest/gtest.h>

#include <map>

#include "lib/tool/evaluate.h"
#include "tests/bench/sphere_cover.h"
#include "tests/bench/workload.h"
#include "tests/support/brute_force.h"

// Compares the benchmark's reference results with the library's slow reference and with themselves.

namespace gouge::bench {
namespace {

std::vector<PartPlan> plans() { return {plan_wavy(), plan_unseen()}; }

TEST(BenchTools, AreTheSameSolidInBothDescriptions) {
  for (const PartPlan& plan : plans()) {
    for (const BenchTool& tool : plan.tools) {
      const CompiledTool& compiled = tool.variants.bare;
      for (double z = -3; z < compiled.z_max_mm - 20; z += 0.37) {
        for (double r = 0; r < 1.5 * compiled.r_max_mm; r += 0.29) {
          const Vec3 p(r, 0, z);
          const double pieces = std::min(sample_piece(tool.lower, Pose{}, p).distance_mm,
                                         sample_piece(tool.holder, Pose{}, p).distance_mm);
          const double whole = evaluate(compiled, r, z).signed_distance_mm;
          // Inside, where the two pieces overlap, the union is deeper than either; never less deep.
          if (pieces > 0) {
            EXPECT_NEAR(pieces, whole, 1e-9) << tool.name << " r " << r << " z " << z;
          } else {
            EXPECT_LE(whole, pieces + 1e-9) << tool.name << " r " << r << " z " << z;
          }
        }
      }
    }
  }
}

TEST(BenchTools, AreCoveredByTheirSpheres) {
  for (const PartPlan& plan : plans()) {
    for (const BenchTool& tool : plan.tools) {
      for (const double bulge : {0.05, 0.5, 4.0}) {
        EXPECT_LE(uncovered_mm(tool, cover_tool(tool, bulge, 2 * bulge)), 0) << tool.name;
      }
    }
  }
}

TEST(BenchMeshes, AreClosedAndOfTheAskedSize) {
  for (const BenchPart part : {BenchPart::wavy, BenchPart::unseen}) {
    for (const std::size_t size : {2400UL, 20000UL}) {
      const IndexedMesh mesh = make_bench_mesh(part, size);
      EXPECT_NEAR(static_cast<double>(mesh.triangles.size()), static_cast<double>(size),
                  0.04 * static_cast<double>(size));
      std::map<std::pair<Corner, Corner>, int> sides;
      for (const TriangleCorners& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
      }
      for (const auto& [side, count] : sides) {
        ASSERT_EQ(count, 1);
        ASSERT_EQ(sides.count({side.second, side.first}), 1U);
      }
    }
  }
}

/// The oracle against the library's subdivision of every triangle, which knows no convexity.
TEST(BenchTruth, IsTheDepthOfTheSlowReference) {
  for (const BenchPart part : {BenchPart::wavy, BenchPart::unseen}) {
    const Workload work = make_workload({part, ToolKind::bull, 2400, 1});
    std::vector<std::size_t> gouging;
    for (std::size_t i = 0; i < work.positions.size(); ++i) {
      const PlacedPose& p = work.positions[i];
      if (std::min(p.lower_mm, p.holder_mm) < -0.05) gouging.push_back(i);
    }
    ASSERT_GE(gouging.size(), 500U);
    for (std::size_t k = 0; k < 6; ++k) {
      const PlacedPose& p = work.positions[gouging[k * gouging.size() / 6]];
      const double accuracy = 5e-3, closest = std::min(p.lower_mm, p.holder_mm);
      const double depth =
          brute_force_depth(MotionLaw::tool_at(p.pose), work.tool.variants, work.scene, 0, accuracy).depth_mm;
      EXPECT_LE(depth, -closest + 1e-5) << "pose " << k;
      EXPECT_GE(depth, -closest - accuracy) << "pose " << k;
    }
  }
}

TEST(BenchWork, LiesAtItsClearanceAndHasEveryGroup) {
  for (const ToolKind tool : {ToolKind::ball, ToolKind::bull, ToolKind::taper}) {
    const Workload work = make_workload({BenchPart::wavy, tool, 2400, 1});
    ASSERT_EQ(work.path.moves.size(), 20000U);
    std::map<MoveGroup, std::size_t> groups;
    for (std::size_t i = 0; i < work.positions.size(); ++i) {
      ++groups[work.groups[i]];
      const PlacedPose& p = work.positions[i];
      EXPECT_NEAR(p.pose.axis.norm(), 1, 1e-12);
      if (work.groups[i] != MoveGroup::contact || p.lower_mm < 0 || p.is_air > 0) continue;
      EXPECT_NEAR(p.lower_mm, kClearance_mm, 2e-4) << "position " << i;
    }
    EXPECT_GE(groups[MoveGroup::air], 1800U);
    EXPECT_GE(groups[MoveGroup::gouge], 900U);
    EXPECT_GE(groups[MoveGroup::holder], 200U);
    EXPECT_GE(groups[MoveGroup::contact], 15000U);
  }
}

}  // namespace
}  // namespace gouge::bench
