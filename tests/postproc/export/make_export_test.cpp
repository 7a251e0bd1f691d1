#include "postproc/export/make_export.h"

#include <CGAL/IO/PLY.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "postproc/export/write_scene.h"
#include "postproc/viewer/surface_values.h"
#include "tests/postproc/image/small_scene.h"

namespace gouge::make_export_test {
namespace {

const ExportMesh* mesh_called(const ExportScene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.meshes, name, &ExportMesh::name);
  return found == scene.meshes.end() ? nullptr : &*found;
}

TEST(MakeExport, ThePartHasDepthOvercutAndColoursAsTheFieldSays) {
  const SmallScene small;
  const ExportScene scene = make_export(small.model, small.input);
  const ExportMesh* part = mesh_called(scene, "block.stl");
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->kind, ExportKind::part);
  ASSERT_EQ(part->depth_mm.size(), part->positions.size());
  ASSERT_EQ(part->overcut_mm.size(), part->positions.size());
  ASSERT_EQ(part->colours.size(), part->positions.size());
  const PicturedPath path(small.input);
  const SurfaceValues field(path);
  std::size_t compared = 0;
  for (std::size_t v = 0; v < part->positions.size(); ++v) {
    EXPECT_NEAR(part->normals[v].norm(), 1, 1e-5);
    const Vec3& p = part->positions[v];
    if (p.z() < 10 - 1e-9 || p.x() < 5 || p.x() > 35 || std::abs(p.y() - 15) > 0.9) continue;
    const std::vector<SurfacePoint> at = {{p, Vec3::UnitZ(), 0}};
    EXPECT_NEAR(part->depth_mm[v], field.at(at, SurfaceQuantity::depth).front(), 0.02);
    EXPECT_NEAR(part->overcut_mm[v], field.at(at, SurfaceQuantity::overcut).front(), 0.02);
    compared += part->depth_mm[v] > 0.1F ? 1U : 0U;
  }
  EXPECT_GT(compared, 100U);
  // A groove 0.4 mm deep.
  EXPECT_NEAR(*std::ranges::max_element(part->depth_mm), 0.4, 0.02);
  EXPECT_NEAR(*std::ranges::max_element(part->overcut_mm), 0.4, 0.02);
}

TEST(MakeExport, ThePathIsLinesByStateWithTheirMoves) {
  const SmallScene small;
  const ExportScene scene = make_export(small.model, small.input);
  std::vector<std::size_t> moves;
  for (const ExportLine& line : scene.lines) {
    ASSERT_EQ(line.points.size(), line.moves.size() + 1);
    for (const std::size_t move : line.moves) EXPECT_EQ(small.result.verdicts[move].state, line.state);
    for (std::size_t k = 0; k < line.moves.size(); ++k)
      EXPECT_EQ(line.points[k + 1], small.path.moves[line.moves[k]].end.tip);
    moves.insert(moves.end(), line.moves.begin(), line.moves.end());
  }
  EXPECT_EQ(moves, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST(MakeExport, TheToolStandsWhereItIsAtItsWorst) {
  const SmallScene small;
  const ExportScene scene = make_export(small.model, small.input);
  const ExportMesh* cutter = mesh_called(scene, "T4 cutter");
  const ExportMesh* holder = mesh_called(scene, "T4 holder");
  ASSERT_TRUE(cutter != nullptr && holder != nullptr && mesh_called(scene, "T4 shank") != nullptr);
  EXPECT_EQ(holder->kind, ExportKind::tool);
  Box3 ball, all;
  for (const Vec3& p : cutter->positions) ball.extend(p);
  for (const Vec3& p : holder->positions) all.extend(p);
  EXPECT_NEAR(ball.min().z(), 9.6, 1e-6);
  EXPECT_NEAR(ball.sizes().x(), 6, 1e-6);
  EXPECT_NEAR(all.sizes().y(), 20, 0.02);
  EXPECT_NEAR(all.max().z(), 9.6 + 45, 1e-6);
  for (const Eigen::Vector3f& n : cutter->normals) EXPECT_NEAR(n.norm(), 1, 1e-5);
}

TEST(MakeExport, ACleanPathHasNoToolAndNoDepth) {
  SmallScene small;
  for (Move& move : small.path.moves) move.end.tip.z() += 1;
  small.check();
  const ExportScene scene = make_export(small.model, small.input);
  ASSERT_EQ(scene.meshes.size(), 1U);
  EXPECT_EQ(scene.meshes[0].triangles.size(), 12U);
  EXPECT_EQ(*std::ranges::max_element(scene.meshes[0].depth_mm), 0);
  EXPECT_EQ(scene.lines.size(), 1U);
}

TEST(WriteScene, CgalReadsThePly) {
  const SmallScene small;
  const ExportScene scene = make_export(small.model, small.input);
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::istringstream bytes(*write_ply(scene));
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(bytes, mesh, comments));
  const ExportMesh& part = scene.meshes.front();
  ASSERT_EQ(mesh.number_of_vertices(), part.positions.size());
  EXPECT_EQ(mesh.number_of_faces(), part.triangles.size());
  const auto depth = mesh.property_map<CGAL::SM_Vertex_index, float>("v:depth");
  const auto overcut = mesh.property_map<CGAL::SM_Vertex_index, float>("v:overcut");
  ASSERT_TRUE(depth.second && overcut.second);
  for (const auto v : mesh.vertices()) {
    EXPECT_EQ(Vec3(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()), part.positions[v.idx()]);
    EXPECT_EQ(depth.first[v], part.depth_mm[v.idx()]);
    EXPECT_EQ(overcut.first[v], part.overcut_mm[v.idx()]);
  }
}

TEST(WriteScene, LengthsAreInTheUnitOfThePath) {
  const SmallScene small;
  ExportScene scene = make_export(small.model, small.input);
  scene.unit = LengthUnit::inch;
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  std::istringstream bytes(*write_ply(scene));
  std::string comments;
  ASSERT_TRUE(CGAL::IO::read_PLY(bytes, mesh, comments));
  double high = 0;
  for (const auto v : mesh.vertices()) high = std::max(high, mesh.point(v).x());
  EXPECT_NEAR(high, 40 / 25.4, 1e-12);
  EXPECT_NE(comments.find("overcut in in"), std::string::npos) << comments;
}

TEST(SceneFormat, IsSaidByTheEnding) {
  EXPECT_EQ(scene_format_of("a.glb"), &write_glb);
  EXPECT_EQ(scene_format_of("x/A.VTP"), &write_vtp);
  EXPECT_EQ(scene_format_of("a.ply"), &write_ply);
  for (const char* file : {"a.gltf", "glb", ".glb", "a.glb.txt", ""}) EXPECT_EQ(scene_format_of(file), nullptr) << file;
}

}  // namespace
}  // namespace gouge::make_export_test
