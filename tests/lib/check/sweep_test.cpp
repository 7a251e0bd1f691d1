// The wide sweep's bounds against dense sampling, and its bytes on every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "lib/check/check_path.h"
#include "lib/check/sweep_filter.h"
#include "lib/tool/convex_cover.h"
#include "lib/tool/evaluate.h"
#include "tests/support/motions.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/tools.h"

namespace gouge::sweep_test {
namespace {

using test::Scatter;

/// One to nine moves in a row, from a resting pose to long paths with large turns.
std::vector<Motion> random_motions(Scatter& scatter, const Vec3& origin) {
  const double displacement = std::pow(10, scatter.in(-2, 1));
  const double lean = std::pow(10, scatter.in(-3, -0.3));
  const auto count = static_cast<std::size_t>(scatter.in(1, 10));
  std::vector<Motion> motions;
  Pose from{origin + scatter.point(1), scatter.axis(lean)};
  for (std::size_t k = 0; k < count; ++k) {
    const Pose to{from.tip + scatter.point(displacement), scatter.axis(lean)};
    motions.push_back(test::straight(from, to));
    from = to;
  }
  return motions;
}

IndexedMesh random_triangles(Scatter& scatter, const Vec3& origin, std::size_t count) {
  const double size = std::pow(10, scatter.in(-1.5, 1.3));
  const Vec3 flat = scatter.in(0, 1) < 0.3 ? Vec3(1, 1, 0.01) : Vec3(1, 1, 1);
  const Vec3 middle = origin + Vec3(scatter.in(-20, 20), scatter.in(-20, 20), scatter.in(-5, 130));
  IndexedMesh mesh;
  for (std::size_t t = 0; t < count; ++t) {
    const Vec3 about = middle + scatter.point(size);
    for (int k = 0; k < 3; ++k) mesh.vertices.push_back(about + scatter.point(size).cwiseProduct(flat));
    shapes::add_triangle(mesh, mesh.vertices.size() - 3, mesh.vertices.size() - 2, mesh.vertices.size() - 1);
  }
  return mesh;
}

double sampled_distance(const CompiledTool& tool, const std::vector<Motion>& motions,
                        const std::array<Vec3, 3>& triangle) {
  double least = 1e300;
  constexpr int kSteps = 4;
  for (const Motion& motion : motions) {
    for (int k = 0; k <= kSteps; ++k) {
      const Pose pose = motion.at(static_cast<double>(k) / kSteps);
      for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; i + j <= kSteps; ++j) {
          const double u = static_cast<double>(i) / kSteps, v = static_cast<double>(j) / kSteps;
          const Vec3 d = (1 - u - v) * triangle[0] + u * triangle[1] + v * triangle[2] - pose.tip;
          const double z = d.dot(pose.axis);
          least = std::min(least, evaluate(tool, (d - z * pose.axis).norm(), z).signed_distance_mm);
        }
      }
    }
  }
  return least;
}

struct Bounds {
  Lanes node, triangle;  // the least over all pieces of the tool
};

/// The proven distance of every lane of the first node and its first leaf.
Bounds proven(const CompiledTool& tool, const BlockTree& tree, const SweepFrame& frame, float need) {
  Bounds least;
  least.node.fill(3e38F);
  least.triangle.fill(3e38F);
  for (const CoverPiece& piece : make_convex_cover(tool).pieces) {
    KernelResult node, triangle;
    fastest_sweep_kernel().nodes(tree.nodes[0], frame, kernel_piece(piece), need, node);
    fastest_sweep_kernel().triangles(tree.leaves[0], frame, kernel_piece(piece), need, triangle);
    for (std::size_t i = 0; i < kBlockLanes; ++i) {
      least.node[i] = std::min(least.node[i], node.bound[i]);
      least.triangle[i] = std::min(least.triangle[i], triangle.bound[i]);
    }
  }
  return least;
}

