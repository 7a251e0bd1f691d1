#include "lib/geom/point_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/scatter.h"

namespace gouge {
namespace {

using Exact = Eigen::Matrix<long double, 3, 1>;
using Triangle = std::array<Vec3, 3>;

/// Of every width from that of rounding to that of its length; the third corner also beyond the ends of the edge.
Triangle random_triangle(test::Scatter& random) {
  const double length = std::pow(10.0, random.in(-3, 3)), width = length * std::pow(10.0, random.in(-17, 0));
  const Vec3 base = random.is(0.5) ? Vec3(random.point(1e5)) : Vec3::Zero(), along = length * random.direction();
  const double share = random.is(0.3) ? std::round(random.in(0, 1)) : random.in(-0.2, 1.2);
  Triangle t{base, base + along, base + share * along + width * random.direction()};
  if (random.is(0.5)) std::swap(t[0], t[1]);
  if (random.is(0.67)) std::swap(t[random.below(2)], t[2]);
  return t;
}

Vec3 random_point(const Triangle& t, test::Scatter& random) {
  const double u = random.in(0, 1), v = random.in(0, 1 - u);
  const Vec3 at = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
  return at + (t[1] - t[0]).norm() * std::pow(10.0, random.in(-12, 3)) * random.direction();
}

/// By how much the distance of `foot` may be above the least: the plane across the way to it has the triangle beyond.
long double excess(const Vec3& p, const Triangle& t, const Vec3& foot) {
  const Exact at = p.cast<long double>(), way = foot.cast<long double>() - at;
  const long double distance = way.norm();
  if (!(distance > 0)) return 0;
  long double least = distance;
  for (const Vec3& corner : t) least = std::min(least, (corner.cast<long double>() - at).dot(way) / distance);
  return distance - std::max(least, 0.0L);
}

TEST(PointTriangle, IsAPointOfTheTriangleAndNoneIsNearerHoweverNarrowItIs) {
  test::Scatter random(8);
  for (int i = 0; i < 200'000; ++i) {
    const Triangle t = random_triangle(random);
    const Vec3 p = random_point(t, random);
    const TrianglePoint found = closest_on_triangle(p, t);
    long double size = 0, coordinates = 0;
    for (const Vec3& corner : t) {
      size = std::max<long double>({size, (corner - p).norm(), (corner - t[0]).norm()});
      coordinates = std::max<long double>(coordinates, corner.cwiseAbs().maxCoeff());
    }
    // A foot has coordinates of the part's frame: its last place turns the way to it.
    const long double place = 4e-15L * coordinates + 1e-11L * size;
    const long double distance = (found.point - p).cast<long double>().norm();
    const long double turned = distance > 0 ? place * size / distance : 0;
    ASSERT_LE(excess(p, t, found.point), place + std::min(distance, turned)) << i;
    ASSERT_NEAR(std::sqrt(found.distance2_mm2), static_cast<double>(distance), 1e-12 * static_cast<double>(size)) << i;
    for (int k = 0; k < 10; ++k) {
      const Vec3 way = random.direction();
      double most = way.dot(t[0] - found.point);
      for (const Vec3& corner : t) most = std::max(most, way.dot(corner - found.point));
      ASSERT_GE(most, -static_cast<double>(place)) << i;
    }
  }
}

TEST(PointTriangle, OfATriangleWithoutAreaIsOnItsEdgesAndOfOneWithoutExtentItsCorner) {
  const Vec3 o(1, 2, 3), x(1, 0, 0), up(0, 0, 1);
  for (const double share : {-0.5, 0.0, 0.3, 1.0, 1.5}) {
    const TrianglePoint found = closest_on_triangle(o + 0.25 * x + up, {o, o + x, o + share * x});
    EXPECT_NE(found.feature, TriangleFeature::face);
    EXPECT_NEAR((found.point - o - 0.25 * x).norm(), 0, 1e-15) << share;
  }
  const TrianglePoint found = closest_on_triangle(o + up, {o, o, o});
  EXPECT_EQ(found.feature, TriangleFeature::corner);
  EXPECT_EQ(found.point, o);
}

}  // namespace
}  // namespace gouge
