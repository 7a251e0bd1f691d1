// Meshes broken at random around a solid that is known: a tool in the solid is never clean unless its own free motion
// leads out, a tool outside is never buried.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/laws/random_scenes.h"
#include "tests/support/crossing_parity.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"
#include "tests/support/tools.h"
#include "tests/support/whole_check.h"

namespace gouge::broken_meshes_test {
namespace {

using laws::SceneScatter;

IndexedMesh random_solid(SceneScatter& random) {
  IndexedMesh mesh;
  switch (random.below(5)) {
    case 0:
      mesh = shapes::sphere(40, 8, 16);
      break;
    case 1:
      mesh = shapes::torus(30, 12);
      break;
    case 2:
      mesh = shapes::star_prism(5, 50, 25, 40);
      break;
    case 3:
      mesh = shapes::sphere(40, 20, 40);
      break;
    default:
      mesh = shapes::box(Vec3::Constant(-35), Vec3::Constant(35));
  }
  const Vec3 scale(random.in(0.7, 1.3), random.in(0.7, 1.3), random.in(0.7, 1.3));
  for (Vec3& v : mesh.vertices) v = v.cwiseProduct(scale);
  return mesh;
}

void turn_some(SceneScatter& random, IndexedMesh& mesh) {
  const double share = random.in(0, 1);
  for (TriangleCorners& t : mesh.triangles) {
    if (random.in(0, 1) < share) std::swap(t[1], t[2]);
  }
}

void double_some(SceneScatter& random, IndexedMesh& mesh) {
  const double share = random.below(2) == 0 ? 1 : random.in(0, 1);
  const bool is_opposite = random.below(3) > 0;
  const std::size_t count = mesh.triangles.size();
  for (std::size_t t = 0; t < count; ++t) {
    if (random.in(0, 1) > share) continue;
    const TriangleCorners c = mesh.triangles[t];
    shapes::add_triangle(mesh, c[0], c[is_opposite ? 2 : 1], c[is_opposite ? 1 : 2]);
  }
}

void leave_some_out(SceneScatter& random, IndexedMesh& mesh) {
  const double share = std::pow(random.in(0, 0.5), 2);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    if (random.in(0, 1) >= share) continue;
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    mesh.file_triangle.pop_back();
  }
}

/// Adds a crack: a vertex that its triangles do not share.
void crack_some(SceneScatter& random, IndexedMesh& mesh) {
  for (std::size_t n = random.below(6) + 1; n-- > 0;) {
    Corner& c = mesh.triangles[random.below(mesh.triangles.size())][random.below(3)];
    const Vec3 shaken = mesh.vertices[c] + random.point(1e-6);
    mesh.vertices.push_back(shaken);
    c = static_cast<Corner>(mesh.vertices.size() - 1);
  }
}

std::vector<IndexedMesh> split(SceneScatter& random, const IndexedMesh& mesh) {
  std::vector<IndexedMesh> files(1 + random.below(4));
  for (IndexedMesh& file : files) file.vertices = mesh.vertices, file.name = "file";
  for (const TriangleCorners& t : mesh.triangles)
    shapes::add_triangle(files[random.below(files.size())], t[0], t[1], t[2]);
  return files;
}

/// The same corners, with the other diagonal of every pair of triangles 2 k, 2 k + 1 that share an edge: another
/// triangulation with the same rim.
IndexedMesh with_other_diagonals(IndexedMesh mesh) {
  for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 2) {
    TriangleCorners &a = mesh.triangles[t], &b = mesh.triangles[t + 1];
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner p = a[k], q = a[(k + 1) % 3], third = a[(k + 2) % 3];
      const auto in_b = [&](Corner c) { return std::find(b.begin(), b.end(), c) != b.end(); };
      if (!in_b(p) || !in_b(q) || in_b(third)) continue;
      const Corner fourth = *std::find_if(b.begin(), b.end(), [&](Corner c) { return c != p && c != q; });
      a = {p, fourth, third};
      b = {fourth, q, third};
      break;
    }
  }
  return mesh;
}

/// Each triangle cut into three at a place in its middle, which lies off its plane by no more than `lift_mm`.
IndexedMesh with_middles(SceneScatter& random, const IndexedMesh& mesh, double lift_mm) {
  IndexedMesh fine;
  fine.vertices = mesh.vertices;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleCorners c = mesh.triangles[t];
    fine.vertices.push_back((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3 + random.point(lift_mm));
    for (std::size_t k = 0; k < 3; ++k) shapes::add_triangle(fine, c[k], c[(k + 1) % 3], fine.vertices.size() - 1);
  }
  return fine;
}

/// A hole: triangles whose middle is near a direction, or a random run of them.
void cut_a_hole(SceneScatter& random, IndexedMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  const std::size_t size = 1 + random.below(1 + count / (random.below(2) == 0 ? 12 : 3)), first = random.below(count);
  IndexedMesh holed;
  holed.vertices = mesh.vertices;
  for (std::size_t t = 0; t < count; ++t) {
    const TriangleCorners& c = mesh.triangles[t];
    if ((t + count - first) % count >= size) shapes::add_triangle(holed, c[0], c[1], c[2]);
  }
  mesh = holed;
}

