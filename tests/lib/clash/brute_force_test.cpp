#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <queue>
#include <string>

#include "lib/clash/clash.h"
#include "lib/geom/point_triangle.h"
#include "lib/mesh/opposite_half_edges.h"
#include "tests/lib/clash/pairs.h"

// Random pairs of solids that are not convex, against a search that knows no tree, no convexity and no
// normals: every distance is the least over all triangles, every side a winding number, every bound the
// Lipschitz one.

namespace gouge::brute_force_test {
namespace {

constexpr double kGap_mm = 0.3;
constexpr std::size_t kMaxCells = 3000;

double distance_to(const IndexedMesh& mesh, const Vec3& point) {
  double best2 = 1e300;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    best2 = std::min(
        best2, closest_on_triangle(point, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}).distance2_mm2);
  }
  return std::sqrt(best2);
}

/// Positive inside.
double depth_in(const IndexedMesh& mesh, const Vec3& point) {
  return (winding_number(mesh, point) > 0.5 ? 1 : -1) * distance_to(mesh, point);
}

struct Bracket {
  double low = 0, high = 0;
};

/// The depth of a point of both bodies in the one where it is deeper.
class Reference {
 public:
  Reference(const IndexedMesh& a, const IndexedMesh& b) : a_(a), b_(b) {}

  Bracket run() {
    const Box3 box = a_.box().intersection(b_.box());
    if (box.isEmpty()) return {};
    offer(box);
    for (std::size_t looked = 0; !open_.empty() && looked < kMaxCells; ++looked) {
      const Cell cell = open_.top();
      if (cell.upper <= low_ + kGap_mm) break;
      open_.pop();
      int axis = 0;
      cell.box.sizes().maxCoeff(&axis);
      Box3 left = cell.box, right = cell.box;
      left.max()[axis] = right.min()[axis] = cell.box.center()[axis];
      offer(left);
      offer(right);
    }
    return {low_, open_.empty() ? low_ : std::max(low_, open_.top().upper)};
  }

  /// The deeper one of a point in both; nothing deeper than -1e-9 elsewhere.
  [[nodiscard]] double at(const Vec3& point) const {
    const double in_a = depth_in(a_, point), in_b = depth_in(b_, point);
    return std::min(in_a, in_b) < -1e-9 ? -1 : std::max(in_a, in_b);
  }

 private:
  struct Cell {
    Box3 box;
    double upper = 0;
    bool operator<(const Cell& other) const { return upper < other.upper; }
  };

  void offer(const Box3& box) {
    const Vec3 centre = box.center();
    const double radius = 0.5 * box.diagonal().norm(), in_a = depth_in(a_, centre), in_b = depth_in(b_, centre);
    if (std::min(in_a, in_b) < -radius) return;
    if (std::min(in_a, in_b) >= 0) low_ = std::max({low_, in_a, in_b});
    open_.push({box, std::max(in_a, in_b) + radius});
  }

  const IndexedMesh& a_;
  const IndexedMesh& b_;
  std::priority_queue<Cell> open_;
  double low_ = 0;
};

/// Random steps uphill from a point in both.
double climbed(const Reference& reference, Vec3 point, test::Scatter& random) {
  double best = reference.at(point);
  for (double step = 1; step > 1e-3; step *= 0.8) {
    for (int k = 0; k < 3; ++k) {
      const Vec3 next = point + random.point(step);
      const double depth = reference.at(next);
      if (!(depth > best)) continue;
      best = depth;
      point = next;
    }
  }
  return best;
}

unsigned pairs() {
  const char* const asked = std::getenv("GOUGE_CLASH_PAIRS");
  return asked == nullptr ? 1000 : static_cast<unsigned>(std::stoul(asked));
}

class Quarter : public testing::TestWithParam<unsigned> {};