TEST(Sweep, NoBoundIsAboveWhatSamplingFinds) {
  Scatter scatter(31);
  const auto tools = tools::all();
  std::size_t spoke = 0, tight = 0;
  for (int i = 0; i < 3000; ++i) {
    const CompiledTool& tool = tools[static_cast<std::size_t>(i) % tools.size()].bare;
    const Vec3 origin = scatter.in(0, 1) < 0.2 ? scatter.point(5000) : Vec3(Vec3::Zero());
    const std::vector<Motion> motions = random_motions(scatter, origin);
    const IndexedMesh mesh = random_triangles(scatter, origin, 1 + static_cast<std::size_t>(i) % 16);
    const BlockTree tree = build_block_tree({&mesh, 1}, 1);
    std::vector<SweepInterval> steps;
    for (std::uint32_t m = 0; m < motions.size(); ++m) append_steps(motions[m], m, steps);
    const SweepFrame frame = sweep_frame(steps, tree.origin, tree.rounding_mm);
    const float need = static_cast<float>(scatter.in(-12, 5));
    const Bounds least = proven(tool, tree, frame, need);
    double all = 1e300;
    for (std::uint32_t t = 0; t < tree.leaves[0].count; ++t) {
      const double sampled = sampled_distance(tool, motions, tree.corners(tree.leaves[0].triangle[t]));
      all = std::min(all, sampled);
      if (least.triangle[t] < need) continue;
      ++spoke;
      if (sampled - static_cast<double>(least.triangle[t]) < 0.1) ++tight;
      ASSERT_GE(sampled, static_cast<double>(least.triangle[t])) << "case " << i << ", triangle " << t;
    }
    if (least.node[0] >= need) {
      ASSERT_GE(all, static_cast<double>(least.node[0])) << "case " << i << ", node";
    }
  }
  EXPECT_GT(spoke, 3000U);
  EXPECT_GT(tight, 200U);
}

TEST(Sweep, EveryInstructionSetGivesTheSameBytes) {
  Scatter scatter(32);
  const auto tools = tools::all();
  for (int i = 0; i < 400; ++i) {
    const CompiledTool& tool = tools[static_cast<std::size_t>(i) % tools.size()].bare;
    const std::vector<Motion> motions = random_motions(scatter, Vec3::Zero());
    const IndexedMesh mesh = random_triangles(scatter, Vec3::Zero(), 16);
    const BlockTree tree = build_block_tree({&mesh, 1}, 1);
    std::vector<SweepInterval> steps;
    append_steps(motions.front(), 0, steps);
    const SweepFrame frame = sweep_frame(steps, tree.origin, tree.rounding_mm);
    for (const CoverPiece& piece : make_convex_cover(tool).pieces) {
      KernelResult plain, other;
      for (std::size_t k = 1; k < sweep_kernels().size(); ++k) {
        sweep_kernels()[0]->triangles(tree.leaves[0], frame, kernel_piece(piece), -0.01F, plain);
        sweep_kernels()[k]->triangles(tree.leaves[0], frame, kernel_piece(piece), -0.01F, other);
        ASSERT_EQ(plain.open, other.open);
        ASSERT_EQ(std::memcmp(&plain.bound, &other.bound, sizeof(Lanes)), 0) << sweep_kernels()[k]->name;
        ASSERT_EQ(std::memcmp(&plain.point, &other.point, sizeof(plain.point)), 0) << sweep_kernels()[k]->name;
        sweep_kernels()[0]->nodes(tree.nodes[0], frame, kernel_piece(piece), -0.01F, plain);
        sweep_kernels()[k]->nodes(tree.nodes[0], frame, kernel_piece(piece), -0.01F, other);
        ASSERT_EQ(std::memcmp(&plain.bound, &other.bound, sizeof(Lanes)), 0) << sweep_kernels()[k]->name;
        ASSERT_EQ(plain.open, other.open);
      }
    }
  }
}

// Inside a step of the tool a facet may be deeper than the cone above the step states; that the facet next to it is
// deep as well, and was met first, must not prune it.
TEST(Sweep, ADeepFacetDoesNotSettleADeeperOneByFeetThatNobodyLookedAt) {
  ToolAssembly made = tools::assembly(FlatCutter{10, 10}, 10);
  made.shank = {{10, 50, 10}};
  made.holder = {{50, 50, 60}};
  const ToolVariants tool = tools::variants(made);
  for (const double radius : {17.0, 16.5, 16.0, 15.0}) {
    IndexedMesh mesh;
    const auto add = [&](const Vec3& at) {
      for (const Vec3& off : {Vec3(1e-3, 0, 0), Vec3(0, 1e-3, 0), Vec3(0, 0, 1e-3)}) mesh.vertices.push_back(at + off);
      shapes::add_triangle(mesh, mesh.vertices.size() - 3, mesh.vertices.size() - 2, mesh.vertices.size() - 1);
    };
    for (int k = 0; k < 16; ++k) add({0, 0, 10.2 + 0.01 * k});
    for (int k = 0; k < 16; ++k) add({radius, 0, 19 + 0.001 * k});
    const BlockTree tree = build_block_tree({&mesh, 1}, 1);
    const std::vector<SearchTarget> targets{{&tool.bare, &tree, Against::part}};
    double deepest = 0;
    for (const Vec3& p : mesh.vertices)
      deepest = std::max(deepest, -evaluate(tool.bare, p.head<2>().norm(), p.z()).signed_distance_mm);
    for (const double gap : {0.001, 0.3}) {
      const Motion still = MotionLaw::tool_at(Pose{Vec3::Zero(), Vec3::UnitZ()});
      const SearchResult result = sweep_and_search(still, targets, {{0.01, 0.001, gap, 1000000}, 0});
      EXPECT_GE(result.value_upper_mm, deepest) << "beside facets at a radius of " << radius;
    }
  }
}

