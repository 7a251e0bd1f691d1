#include "lib/penetration/bound_block.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "lib/penetration/depth_body.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"

namespace gouge {
namespace {

constexpr std::size_t kLanes = BoundBlock::kLanes;

DepthBody distance_body(const IndexedMesh& mesh) {
  DepthBodyOptions options;
  options.is_distance_only = true;
  return build_depth_body(mesh, options);
}

/// The least distance of a point to the facets below a lane.
double truth(const DepthBody& body, std::uint32_t below, const Vec3& point) {
  if ((below & BoundBlock::kIsFacet) != 0)
    return std::sqrt(closest_on_triangle(point, body.corners[below & ~BoundBlock::kIsFacet]).distance2_mm2);
  const BoundBlock& block = body.blocks[below];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (block.low[0][lane] < std::numeric_limits<float>::max())
      least = std::min(least, truth(body, block.below[lane], point));
  }
  return least;
}

TEST(BoundBlock, GivesTheSameBytesWithEveryInstructionSet) {
  const DepthBody body = distance_body(shapes::bumpy_sphere());
  RandomPoints random(body.mesh, 5, 1);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3f p = random.next().cast<float>();
    const BoundBlock& block = body.blocks[static_cast<std::size_t>(i) % body.blocks.size()];
    alignas(32) float plain[kLanes], other[kLanes];
    bound_kernels()[0]->least_mm(block, p.data(), 1e-5F, plain);
    for (std::size_t k = 1; k < bound_kernels().size(); ++k) {
      bound_kernels()[k]->least_mm(block, p.data(), 1e-5F, other);
      ASSERT_EQ(std::memcmp(plain, other, sizeof plain), 0) << bound_kernels()[k]->name;
    }
  }
}

TEST(BoundBlock, IsNeverAboveTheDistanceAndOftenNearIt) {
  for (const double shift : {0.0, 1e5}) {
    IndexedMesh mesh = shapes::needle_fan(60);
    for (Vec3& v : mesh.vertices) v += Vec3(shift, -shift, shift);
    const DepthBody body = distance_body(mesh);
    RandomPoints random(body.mesh, 5, 2);
    std::size_t lanes = 0, near = 0;
    for (int i = 0; i < 400; ++i) {
      const Vec3 point = random.next();
      const Eigen::Vector3f p = point.cast<float>();
      const float slack = 16 * body.slack_mm;
      for (const BoundBlock& block : body.blocks) {
        alignas(32) float least[kLanes];
        fastest_bound_kernel().least_mm(block, p.data(), slack, least);
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (!(block.low[0][lane] < std::numeric_limits<float>::max())) continue;
          const double distance = truth(body, block.below[lane], point);
          ASSERT_LE(static_cast<double>(least[lane]), distance) << shift;
          ++lanes;
          near += static_cast<double>(least[lane]) > 0.5 * distance - static_cast<double>(slack) ? 1U : 0U;
        }
      }
    }
    EXPECT_GT(near, lanes / 2) << shift;
  }
}

TEST(BoundBlock, HoldsEveryFacetOnceWhateverTheLeafAndTheWidth) {
  for (const std::size_t width : {2U, 4U, 8U}) {
    for (const std::size_t leaf : {1U, 3U, 8U, 40U}) {
      DepthBodyOptions options;
      options.is_distance_only = true;
      options.width = width;
      options.leaf_triangles = leaf;
      const DepthBody body = build_depth_body(shapes::bumpy_sphere(), options);
      std::vector<int> facets(body.corners.size(), 0), blocks(body.blocks.size(), 0);
      for (const BoundBlock& block : body.blocks) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          if (!(block.low[0][lane] < std::numeric_limits<float>::max())) continue;
          const std::uint32_t below = block.below[lane];
          const bool is_facet = (below & BoundBlock::kIsFacet) != 0;
          ++(is_facet ? facets[below & ~BoundBlock::kIsFacet] : blocks[below]);
        }
      }
      EXPECT_EQ(std::count(facets.begin(), facets.end(), 1), static_cast<std::ptrdiff_t>(facets.size()));
      EXPECT_EQ(std::count(blocks.begin() + 1, blocks.end(), 1), static_cast<std::ptrdiff_t>(blocks.size()) - 1);
      EXPECT_EQ(blocks[0], 0);
    }
  }
}

}  // namespace
}  // namespace gouge
