// Random dirty meshes: what filters and boxes leave to the exact predicates is all there is to find.
#include "lib/validate/self_intersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "lib/base/parallel.h"
#include "lib/mesh/mesh_builder.h"
#include "lib/validate/cgal_bridge.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

namespace gouge::self_intersections_test {
namespace {

using test::Scatter;

/// Places where much coincides: a coarse grid, a line, a plane, or anywhere.
Vec3 random_place(Scatter& random, int kind) {
  const Vec3 grid(std::floor(random.in(0, 4)), std::floor(random.in(0, 4)), std::floor(random.in(0, 3)));
  switch (kind) {
    case 0:
      return grid;
    case 1:
      return {grid.x(), grid.y(), 0};
    case 2:  // a plane that is not along the axes
      return {grid.x(), grid.y(), 0.5 * grid.x() - 0.25 * grid.y()};
    case 3:  // the same plane, but for rounding
      return {0.1 * grid.x(), 0.1 * grid.y(), 0.3 * (0.1 * grid.x()) - 0.7 * (0.1 * grid.y())};
    case 4:  // nearly one plane
      return {grid.x(), grid.y(), random.in(-1, 1) * std::pow(10, random.in(-18, -8))};
    default:
      return random.point(2);
  }
}

/// Triangles over few places, so that they share corners and sides; some lie twice, some on a line.
IndexedMesh random_soup(Scatter& random) {
  const int kind = static_cast<int>(random.below(6));
  const double scale = random.is(0.5) ? 1 : std::pow(10, random.in(-12, 8));
  const Vec3 shift = random.is(0.5) ? Vec3::Zero() : random.point(std::pow(10, random.in(-3, 8)));
  std::vector<Vec3> places;
  for (std::size_t n = 5 + random.below(30); n-- > 0;) places.push_back(random_place(random, kind) * scale + shift);
  TriangleSoup soup;
  for (std::size_t n = 4 + random.below(60); n-- > 0;) {
    const auto place = [&] { return places[random.below(places.size())]; };
    soup.triangles.push_back({place(), place(), place()});
    if (random.is(0.1)) soup.triangles.push_back(soup.triangles[random.below(soup.triangles.size())]);
  }
  const Result<BuiltMesh> built = build_mesh(soup);
  return built ? built->mesh : IndexedMesh{};  // none where all places round to one
}

/// A closed surface, dented at random or not, and perhaps laid over itself.
IndexedMesh random_surface(Scatter& random) {
  IndexedMesh mesh = random.is(0.3)   ? shapes::sphere(10, 6, 10)
                     : random.is(0.5) ? shapes::sheet(10, 10, 0, 8, 8)
                                      : shapes::torus(20, 5, 12, 8);
  const double dent = random.is(0.4) ? 0 : std::pow(10, random.in(-16, 1));
  for (Vec3& v : mesh.vertices) v += random.point(dent);
  if (!random.is(0.5)) return mesh;
  const Vec3 shift = random.is(0.3) ? Vec3::Zero() : Vec3(random.point(std::pow(10, random.in(-16, 1))));
  return shapes::joined(mesh, shapes::moved(mesh, shift));
}

/// All pairs of all triangles with area, each set of corners once, by exact predicates alone.
std::vector<detail::TrianglePair> all_crossings(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  const std::vector<std::uint32_t> flat = detail::without_area(mesh, all).value();
  std::set<TriangleCorners> known;
  std::vector<std::uint32_t> some;
  for (const std::uint32_t t : all) {
    TriangleCorners corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    const bool is_new = known.insert(corners).second;
    if (is_new && !std::binary_search(flat.begin(), flat.end(), t)) some.push_back(t);
  }
  std::vector<detail::TrianglePair> pairs;
  for (std::size_t i = 0; i < some.size(); ++i) {
    for (std::size_t k = i + 1; k < some.size(); ++k) pairs.emplace_back(some[i], some[k]);
  }
  return detail::crossing_pairs(mesh, pairs).value();
}

void expect_all_found(const IndexedMesh& mesh, const std::string& what) {
  const std::vector<detail::TrianglePair> expected = all_crossings(mesh);
  const auto flat = detail::find_triangles_without_area(mesh).value();
  std::vector<std::uint32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(flat, detail::without_area(mesh, all).value()) << what;
  const SelfIntersections found = detail::find_self_intersections(mesh, flat, true).value();
  ASSERT_EQ(found.pairs, expected.size()) << what;
  if (expected.empty()) return;
  const detail::TrianglePair first = *std::min_element(expected.begin(), expected.end());
  EXPECT_EQ(found.first_triangle, mesh.file_triangle[first.first]) << what;
  EXPECT_EQ(found.second_triangle, mesh.file_triangle[first.second]) << what;
}

TEST(SelfIntersectionLaw, RandomSoupsHaveThoseThatAllPairsHave) {
  std::size_t crossing = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    Scatter random(seed);
    const IndexedMesh mesh = random_soup(random);
    expect_all_found(mesh, "soup " + std::to_string(seed));
    crossing += all_crossings(mesh).empty() ? 0U : 1U;
  }
  EXPECT_GT(crossing, 300U);
}

TEST(SelfIntersectionLaw, RandomSurfacesHaveThoseThatAllPairsHave) {
  std::size_t crossing = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Scatter random(seed);
    const IndexedMesh mesh = random_surface(random);
    expect_all_found(mesh, "surface " + std::to_string(seed));
    crossing += all_crossings(mesh).empty() ? 0U : 1U;
  }
  EXPECT_GT(crossing, 40U);
  EXPECT_LT(crossing, 180U);
}

TEST(FindSelfIntersections, AreThoseOfOneThreadAtAnyNumber) {
  const IndexedMesh mesh =
      shapes::joined(shapes::sphere(10, 60, 90), shapes::moved(shapes::sphere(10, 60, 90), {3, 1, 2}));
  const auto found = [&](unsigned threads) {
    set_default_threads(threads);
    return detail::find_self_intersections(mesh, {}, false).value();
  };
  const SelfIntersections one = found(1), three = found(3);
  set_default_threads(0);
  EXPECT_GT(one.pairs, 100U);
  EXPECT_EQ(one.pairs, three.pairs);
  EXPECT_EQ(one.first_triangle, three.first_triangle);
  EXPECT_EQ(one.second_triangle, three.second_triangle);
  EXPECT_EQ(one.position_mm, three.position_mm);
}

// A corner far away must not make all near triangles examine each other, as lengths in single precision would.
TEST(FindSelfIntersections, AFarCornerCostsNoPrecision) {
  IndexedMesh mesh = shapes::sphere(1, 200, 200);
  const std::size_t n = mesh.vertices.size();
  mesh.vertices.insert(mesh.vertices.end(), {Vec3(1e9, 1e9, 1e9), Vec3(1e9, 1e9, 9e8), Vec3(1e9, 9e8, 1e9)});
  shapes::add_triangle(mesh, n, n + 1, n + 2);
  EXPECT_EQ(detail::find_self_intersections(mesh, {}, false)->pairs, 0U);
}

}  // namespace
}  // namespace gouge::self_intersections_test