// On the axis what is left across it is rounding, which may point anywhere, along the axis too.
TEST(Sweep, PointsOnTheAxisOfAPointedToolHaveAnHonestBound) {
  Scatter scatter(33);
  ToolAssembly made = tools::assembly(DrillCutter{60, 118, 90}, 60);
  const ToolVariants tool = tools::variants(made);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = scatter.point(1).normalized();
    const Vec3 side = axis.unitOrthogonal();
    const double below = scatter.in(1, 80), half = below * scatter.in(0.3, 1);
    IndexedMesh mesh;
    for (const Vec3& displacement : {Vec3(axis), Vec3(side)}) {
      for (const double end : {-half, half}) mesh.vertices.push_back(end * displacement);
    }
    shapes::add_triangle(mesh, 0, 2, 1);
    shapes::add_triangle(mesh, 0, 1, 3);
    const BlockTree tree = build_block_tree({&mesh, 1}, 1);
    const std::vector<Motion> still{MotionLaw::tool_at(Pose{below * axis, axis})};
    std::vector<SweepInterval> steps;
    append_steps(still[0], 0, steps);
    const Bounds least = proven(tool.bare, tree, sweep_frame(steps, tree.origin, tree.rounding_mm), 0);
    for (std::uint32_t t = 0; t < 2; ++t) {
      const double sampled = sampled_distance(tool.bare, still, tree.corners(t));
      ASSERT_GE(sampled, static_cast<double>(least.triangle[t])) << "case " << i;
      ASSERT_GE(sampled, static_cast<double>(least.node[0])) << "case " << i;
    }
  }
}

// The gradient of a cone on its own axis points along the axis and is shorter than 1: not a direction to reach along.
TEST(Sweep, APointOnTheAxisInsideACutterThatWidensIsAsDeepAsTheCone) {
  const ToolVariants tool = tools::variants(tools::assembly(TaperedCutter{4, 0.5, 30, 16}, 20));
  IndexedMesh mesh;
  mesh.vertices = {{0, 0, 8}, {0.5, 0, 7.5}, {0, 0.5, 7.5}};
  shapes::add_triangle(mesh, 0, 1, 2);
  const BlockTree tree = build_block_tree({&mesh, 1}, 1);
  const std::vector<Motion> still{MotionLaw::tool_at(Pose{Vec3::Zero(), Vec3::UnitZ()})};
  std::vector<SweepInterval> steps;
  append_steps(still[0], 0, steps);
  const SweepFrame frame = sweep_frame(steps, tree.origin, tree.rounding_mm);
  const double sampled = sampled_distance(tool.bare, still, tree.corners(0));
  EXPECT_LT(sampled, -5);
  for (const float need : {-5.0F, -4.5F, -4.2F, -4.0F}) {
    EXPECT_LT(proven(tool.bare, tree, frame, need).triangle[0], need);
    EXPECT_LT(proven(tool.bare, tree, frame, need).node[0], need);
  }
}

// Reason for its speed: of a thousand positions over a surface hardly one triangle needs the exact search.
TEST(Sweep, AClearPassOverASurfaceNeedsNoExactSearch) {
  const IndexedMesh ball = shapes::sphere(50, 96);
  const ToolVariants tool = tools::ball();
  const BlockTree tree = build_block_tree({&ball, 1}, 1);
  std::vector<Motion> motions;
  const auto over = [](double angle) {
    const Vec3 out(std::sin(angle), 0, std::cos(angle));
    return Pose{50.005 * out, out};
  };
  for (int k = 0; k < 256; ++k) motions.push_back(test::straight(over(0.005 * k), over(0.005 * (k + 1))));
  const std::vector<SearchTarget> targets{{&tool.against_part, &tree, Against::part}};
  std::size_t seeds = 0;
  std::uint64_t bounds = 0;
  for (const SweptMove& swept : sweep_moves(motions, targets, {{0.01, 0.001, 0.001, 1000000}, 0})) {
    seeds += swept.start.seeds.size();
    bounds += swept.bounds;
    EXPECT_LE(swept.start.certified_mm, 0.011);
    EXPECT_EQ(swept.start.value_mm, 0);
  }
  EXPECT_LE(seeds, 25U);
  EXPECT_LE(bounds, 256U * 20);
}

}  // namespace
}  // namespace gouge::sweep_test
