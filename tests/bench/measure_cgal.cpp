#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Rigid_triangle_mesh_collision_detection.h>
#include <CGAL/Surface_mesh.h>

#include <memory>

#include "tests/bench/peer_support.h"

// CGAL: its collision detection of rigid meshes, exact predicates, the tool tessellated to 0.01 mm. Single
// poses, yes or no.

namespace gouge::bench {
namespace {

constexpr double kChord_mm = 0.01;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh make_mesh(const IndexedMesh& mesh) {
  Mesh out;
  std::vector<Mesh::Vertex_index> vertices;
  for (const Vec3& v : mesh.vertices) vertices.push_back(out.add_vertex(Kernel::Point_3(v.x(), v.y(), v.z())));
  for (const TriangleCorners& t : mesh.triangles) out.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  return out;
}

class CgalScene {
 public:
  CgalScene(const IndexedMesh& part, const BenchTool& tool)
      : part_(make_mesh(part)), tool_(make_mesh(tessellate_tool(tool, kChord_mm))) {
    detection_.add_mesh(part_);
    tool_id_ = detection_.add_mesh(tool_);
  }

  bool is_hit(const Pose& pose) {
    const Eigen::Matrix3d m = rotation_of(pose.axis);
    const Vec3& t = pose.tip;
    detection_.set_transformation(
        tool_id_, CGAL::Aff_transformation_3<Kernel>(m(0, 0), m(0, 1), m(0, 2), t.x(), m(1, 0), m(1, 1), m(1, 2), t.y(),
                                                     m(2, 0), m(2, 1), m(2, 2), t.z()));
    return !detection_.get_all_intersections(tool_id_).empty();
  }

 private:
  Mesh part_, tool_;
  CGAL::Rigid_triangle_mesh_collision_detection<Mesh> detection_;
  std::size_t tool_id_ = 0;
};

std::function<void(benchmark::State&)> prepare_poses(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = std::make_shared<CgalScene>(c->work.scene.parts[0], c->work.tool);
  const auto sample = sample_poses(*c, scaled(c->triangles <= 20000 ? 400 : 160));
  return [=](benchmark::State& state) {
    time_poses(
        state, *c, sample, [&](const Pose& pose) { return scene->is_hit(pose) ? 1.0 : 0.0; }, true);
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  register_measurements({{"cgal.pose", prepare_poses}});
  return run_measurements(count, words);
}
