#include "lib/surface/solid_boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "lib/mesh/opposite_half_edges.h"
#include "lib/surface/surface.h"
#include "tests/support/lattice_boxes.h"
#include "tests/support/solids.h"

namespace gouge::solid_boundary_test {
namespace {

IndexedMesh turned(IndexedMesh mesh, const Eigen::Matrix3d& by) {
  for (Vec3& vertex : mesh.vertices) vertex = by * vertex;
  return mesh;
}

TEST(SolidBoundary, OfShellsApartIsTheSurfaceItself) {
  const IndexedMesh block = shapes::box(Vec3(0, 0, 0), Vec3(10, 10, 10));
  for (const IndexedMesh& mesh :
       {block, shapes::hollow_cube(), shapes::torus(), shapes::bumpy_sphere(), shapes::star_prism(),
        shapes::joined(block, shapes::moved(block, Vec3(20, 0, 0))), shapes::refined(block, 3),
        shapes::cubes_touching_at_edge(), shapes::cubes_touching_at_vertex()}) {
    EXPECT_TRUE(Surface(mesh).is_boundary()) << mesh.name;
  }
  EXPECT_TRUE(Surface(shapes::open_cube()).is_boundary()) << "of no solid nothing is left out";
}

TEST(SolidBoundary, LeavesOutAShellInTheMaterial) {
  const IndexedMesh block = shapes::box(Vec3::Constant(-10), Vec3::Constant(10));
  const IndexedMesh nested = shapes::joined(block, shapes::box(Vec3::Constant(-4), Vec3::Constant(4)));
  const Surface whole(nested);
  ASSERT_FALSE(whole.is_boundary());
  EXPECT_EQ(whole.boundary().mesh().triangles, block.triangles);
  EXPECT_NEAR(whole.boundary().closest_point(Vec3::Zero())->signed_mm(), -10, 1e-12);
  // A motor with a hollow in it, all of it in a casing: the hollow is wound around once by the casing.
  const IndexedMesh motor =
      shapes::joined(nested, shapes::inside_out(shapes::box(Vec3::Constant(-2), Vec3::Constant(2))));
  EXPECT_NEAR(Surface(motor).boundary().closest_point(Vec3(0, 0, 3))->signed_mm(), -7, 1e-12);
}

TEST(SolidBoundary, TurnsAShellThatFacesInwardAndStandsOut) {
  const IndexedMesh part =
      shapes::joined(shapes::cube(20), shapes::inside_out(shapes::box(Vec3(2, 5, 5), Vec3(24, 15, 15))));
  const Surface whole(part);
  ASSERT_TRUE(whole.is_solid());
  const Surface& boundary = whole.boundary();
  const ClosestPoint in_end = *boundary.closest_point(Vec3(22, 10, 10));
  EXPECT_NEAR(in_end.signed_mm(), -2, 1e-12) << "wound around -1 times";
  EXPECT_NEAR(boundary.closest_point(Vec3(10, 10, 10))->signed_mm(), 5, 1e-12) << "in the cavity";
  EXPECT_GT(in_end.normal.dot(in_end.point - Vec3(22, 10, 10)), 0) << "out of the body";
}

TEST(SolidBoundary, OfBoxesOnEachOtherHasNoWallBetweenThem) {
  const IndexedMesh two =
      shapes::joined(shapes::box(Vec3(0, 0, 0), Vec3(10, 10, 10)), shapes::box(Vec3(2, 3, 10), Vec3(8, 9, 20)));
  const Surface whole(two);
  const Surface& boundary = whole.boundary();
  EXPECT_NEAR(boundary.closest_point(Vec3(5, 6, 10))->signed_mm(), -3, 1e-12);
  EXPECT_NEAR(boundary.closest_point(Vec3(1, 1, 9))->signed_mm(), -1, 1e-12);
}

// Side, distance and normal of points against cells that are counted, in any direction in space.
TEST(SolidBoundary, OfRandomBoxesIsWhereTheCellsChange) {
  test::Scatter random(11);
  std::size_t bodies = 0, inner = 0;
  for (int i = 0; i < 300; ++i) {
    SCOPED_TRACE(i);
    const test::LatticeBoxes boxes(random, 2 + random.below(5), i % 3 == 2);
    const Eigen::Matrix3d turn = i % 2 == 0
                                     ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
                                     : Eigen::AngleAxisd(random.in(-3, 3), random.direction()).toRotationMatrix();
    const Surface whole(turned(boxes.mesh(), turn));
    if (!whole.is_solid()) continue;
    ++bodies;
    const Surface& boundary = whole.boundary();
    ASSERT_TRUE(boundary.is_solid());
    for (int k = 0; k < 150; ++k) {
      const Vec3 at = Vec3::Constant(6) + random.point(8);
      const ClosestPoint foot = *boundary.closest_point(turn * at);
      const double distance = boxes.distance_mm(at);
      EXPECT_NEAR(foot.distance_mm, distance, 1e-9) << at.transpose();
      if (distance > 1e-6) {
        EXPECT_EQ(foot.is_inside, boxes.is_inside(at)) << at.transpose();
        const Vec3 beyond = turn.transpose() * (foot.point + (foot.is_inside ? 1e-4 : -1e-4) * foot.normal);
        EXPECT_EQ(boxes.is_inside(beyond), !foot.is_inside) << at.transpose();
      }
      inner += whole.closest_point(turn * at)->distance_mm < distance - 1e-6 ? 1U : 0U;
    }
  }
  EXPECT_GT(bodies, 150U);
  EXPECT_GT(inner, 2000U) << "points nearer to a wall inside the body";
}

/// Two to four bodies that overlap, turned and shifted; some facing inward.
IndexedMesh assembly(test::Scatter& random) {
  IndexedMesh all = shapes::bumpy_sphere(10, 1.5, 8, 14);
  const std::size_t more = 1 + random.below(3);
  for (std::size_t k = 0; k < more; ++k) {
    const double size = random.in(3, 12);
    IndexedMesh one = std::vector{shapes::cube(size), shapes::star_prism(4, size, 0.4 * size, size),
                                  shapes::torus(size, 0.4 * size, 12, 8), shapes::sphere(size, 8, 12)}[random.below(4)];
    one = turned(std::move(one), Eigen::AngleAxisd(random.in(-3, 3), random.direction()).toRotationMatrix());
    one = shapes::moved(std::move(one), random.point(10));
    if (random.is(0.25)) one = shapes::inside_out(std::move(one));
    all = shapes::joined(std::move(all), one);
  }
  return all;
}

// The ball about a point up to the boundary is all on its side, and next to the nearest point is the other one.
TEST(SolidBoundary, OfRandomAssembliesEndsTheBallAboutEachPoint) {
  test::Scatter random(12);
  std::size_t bodies = 0, cut = 0;
  for (int i = 0; i < 120; ++i) {
    SCOPED_TRACE(i);
    const IndexedMesh mesh = assembly(random);
    const Surface whole(mesh);
    if (!whole.is_solid()) continue;
    ++bodies;
    cut += whole.is_boundary() ? 0U : 1U;
    const Surface& boundary = whole.boundary();
    ASSERT_TRUE(boundary.is_solid());
    const auto is_in = [&](const Vec3& point) { return std::abs(winding_number(mesh, point)) > 0.5; };
    for (int k = 0; k < 12; ++k) {
      const Vec3 at = random.point(14);
      const ClosestPoint foot = *boundary.closest_point(at);
      EXPECT_EQ(foot.is_inside, is_in(at)) << at.transpose();
      for (int n = 0; n < 12; ++n) {
        const Vec3 beside = at + random.in(0.5, 0.9999) * foot.distance_mm * random.direction();
        EXPECT_EQ(is_in(beside), foot.is_inside) << at.transpose() << " / " << beside.transpose();
      }
      bool is_end = false;
      for (int n = 0; n < 2000 && !is_end; ++n)
        is_end = is_in(foot.point + 1e-5 * random.direction()) != foot.is_inside;
      EXPECT_TRUE(is_end) << at.transpose();
    }
  }
  EXPECT_GT(bodies, 60U);
  EXPECT_GT(cut, 50U);
}

/// A box from -100 to 10 in x, -10 to 10 in y and 0 to 10 in z. A narrow strip of triangles divides its top along x, from -6
/// to 6. `heights` of its other side over the line y = 0 stand at `places`.
IndexedMesh box_with_strip(const std::vector<double>& places, const std::vector<double>& heights) {
  IndexedMesh mesh = shapes::box(Vec3(-100, -10, 0), Vec3(10, 10, 10));
  const auto corner = [&](double x, double y) {
    for (Corner v = 0; v < mesh.vertices.size(); ++v)
      if (mesh.vertices[v] == Vec3(x, y, 10)) return v;
    mesh.vertices.emplace_back(x, y, 10);
    return static_cast<Corner>(mesh.vertices.size() - 1);
  };
  std::erase_if(mesh.triangles, [&](const TriangleCorners& t) {
    return std::ranges::all_of(t, [&](Corner c) { return mesh.vertices[c].z() > 9; });
  });
  const Corner a = corner(-6, 0), b = corner(6, 0), left_low = corner(-100, -10), left_high = corner(-100, 10),
               right_low = corner(10, -10), right_high = corner(10, 10);
  std::vector<Corner> side;
  for (std::size_t i = 0; i < places.size(); ++i) side.push_back(corner(places[i], heights[i]));
  std::vector<TriangleCorners>& top = mesh.triangles;
  top.push_back({left_low, right_low, b});
  top.push_back({left_low, b, a});
  top.push_back({left_low, a, side.front()});
  top.push_back({left_low, side.front(), left_high});
  for (std::size_t i = 0; i + 1 < side.size(); ++i) top.push_back({side[i], side[i + 1], left_high});
  top.push_back({side.back(), right_high, left_high});
  top.push_back({right_low, right_high, side.back()});
  top.push_back({right_low, side.back(), b});
  top.push_back({a, b, side.back()});
  for (std::size_t i = side.size(); i-- > 1;) top.push_back({a, side[i], side[i - 1]});
  std::erase_if(top, [](const TriangleCorners& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  mesh.file_triangle.resize(top.size());
  for (std::uint32_t t = 0; t < top.size(); ++t) mesh.file_triangle[t] = t + 1;
  return mesh;
}

// Triangles narrower than the rounding of their plane cross another body, and join nothing on both of its sides.
TEST(SolidBoundary, OfBodiesThatCrossInNarrowTrianglesIsTheirUnion) {
  test::Scatter random(20261201);
  std::map<double, int> known;
  for (const double width : {1e-2, 1e-4, 2e-5, 1e-5, 4e-6, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 0.0}) {
    for (int i = 0; i < 24; ++i) {
      const double end = random.in(-5, 5);
      std::vector<double> places{-6}, heights{i % 3 == 0 ? 0 : width};
      for (int k = 0; k < i % 4; ++k) {
        places.push_back(i % 8 < 4 && k == 1 ? end : random.in(places.back(), 6));
        if (places.back() <= places[places.size() - 2]) places.back() = 0.5 * (places[places.size() - 2] + 6);
        heights.push_back(width * random.in(0, 1));
      }
      places.push_back(6);
      heights.push_back(i % 3 == 0 ? 0 : width);
      const IndexedMesh mesh =
          shapes::joined(box_with_strip(places, heights), shapes::box(Vec3(-200, -30, -5), Vec3(end, 30, 20)));
      SCOPED_TRACE(std::to_string(width) + " " + std::to_string(i));
      const Surface whole(mesh);
      if (!whole.is_solid()) continue;
      const Surface& boundary = whole.boundary();
      if (!boundary.is_solid()) continue;  // not known: no check relies on it
      const auto is_in = [&](const Vec3& p) {
        return (p.x() < end && p.x() > -200 && std::abs(p.y()) < 30 && p.z() > -5 && p.z() < 20) ||
               (p.x() < 10 && p.x() > -100 && std::abs(p.y()) < 10 && p.z() > 0 && p.z() < 10);
      };
      for (int k = 0; k < 40; ++k) {
        const Vec3 at = Vec3(0, 0, 5) + random.point(k % 2 == 0 ? 12 : 7);
        const ClosestPoint foot = *boundary.closest_point(at);
        ASSERT_EQ(foot.is_inside, is_in(at)) << at.transpose();
        for (int n = 0; n < 40; ++n) {
          const Vec3 beside = at + random.in(0.5, 1) * (foot.distance_mm - 1e-4) * random.direction();
          ASSERT_TRUE(foot.distance_mm < 2e-4 || is_in(beside) == foot.is_inside) << at.transpose();
        }
        bool is_end = false;
        for (int n = 0; n < 3000 && !is_end; ++n)
          is_end = is_in(foot.point + 1e-3 * random.direction()) != foot.is_inside;
        ASSERT_TRUE(is_end) << at.transpose() << " foot " << foot.point.transpose();
      }
      ++known[width];
    }
  }
  for (const auto& [width, count] : known) EXPECT_GT(count, 20) << "not known too often at a width of " << width;
}

TEST(SolidBoundary, OfASurfaceThatEnclosesNothingIsNoSolid) {
  const IndexedMesh sheet = shapes::closed_sheet(20);
  const Surface whole(sheet);
  ASSERT_TRUE(whole.is_solid());
  EXPECT_FALSE(whole.boundary().is_solid());
  EXPECT_EQ(whole.boundary().mesh().triangles, sheet.triangles);
  EXPECT_NEAR(whole.boundary().closest_point(Vec3(0, 0, -3))->signed_mm(), 3, 1e-12);
  const IndexedMesh both = shapes::joined(shapes::box(Vec3(-5, -5, -9), Vec3(5, 5, -1)), sheet);
  const Surface beside(both);
  EXPECT_TRUE(beside.boundary().is_solid());
  EXPECT_EQ(beside.boundary().mesh().triangles.size(), 12U);
}

// Rays from here meet edges and corners of the box in each of their directions, or run along faces.
TEST(Surface, WindsAroundAPointWhateverEdgesARayMeets) {
  const IndexedMesh mesh = shapes::box(Vec3::Constant(-1), Vec3::Constant(1));
  const Surface surface(mesh, 1);
  const auto along = [](double x, double y, double z) { return Vec3(x, y, z).normalized(); };
  for (const Vec3& direction : {along(0.1719, 0.2831, 0.9435), along(0.9187, -0.3541, 0.1747)}) {
    for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, 1, 0.25), Vec3(0, 1, -1), Vec3(1, 1, -1)}) {
      for (const double back : {0.0, 0.5, 1.0, 4.0}) {
        const Vec3 point = 0.999 * corner - back * direction;
        EXPECT_EQ(surface.winds_around(point), point.cwiseAbs().maxCoeff() < 1) << point.transpose();
      }
    }
  }
}

}  // namespace
}  // namespace gouge::solid_boundary_test