TEST_P(Quarter, OfRandomPairsHasTheDepthAndThePlaceOfBruteForce) {
  std::size_t penetrating = 0, free = 0;
  for (unsigned seed = GetParam(); seed < pairs(); seed += 4) {
    SCOPED_TRACE(seed);
    const test::Pair pair = test::random_pair(seed);
    const IndexedMesh &a = pair.a.whole().mesh(), &b = pair.b.whole().mesh();
    const Clash clash = find_clash(pair.a, pair.b, Vec3::Zero(), {});
    ASSERT_NE(clash.state, ClashState::not_certified) << clash.reason;
    Reference reference(a, b);
    const Bracket truth = reference.run();
    EXPECT_LE(clash.depth_mm, truth.high + 1e-9);
    EXPECT_GE(clash.depth_upper_mm, truth.low - 1e-9);
    if (clash.state == ClashState::penetrating) {
      ++penetrating;
      EXPECT_LE(clash.depth_upper_mm - clash.depth_mm, 0.0011);
      for (const Contact& contact : clash.deepest) {
        const IndexedMesh &own = contact.body == 0 ? a : b, &other = contact.body == 0 ? b : a;
        EXPECT_NEAR(distance_to(other, contact.point), contact.depth_mm, 1e-9);
        EXPECT_GT(depth_in(other, contact.point), -1e-9);
        EXPECT_GT(depth_in(own, contact.point), -1e-9);
        const Vec3 out = (contact.body == 0 ? -1 : 1) * contact.normal;
        EXPECT_LT(distance_to(other, contact.point + contact.depth_mm * out), 1e-6) << "the normal leads out";
      }
      test::Scatter random(seed);
      EXPECT_LE(climbed(reference, clash.deepest.front().point, random), clash.depth_upper_mm + 1e-9);
      for (int k = 0; k < 4; ++k) {
        const Vec3 start = a.box().intersection(b.box()).center() + random.point(4);
        EXPECT_LE(climbed(reference, start, random), clash.depth_upper_mm + 1e-9);
      }
    } else if (clash.state == ClashState::free) {
      ++free;
      EXPECT_LE(truth.low, 0);
      for (const Vec3& vertex : a.vertices) {
        EXPECT_LT(depth_in(b, vertex), 0);
        EXPECT_GE(distance_to(b, vertex), clash.closest.distance_mm - 1e-9);
      }
      EXPECT_LT(distance_to(a, clash.closest.a), 1e-9);
      EXPECT_LT(distance_to(b, clash.closest.b), 1e-9);
    }
  }
  EXPECT_GT(penetrating, pairs() / 16);
  EXPECT_GT(free, pairs() / 64);
}

// Faces that lie on each other, edges along edges, corners on corners: what random places never give.
TEST(LatticeSolids, TouchWhereTheyShareNoCubeAndPenetrateWhereTheyDo) {
  std::size_t touching = 0, penetrating = 0, free = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    test::Scatter random(1000 + seed);
    const test::LatticeSolid a(random), b(random);
    constexpr int kSide = test::LatticeSolid::kSide;
    const auto offset = [&] { return static_cast<int>(random.below(2 * kSide + 3)) - kSide - 1; };
    const int x = offset(), y = offset(), z = offset();
    bool is_shared = false, is_near = false;
    for (int k = 0; k < 27 * kSide * kSide * kSide; ++k) {
      const int i = k % kSide, j = k / kSide % kSide, m = k / (kSide * kSide) % kSide, n = k / (kSide * kSide * kSide);
      if (!b.at(i, j, m)) continue;
      is_near = is_near || a.at(i + x + n % 3 - 1, j + y + n / 3 % 3 - 1, m + z + n / 9 - 1);
      is_shared = is_shared || a.at(i + x, j + y, m + z);
    }
    // Turned, so that nothing is exact any more.
    const Vec3 axis = random.direction();
    const double angle = random.in(-3, 3);
    const test::Pair pair(test::placed(a.mesh(), axis, angle, Vec3::Zero()),
                          test::placed(shapes::moved(b.mesh(), Vec3(x, y, z)), axis, angle, Vec3::Zero()));
    const Clash clash = find_clash(pair.a, pair.b, Vec3::Zero(), {});
    const ClashState expected =
        is_shared ? ClashState::penetrating : (is_near ? ClashState::touching : ClashState::free);
    EXPECT_EQ(static_cast<int>(clash.state), static_cast<int>(expected)) << clash.reason;
    ++(is_shared ? penetrating : is_near ? touching : free);
    if (is_shared) {
      EXPECT_GE(clash.depth_upper_mm, 0.5 - 1e-9) << "half a cube";
    }
    const Bracket truth = Reference(pair.a.whole().mesh(), pair.b.whole().mesh()).run();
    EXPECT_LE(clash.depth_mm, truth.high + 1e-9);
    EXPECT_GE(clash.depth_upper_mm, truth.low - 1e-9);
  }
  EXPECT_GT(touching, 20U);
  EXPECT_GT(penetrating, 50U);
  EXPECT_GT(free, 10U);
}

INSTANTIATE_TEST_SUITE_P(Clash, Quarter, testing::Range(0U, 4U));

}  // namespace
}  // namespace gouge::brute_force_test
