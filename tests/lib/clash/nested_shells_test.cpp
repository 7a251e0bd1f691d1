#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "lib/clash/clash.h"
#include "tests/support/lattice_boxes.h"

// Random pairs of bodies whose shells nest, overlap, share faces and face inward, against cells that are counted:
// depth <= true depth <= depth_upper, and the state is what the common points show.

namespace gouge::nested_shells_test {
namespace {

struct Placed {
  test::LatticeBoxes boxes;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();

  [[nodiscard]] Vec3 own(const Vec3& point) const { return turn.transpose() * (point - shift); }
  [[nodiscard]] double depth_mm(const Vec3& point) const { return boxes.depth_mm(own(point)); }
  [[nodiscard]] double distance_mm(const Vec3& point) const { return boxes.distance_mm(own(point)); }
  /// In the body, or on its boundary.
  [[nodiscard]] bool holds(const Vec3& point) const { return boxes.is_inside(own(point)) || distance_mm(point) < 1e-6; }
  [[nodiscard]] IndexedMesh mesh() const {
    IndexedMesh mesh = boxes.mesh();
    for (Vec3& vertex : mesh.vertices) vertex = turn * vertex + shift;
    return mesh;
  }
};

/// The deeper depth of a point in both.
double common_depth_mm(const Placed& a, const Placed& b, const Vec3& point) {
  const double in_a = a.depth_mm(point), in_b = b.depth_mm(point);
  return in_a > 0 && in_b > 0 ? std::max(in_a, in_b) : 0;
}

/// Maximum over many random points, each moved uphill by random steps.
double hunted_mm(const Placed& a, const Placed& b, test::Scatter& random, const Vec3& known) {
  const Vec3 middle = Vec3::Constant(6);
  double best = 0;
  for (int k = 0; k < 40; ++k) {
    Vec3 at = k == 0 ? known : Vec3(middle + random.point(7));
    double depth = common_depth_mm(a, b, at);
    if (!(depth > 0) && k > 0) continue;
    for (double step = 2; step > 1e-3; step *= 0.8) {
      for (int n = 0; n < 3; ++n) {
        const Vec3 next = at + random.point(step);
        const double there = common_depth_mm(a, b, next);
        if (!(there > depth)) continue;
        depth = there;
        at = next;
      }
    }
    best = std::max(best, depth);
  }
  return best;
}

unsigned pairs() {
  const char* const asked = std::getenv("GOUGE_NESTED_PAIRS");
  return asked == nullptr ? 320 : static_cast<unsigned>(std::stoul(asked));
}

TEST(NestedShells, OfRandomPairsHaveTheDepthOfCountedCells) {
  std::size_t solid = 0, penetrating = 0, inner = 0;
  for (unsigned seed = 0; seed < pairs(); ++seed) {
    SCOPED_TRACE(seed);
    test::Scatter random(500 + seed);
    const Placed a{test::LatticeBoxes(random, 1 + random.below(5), seed % 4 == 1)};
    Placed b{test::LatticeBoxes(random, 1 + random.below(5), seed % 4 == 2)};
    if (seed % 3 != 0) b.turn = Eigen::AngleAxisd(random.in(-3, 3), random.direction()).toRotationMatrix();
    b.shift = Vec3::Constant(6) - b.turn * Vec3::Constant(6);
    b.shift += seed % 3 == 0 ? Vec3(random.point(8).array().round()) : random.point(9);
    const ClashBody body_a{Surface(a.mesh())}, body_b{Surface(b.mesh())};
    if (!body_a.is_solid() || !body_b.is_solid()) continue;
    ++solid;
    const Clash clash = find_clash(body_a, body_b, Vec3::Zero(), {});
    EXPECT_LE(clash.depth_mm, clash.depth_upper_mm);
    Vec3 known = Vec3::Constant(6);
    for (const Contact& contact : clash.deepest) {
      known = contact.point;
      const Placed& other = contact.body == 0 ? b : a;
      EXPECT_NEAR(other.distance_mm(contact.point), contact.depth_mm, 1e-9);
      EXPECT_TRUE(a.holds(contact.point) && b.holds(contact.point));
    }
    const double found = hunted_mm(a, b, random, known);
    EXPECT_LE(found, clash.depth_upper_mm + 1e-9);
    if (clash.state == ClashState::penetrating) {
      ++penetrating;
      EXPECT_LE(clash.depth_upper_mm - clash.depth_mm, 0.0011);
    } else if (clash.state == ClashState::not_certified) {
      ADD_FAILURE() << clash.reason;
    } else {
      EXPECT_LE(found, 0.011 + 1e-9) << "free or touching";
    }
    inner += body_a.whole().is_boundary() && body_b.whole().is_boundary() ? 0U : 1U;
  }
  EXPECT_GT(solid, pairs() / 2);
  EXPECT_GT(penetrating, pairs() / 4);
  EXPECT_GT(inner, pairs() / 4);
}

}  // namespace
}  // namespace gouge::nested_shells_test
