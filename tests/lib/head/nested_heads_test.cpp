#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "lib/head/head_search.h"
#include "tests/support/lattice_boxes.h"
#include "tests/support/motions.h"
#include "tests/support/solids.h"

// Heads whose shells nest, overlap, share faces and face inward, against cells that are counted.

namespace gouge::nested_heads_test {
namespace {

constexpr double kScale = 3;

/// Boxes about the tool axis as a head.
class BoxHead {
 public:
  BoxHead(test::Scatter& random, std::size_t count, bool has_cavities) : boxes_(random, count, has_cavities) {}

  [[nodiscard]] IndexedMesh mesh() const {
    IndexedMesh mesh = boxes_.mesh();
    for (Vec3& vertex : mesh.vertices) vertex = kScale * (vertex - Vec3::Constant(6));
    return mesh;
  }
  [[nodiscard]] double depth_mm(const Vec3& point) const {
    return kScale * boxes_.depth_mm(point / kScale + Vec3::Constant(6));
  }

 private:
  test::LatticeBoxes boxes_;
};

TEST(NestedHeads, BoundTheDepthInAllShellsTogether) {
  test::Scatter random(31);
  const IndexedMesh part = shapes::star_prism(4, 8, 3, 14);
  const BlockTree tree = build_block_tree({&part, 1});
  const std::array targets{HeadTarget{&tree}};
  std::size_t heads = 0, gouges = 0, inner = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const BoxHead boxes(random, 2 + random.below(4), i % 3 == 2);
    const Result<HeadBody> head = build_head_body(boxes.mesh());
    if (!head) continue;  // a shell that stands out inside out is no cavity
    ++heads;
    inner += head->whole.is_boundary() ? 0U : 1U;
    for (std::size_t k = 0; k < head->cores.size(); ++k)
      EXPECT_NEAR(boxes.depth_mm(head->cores[k]), head->core_depths_mm[k], 1e-9);
    const Motion motion = test::straight(Pose{25 * random.direction(), random.direction()},
                                         Pose{25 * random.direction(), random.direction()});
    const BodyMotion moving(motion);
    const HeadResult found = search_head(moving, *head, targets, {0.01, 0.02, 0.02, 20000});
    double sampled = 0;
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      for (int k = 0; k < 8; ++k) {
        const double u = random.in(0, 1), v = (1 - u) * random.in(0, 1);
        const Vec3 p = part.corner(t, 0) + u * (part.corner(t, 1) - part.corner(t, 0)) +
                       v * (part.corner(t, 2) - part.corner(t, 0));
        for (int s = 0; s <= 20; ++s)
          sampled = std::max(sampled, boxes.depth_mm(moving.at(s / 20.0).inverse().point(p)));
      }
    }
    EXPECT_LE(sampled, found.depth_upper_mm + 1e-9);
    if (!found.has_witness) continue;
    ++gouges;
    EXPECT_NEAR(boxes.depth_mm(moving.at(found.t).inverse().point(found.point)), found.depth_mm, 1e-9);
  }
  EXPECT_GT(heads, 100U);
  EXPECT_GT(gouges, 50U);
  EXPECT_GT(inner, 50U);
}

// A body that only touches another along a line, or lies apart from it, must have a core of its own.
TEST(NestedHeads, HaveACoreInEachConnectedPart) {
  const IndexedMesh block = shapes::box(Vec3(0, 0, 0), Vec3(20, 20, 20));
  const IndexedMesh nested = shapes::joined(block, shapes::box(Vec3(5, 5, 5), Vec3(15, 15, 15)));
  const IndexedMesh crossed =
      shapes::joined(shapes::moved(block, Vec3(50, 0, 0)), shapes::box(Vec3(65, 5, 5), Vec3(80, 9, 9)));
  const HeadBody head = *build_head_body(shapes::joined(nested, crossed));
  std::size_t left = 0, right = 0;
  for (std::size_t k = 0; k < head.cores.size(); ++k) {
    ++(head.cores[k].x() < 30 ? left : right);
    EXPECT_GT(head.core_depths_mm[k], 1);
  }
  EXPECT_GE(left, 1U);
  EXPECT_GE(right, 1U);
}

// The first triangle of a body in a file with others may be a sliver at a sharp edge, where no ball fits.
TEST(NestedHeads, HaveACoreInABodyThatBeginsWithASliver) {
  const IndexedMesh block = shapes::refined(shapes::box(Vec3(-40, -40, 300), Vec3(40, 40, 400)), 4);
  const IndexedMesh others = shapes::joined(block, shapes::moved(block, Vec3(20.3, 23.7, 50.9)));
  for (const double height : {1.0, 1e-3, 4e-6}) {
    IndexedMesh body = shapes::box(Vec3(98, 0, 98), Vec3(102, 4, 102));
    std::erase_if(body.triangles, [&](const TriangleCorners& t) {
      return std::ranges::all_of(t, [&](Corner c) { return body.vertices[c].z() > 101; });
    });
    const auto top = [&](double x, double y) {
      const auto found = std::ranges::find(body.vertices, Vec3(x, y, 102));
      return static_cast<Corner>(found - body.vertices.begin());
    };
    const Corner a = top(98, 0), b = top(102, 0), c = top(102, 4), d = top(98, 4);
    const auto middle = static_cast<Corner>(body.vertices.size());
    body.vertices.emplace_back(100, height, 102);
    body.triangles.insert(body.triangles.begin(), {{a, b, middle}, {b, c, middle}, {c, d, middle}, {d, a, middle}});
    body.file_triangle.resize(body.triangles.size());
    for (std::uint32_t t = 0; t < body.triangles.size(); ++t) body.file_triangle[t] = t + 1;
    const HeadBody head = *build_head_body(shapes::joined(body, others));
    const auto is_in_body = [](const Vec3& core) { return core.x() > 98 && core.z() < 102; };
    const auto found = std::ranges::find_if(head.cores, is_in_body);
    ASSERT_NE(found, head.cores.end()) << height;
    EXPECT_GT(head.core_depths_mm[static_cast<std::size_t>(found - head.cores.begin())], 1) << height;
  }
}

}  // namespace
}  // namespace gouge::nested_heads_test