/// Copies of a surface, each perhaps triangulated in another way, turned, moved by less than what a file keeps, or
/// partial.
std::vector<IndexedMesh> copies_of(SceneScatter& random, const IndexedMesh& mesh) {
  std::vector<IndexedMesh> copies = {mesh};
  for (std::size_t n = 1 + random.below(3); n-- > 0;) {
    IndexedMesh copy = mesh;
    switch (random.below(6)) {
      case 0:
        copy = with_other_diagonals(mesh);
        break;
      case 1:
        copy = with_middles(random, mesh, random.below(2) == 0 ? 0 : 1e-4);
        break;
      case 2:
        leave_some_out(random, copy);
        break;
      default:
        break;
    }
    if (random.below(8) == 0) copy = shapes::moved(copy, random.point(1e-9));
    copies.push_back(random.below(2) == 0 ? copy : shapes::inside_out(copy));
  }
  return copies;
}

Box3 box_of(const std::vector<IndexedMesh>& files) {
  Box3 box;
  for (const IndexedMesh& file : files) {
    for (std::size_t t = 0; t < file.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) box.extend(file.corner(t, k));
    }
  }
  return box;
}

struct Broken {
  std::vector<IndexedMesh> intended;  // inside of one is inside
  std::vector<IndexedMesh> files;
  Box3 left_of_first;  // what is left of the first: nothing encloses a place beyond it

  [[nodiscard]] Box3 box_left(std::size_t k) const {
    return k == 0 && !left_of_first.isEmpty() ? left_of_first : box_of({intended[k]});
  }
};

Broken break_at_random(SceneScatter& random) {
  Broken broken;
  broken.intended = {random_solid(random)};
  IndexedMesh mesh = broken.intended[0];
  if (random.below(4) == 0) {
    const IndexedMesh other = shapes::moved(random_solid(random), random.point(40));
    broken.intended.push_back(other);
    mesh = shapes::joined(mesh, random.below(2) == 0 ? other : shapes::inside_out(other));
  }
  if (random.below(6) == 0) mesh = shapes::inside_out(mesh);
  if (random.below(3) == 0) turn_some(random, mesh);
  if (random.below(3) == 0) double_some(random, mesh);
  if (random.below(3) == 0) leave_some_out(random, mesh);
  if (random.below(3) == 0 && !mesh.triangles.empty()) crack_some(random, mesh);
  broken.files = split(random, mesh);
  return broken;
}

/// A solid with a hole whose surface stands there several times, in one file or in several, perhaps beside a closed
/// one.
Broken repeat_at_random(SceneScatter& random) {
  Broken broken;
  broken.intended = {random_solid(random)};
  IndexedMesh mesh = broken.intended[0];
  if (random.below(6) == 0) turn_some(random, mesh);
  cut_a_hole(random, mesh);
  if (random.below(6) == 0 && !mesh.triangles.empty()) crack_some(random, mesh);
  broken.files = copies_of(random, mesh);
  broken.left_of_first = box_of(broken.files);
  if (random.below(3) == 0) {  // an insert or a second body, perhaps inside out
    const IndexedMesh other = shapes::moved(random_solid(random), random.point(40));
    broken.intended.push_back(other);
    broken.files.push_back(random.below(2) == 0 ? other : shapes::inside_out(other));
  }
  if (random.below(2) == 0) {
    IndexedMesh all;
    for (const IndexedMesh& file : broken.files) all = shapes::joined(all, file);
    broken.files = {all};
  }
  for (IndexedMesh& file : broken.files) file.name = "file";
  return broken;
}

/// A solid beside closed sheets that enclose nothing, or next to nothing, in one file or in several.
Broken add_sheets_at_random(SceneScatter& random) {
  constexpr double kThickness_mm[] = {0, 1e-7, 1e-4};
  Broken broken;
  broken.intended = {random_solid(random)};
  broken.files = broken.intended;
  for (std::size_t n = 1 + random.below(3); n-- > 0;) {
    IndexedMesh sheet = shapes::closed_sheet(random.in(5, 40));
    sheet.vertices[0].z() += kThickness_mm[random.below(3)];
    sheet = shapes::moved(sheet, random.point(30));
    if (random.below(2) == 0)
      broken.files.push_back(sheet);
    else
      broken.files.back() = shapes::joined(broken.files.back(), sheet);
  }
  for (IndexedMesh& file : broken.files) file.name = "file";
  return broken;
}

