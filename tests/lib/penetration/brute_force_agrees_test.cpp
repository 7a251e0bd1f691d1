#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>

#include "lib/mesh/load_mesh.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/penetration/find_penetration.h"
#include "tests/bench/penetration/cell_search.h"
#include "tests/bench/penetration/direction_families.h"
#include "tests/bench/penetration/normal_methods.h"
#include "tests/lib/penetration/brute_foot.h"
#include "tests/lib/penetration/random_points.h"
#include "tests/support/solids.h"
#include "tests/support/source_folder.h"

// Depth and direction against all triangles and the winding number, for every k, tree width and normal
// method. GOUGE_PENETRATION_POINTS sets how many points there are in all (short by default). Every point is
// tested in 9 of the 81 settings, every setting sees its share; with GOUGE_PENETRATION_ALL=1 in all of them.

namespace gouge::brute_force_agrees_test {
namespace {

const std::string kParts = source_folder() + "/../shared/data/parts/";
constexpr std::size_t kBatch = 200;
// The cells do not depend on directions and normals, only the searches they leave over on the width: one
// setting of each width.
constexpr std::size_t kCellsEvery = 31;

std::size_t points_in_all() {
  const char* given = std::getenv("GOUGE_PENETRATION_POINTS");
  return given == nullptr ? 12000 : std::strtoull(given, nullptr, 10);
}

std::size_t settings_apart() {
  const char* given = std::getenv("GOUGE_PENETRATION_ALL");
  return given != nullptr && *given == '1' ? 1 : 9;
}

struct Setting {
  DirectionSet directions;
  std::size_t width;
  decltype(&offset_by_planes) normals;
};

std::vector<Setting> all_settings() {
  std::vector<DirectionSet> sets;
  for (const std::size_t k : {6U, 14U, 18U, 26U}) sets.push_back(cube_directions(k));
  for (const std::size_t k : {8U, 12U, 20U}) sets.push_back(*make_directions(DirectionFamily::platonic, k));
  for (const std::size_t k : {10U, 32U}) sets.push_back(*make_directions(DirectionFamily::coulomb, k));
  std::vector<Setting> all;
  for (const DirectionSet& set : sets) {
    for (const std::size_t width : {2U, 4U, 8U}) {
      for (const auto normals : {&offset_averaged, &offset_by_paraboloid, &offset_by_planes})
        all.push_back({set, width, normals});
    }
  }
  return all;
}

struct Truth {
  Vec3 place, foot;
  double distance_mm;
  bool is_inside;
};

struct Tally {
  std::size_t points = 0, inside = 0, deeper = 0, wrong = 0;
};

/// Compares one batch of points in one setting, found by the trees or by the cells.
void compare(const DepthBody& body, const Setting& setting, const PenetrationResult& result, const char* how,
             const std::vector<Truth>& truths, Tally& tally) {
  std::vector<const PointContact*> reported(truths.size(), nullptr);
  for (const PointContact& c : result.contacts) reported[c.point] = &c;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    const Truth& truth = truths[i];
    ++tally.points;
    if (truth.distance_mm < 1e-9) continue;  // on the surface: either side is right
    bool is_right = (reported[i] != nullptr) == truth.is_inside;
    if (is_right && reported[i] != nullptr) {
      ++tally.inside;
      const Contact& c = reported[i]->contact;
      is_right = std::abs(c.depth_mm - truth.distance_mm) <= 1e-9 * (1 + truth.distance_mm);
      // Where two feet are equally near, either direction is right.
      const double reached = (truth.place + c.depth_mm * c.normal - truth.foot).norm();
      is_right =
          is_right && (reached < 1e-6 ||
                       brute_force_closest_point(body.mesh(), truth.place + c.depth_mm * c.normal).distance_mm < 1e-9);
      const bool is_deeper = truth.distance_mm > body.options.depth_mm;
      is_right = is_right &&
                 (reported[i]->is_deeper == is_deeper || std::abs(truth.distance_mm - body.options.depth_mm) < 1e-9);
      tally.deeper += is_deeper ? 1 : 0;
    }
    tally.wrong += is_right ? 0 : 1;
    if (!is_right && tally.wrong < 5) {
      ADD_FAILURE() << body.mesh().name << " k " << setting.directions.k() << " width " << setting.width << how
                    << ": point " << truth.place.transpose() << " true " << (truth.is_inside ? "inside " : "outside ")
                    << truth.distance_mm << ", told " << (reported[i] ? reported[i]->contact.depth_mm : -1.0);
    }
  }
}

Tally run(const IndexedMesh& mesh, double depth_mm, std::size_t count, std::uint64_t seed) {
  RandomPoints random(mesh, depth_mm, seed);
  const std::vector<Setting> settings = all_settings();
  std::vector<std::unique_ptr<DepthBody>> bodies(settings.size());
  std::vector<std::unique_ptr<CellBody>> cells(settings.size());
  const double reach = mesh.box().diagonal().norm();
  const std::size_t apart = settings_apart();
  Tally tally;
  for (std::size_t batch = 0; batch * kBatch < count; ++batch) {
    const RigidTransform pose = random.pose(reach);
    std::vector<Vec3> in_frame;
    std::vector<Truth> truths;
    for (std::size_t i = 0; i < kBatch; ++i) {
      in_frame.push_back(pose.inverse().point(random.next()));
      const Vec3 place = pose.point(in_frame.back());
      const BruteClosestPoint foot = brute_force_closest_point(mesh, place);
      truths.push_back({place, foot.point, foot.distance_mm, std::abs(winding_number(mesh, place)) > 0.5});
    }
    for (std::size_t k = batch % apart; k < settings.size(); k += apart) {
      if (!bodies[k]) {
        DepthBodyOptions options;
        options.directions = settings[k].directions;
        options.depth_mm = depth_mm;
        options.width = settings[k].width;
        options.offset_vertices = settings[k].normals;
        bodies[k] = std::make_unique<DepthBody>(build_depth_body(Surface(IndexedMesh(mesh)), options));
        if (k % kCellsEvery == 0) cells[k] = std::make_unique<CellBody>(*bodies[k]);
      }
      PointBodyOptions options;
      options.directions = settings[k].directions;
      options.width = settings[k].width;
      const PointBody points = build_point_body(in_frame, options);
      compare(*bodies[k], settings[k], PenetrationFinder(*bodies[k], points).find(pose), " by trees", truths, tally);
      if (cells[k])
        compare(*bodies[k], settings[k], CellSearch(*cells[k], points).find(pose), " by cells", truths, tally);
    }
  }
  return tally;
}

void expect_agreement(const IndexedMesh& mesh, double depth_mm, double share) {
  const auto count = static_cast<std::size_t>(share * static_cast<double>(points_in_all()));
  const Tally tally = run(mesh, depth_mm, std::max<std::size_t>(count, 9 * kBatch), 7);
  EXPECT_EQ(tally.wrong, 0U) << mesh.name;
  EXPECT_GT(tally.inside, tally.points / 10) << mesh.name << ": too few points inside to mean anything";
  std::cout << mesh.name << ": " << tally.points << " comparisons, " << tally.inside << " inside, " << tally.deeper
            << " deeper than " << depth_mm << " mm\n";
}

TEST(BruteForce, AgreesOnTheStarPrism) { expect_agreement(shapes::star_prism(), 1.5, 0.3); }
TEST(BruteForce, AgreesOnTheSlottedBlockWhoseWallsAreThinnerThanTheDepth) {
  expect_agreement(shapes::slotted_block(), 1.5, 0.3);
}
TEST(BruteForce, AgreesOnTheHollowCube) { expect_agreement(shapes::hollow_cube(20), 2, 0.2); }
TEST(BruteForce, AgreesOnTheTorus) { expect_agreement(shapes::torus(), 1, 0.1); }
TEST(BruteForce, AgreesOnTheNeedleFan) { expect_agreement(shapes::needle_fan(120), 0.5, 0.05); }
TEST(BruteForce, AgreesOnTheBumpySphere) { expect_agreement(shapes::bumpy_sphere(), 1, 0.03); }

TEST(BruteForce, AgreesOnRealParts) {
  if (!std::filesystem::exists(kParts)) GTEST_SKIP() << "real parts absent: " << kParts;
  for (const char* file :
       {"matched/Teste-Metrologia.STL", "format_quirks/ascii_Moon_Chinese.stl", "mechanical/plate_holes.STL"}) {
    const auto loaded = load_mesh(kParts + file);
    ASSERT_TRUE(loaded.has_value()) << file;
    if (!loaded->findings.is_solid()) {
      std::cout << file << " is no closed solid: passed over\n";
      continue;
    }
    expect_agreement(loaded->mesh, loaded->mesh.box().diagonal().norm() / 100, 0.01);
  }
}

}  // namespace
}  // namespace gouge::brute_force_agrees_test
