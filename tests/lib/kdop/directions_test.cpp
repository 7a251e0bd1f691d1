#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/kdop/directions.h"
#include "lib/kdop/kdop_corners.h"
#include "tests/support/scatter.h"

namespace gouge::directions_test {
namespace {

std::vector<Vec3> cloud(std::size_t count, std::uint64_t seed) {
  test::Scatter random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(random.in(0, 2) * random.direction().cwiseProduct(Vec3(3, 1, 2)) + Vec3(50, -20, 7));
  return points;
}

TEST(Directions, OfTheCubeAreTheAskedNumberOfUnitAxesNoTwoAlike) {
  for (const std::size_t k : {6U, 14U, 18U, 26U}) {
    const DirectionSet set = cube_directions(k);
    EXPECT_EQ(set.k(), k);
    for (std::size_t i = 0; i < set.axes.size(); ++i) {
      EXPECT_NEAR(set.axes[i].norm(), 1, 1e-12);
      for (std::size_t j = 0; j < i; ++j) EXPECT_LT(std::abs(set.axes[i].dot(set.axes[j])), 0.99) << k;
    }
  }
}

TEST(KdopCorners, OfACubeAreItsEight) {
  const DirectionSet six = cube_directions(6);
  EXPECT_EQ(kdop_corners(six, intervals_of(six, std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1, 2, 3)})).size(), 8U);
}

TEST(KdopCorners, AreAtMostAsManyAsTheThesisCounts) {
  const std::vector<Vec3> points = cloud(4000, 1);
  for (const auto& [k, most] : {std::pair{6U, 8U}, {14U, 24U}, {18U, 32U}, {26U, 48U}}) {
    const DirectionSet set = cube_directions(k);
    const std::size_t corners = kdop_corners(set, intervals_of(set, points)).size();
    EXPECT_LE(corners, most) << k;
    EXPECT_GE(corners, 8U) << k;
  }
}

TEST(KdopCorners, HoldThePointsAlongEveryDirectionFlatCloudsIncluded) {
  test::Scatter random(2);
  for (const std::size_t k : {6U, 14U, 26U}) {
    const DirectionSet set = cube_directions(k);
    for (int flat = 0; flat < 3; ++flat) {
      std::vector<Vec3> points = cloud(60, 3 + k);
      for (Vec3& p : points) {
        if (flat > 0) p.z() = 4;
        if (flat > 1) p.y() = p.x();
      }
      const std::vector<Vec3> corners = kdop_corners(set, intervals_of(set, points));
      ASSERT_FALSE(corners.empty());
      for (int i = 0; i < 300; ++i) {
        const Vec3 u = random.direction();
        const auto reach = [&](const std::vector<Vec3>& all) {
          double most = -1e300;
          for (const Vec3& p : all) most = std::max(most, u.dot(p));
          return most;
        };
        EXPECT_GE(reach(corners), reach(points) - 1e-6) << k << " flat " << flat;
      }
    }
  }
}

/// Appendix B: bounding the turned volume is never tighter than bounding the turned points.
TEST(KdopCorners, TurnedAreNoTighterThanThePointsAndLooseByAFewPercentWithManyDirections) {
  const std::vector<Vec3> points = cloud(500, 9);
  double loose6 = 0, loose26 = 0;
  for (const std::size_t k : {6U, 26U}) {
    const DirectionSet set = cube_directions(k);
    const std::vector<Vec3> corners = kdop_corners(set, intervals_of(set, points));
    double sum = 0, own = 0;
    for (int i = 1; i < 40; ++i) {
      const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1 * i, Vec3(1, 2, -1).normalized()).toRotationMatrix();
      const auto width = [&](std::vector<Vec3> all) {
        for (Vec3& p : all) p = turn * p;
        double total = 0;
        for (const Interval& side : intervals_of(set, all)) total += side.high - side.low;
        return total;
      };
      EXPECT_GE(width(corners), width(points) - 1e-9);
      sum += width(corners);
      own += width(points);
    }
    (k == 6 ? loose6 : loose26) = sum / own - 1;
  }
  std::cout << "turned volumes are wider by " << 100 * loose6 << " % (k = 6) and " << 100 * loose26 << " % (k = 26)\n";
  EXPECT_LT(loose26, 0.5 * loose6);
  EXPECT_LT(loose26, 0.15);
}

}  // namespace
}  // namespace gouge::directions_test