/// Closed bodies, one of them inside another and a file of its own, inside out or not.
Broken turn_files_at_random(SceneScatter& random) {
  Broken broken;
  broken.intended = {shapes::box(Vec3::Constant(-45), Vec3::Constant(45))};
  for (std::size_t n = 1 + random.below(2); n-- > 0;) {
    IndexedMesh insert = random_solid(random);
    for (Vec3& v : insert.vertices) v *= random.below(2) == 0 ? 0.6 : 0.9;
    broken.intended.push_back(shapes::moved(insert, random.point(15)));
  }
  for (const IndexedMesh& body : broken.intended) {
    broken.files.push_back(random.below(2) == 0 ? body : shapes::inside_out(body));
    broken.files.back().name = "file";
  }
  return broken;
}

struct Tally {
  int clean = 0, buried = 0, undecided = 0, gouge = 0, led_out = 0;
};

bool is_in_any(const std::vector<IndexedMesh>& solids, const Vec3& point) {
  return std::any_of(solids.begin(), solids.end(), [&](const IndexedMesh& s) { return test::is_inside(s, point); });
}

using Damage = Broken (*)(SceneScatter&);

void check_once(std::uint64_t stream, Damage damage, Tally& tally) {
  SceneScatter random(stream);
  const Broken broken = damage(random);
  const double diameter = random.in(0.5, 5), length = diameter * random.in(1.5, 4);
  const ToolVariants tool = make_tool_variants({1, "ball", BallCutter{diameter, length}, {}, {}}, 0, 0, 0).value();
  std::vector<Pose> poses = {{random.point(45), random.axis(3)}};
  for (std::size_t n = random.below(4); n-- > 0;)
    poses.push_back({poses.back().tip + random.point(8), poses.back().axis});
  const Toolpath path = paths::through(poses);
  Scene scene;
  (random.below(4) == 0 ? scene.fixtures : scene.parts) = broken.files;
  CheckOptions options;
  options.threads = 1;
  if (random.below(8) == 0) options.tolerance_mm = random.in(0.1, 3);
  const CheckResult r = whole_check(path, &tool, scene, options);
  // The tool's own path leads out of the solid.
  const auto leaves = [&](const Box3& box) {
    return box.isEmpty() || std::any_of(poses.begin(), poses.end(), [&](const Pose& pose) {
             return !box.contains(pose.tip) || !box.contains(pose.tip + length * pose.axis);
           });
  };
  const Box3 all = box_of(broken.files);
  for (std::size_t i = 0; i < r.verdicts.size(); ++i) {
    const MoveVerdict& v = r.verdicts[i];
    const Pose& pose = poses[i];
    const Vec3 place = pose.tip + tool.bare.core.y() * pose.axis;
    const bool is_in = is_in_any(broken.intended, place);
    bool leads_out = true;
    for (std::size_t k = 0; k < broken.intended.size(); ++k)
      leads_out = leads_out && (!test::is_inside(broken.intended[k], place) || leaves(broken.box_left(k)));
    leads_out = leads_out || leaves(all);
    if (v.state == MoveState::gouge) ++tally.gouge;
    if (v.state == MoveState::not_certified) ++tally.undecided;
    if (v.state == MoveState::buried) {
      ++tally.buried;
      EXPECT_TRUE(is_in) << "stream " << stream << ", move " << i << ": told buried, but outside";
    }
    if (v.state != MoveState::clean) continue;
    ++tally.clean;
    if (is_in && leads_out) ++tally.led_out;
    // A tolerance of the cutter's size lets it stand partly inside.
    if (!leads_out && options.tolerance_mm < 0.1) {
      EXPECT_FALSE(is_in) << "stream " << stream << ", move " << i << ": told clean, but inside the solid";
    }
  }
}

Tally check_many(Damage damage) {
  const char* given = std::getenv("GOUGE_BROKEN_MESHES");
  const std::uint64_t count = given == nullptr ? 600 : std::strtoull(given, nullptr, 10);
  Tally tally;
  for (std::uint64_t stream = 0; stream < count; ++stream) check_once(stream, damage, tally);
  std::cout << count << " meshes: " << tally.clean << " clean (" << tally.led_out << " of them led out of the solid), "
            << tally.buried << " buried, " << tally.undecided << " not certified, " << tally.gouge << " gouges\n";
  EXPECT_GT(tally.clean + tally.buried, static_cast<int>(count / 10));
  EXPECT_GT(tally.buried, static_cast<int>(count / 20));
  return tally;
}

TEST(BrokenMeshes, NeverMakeABuriedToolCleanNorAFreeOneBuried) { EXPECT_GT(check_many(break_at_random).clean, 60); }

// Duplicate triangles prove nothing: every edge of an open surface has an even number of triangles then.
TEST(BrokenMeshes, AnOpenSurfaceThatStandsThereSeveralTimesProvesNoOutside) { check_many(repeat_at_random); }

TEST(BrokenMeshes, SheetsThatEncloseNothingHideNoSolid) { check_many(add_sheets_at_random); }

TEST(BrokenMeshes, AFileThatIsInsideOutIsNoCavityOfAnother) { check_many(turn_files_at_random); }

}  // namespace
}  // namespace gouge::broken_meshes_test
