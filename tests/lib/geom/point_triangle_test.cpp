#include "lib/geom/point_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "tests/support/scatter.h"

namespace gouge::point_triangle_test {
namespace {

/// A hundred digits: exact far beyond what is needed, also for triangles a millionth of a nanometre wide.
using Number = boost::multiprecision::cpp_bin_float_100;
using Exact = std::array<Number, 3>;
using Triangle = std::array<Vec3, 3>;

/// Triangles of every width from that of rounding to that of its length; the third corner also beyond the ends of the edge.
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

Exact minus(const Vec3& a, const Vec3& b) { return {Number(a[0]) - b[0], Number(a[1]) - b[1], Number(a[2]) - b[2]}; }
Number dot(const Exact& a, const Exact& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Number distance2_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Exact ap = minus(p, a), ab = minus(b, a);
  const Number length2 = dot(ab, ab);
  Number share = length2 > 0 ? Number(dot(ap, ab) / length2) : Number(0);
  if (share < 0) share = 0;
  if (share > 1) share = 1;
  Number sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (ap[k] - share * ab[k]) * (ap[k] - share * ab[k]);
  return sum;
}

double true_distance(const Vec3& p, const Triangle& t) {
  Number least = distance2_to_edge(p, t[0], t[1]);
  for (const Number& other : {distance2_to_edge(p, t[1], t[2]), distance2_to_edge(p, t[2], t[0])}) {
    if (other < least) least = other;
  }
  const Exact u = minus(t[1], t[0]), v = minus(t[2], t[0]), q = minus(p, t[0]);
  const Number uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), qu = dot(q, u), qv = dot(q, v);
  const Number area2 = uu * vv - uv * uv;
  if (area2 > 0) {
    const Number b = (vv * qu - uv * qv) / area2, c = (uu * qv - uv * qu) / area2;
    if (b > 0 && c > 0 && b + c < 1) {
      Number sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += (q[k] - b * u[k] - c * v[k]) * (q[k] - b * u[k] - c * v[k]);
      least = sum;
    }
  }
  return static_cast<double>(sqrt(least));
}

TEST(PointTriangle, IsAPointOfTheTriangleAndNoneIsNearerHoweverNarrowItIs) {
  test::Scatter random(8);
  for (int i = 0; i < 20'000; ++i) {
    const Triangle t = random_triangle(random);
    const Vec3 p = random_point(t, random);
    const TrianglePoint found = closest_on_triangle(p, t);
    double size = 0, coordinates = 0;
    for (const Vec3& corner : t) {
      size = std::max({size, (corner - p).norm(), (corner - t[0]).norm()});
      coordinates = std::max(coordinates, corner.cwiseAbs().maxCoeff());
    }
    // The foot is rounded to coordinates of the part's frame.
    const double place = 4e-16 * coordinates + 1e-11 * size;
    const double distance = (found.point - p).norm();
    ASSERT_NEAR(distance, true_distance(p, t), place) << i;
    ASSERT_NEAR(std::sqrt(found.distance2_mm2), distance, 1e-12 * size) << i;
    for (int k = 0; k < 10; ++k) {
      const Vec3 way = random.direction();
      double most = way.dot(t[0] - found.point);
      for (const Vec3& corner : t) most = std::max(most, way.dot(corner - found.point));
      ASSERT_GE(most, -place) << i;
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
}  // namespace gouge::point_triangle_test
