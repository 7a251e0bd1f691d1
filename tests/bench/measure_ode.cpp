#include <ode/ode.h>

#include <memory>
#include <vector>

#include "tests/bench/peer_support.h"

// ODE: capsule and cylinder against the triangle mesh where the tool is made of them, else the tessellated
// tool as a second triangle mesh. Single poses, yes or no.

namespace gouge::bench {
namespace {

constexpr double kChord_mm = 0.01;

/// A triangle mesh with the arrays ODE points into. Single or double precision as ODE was built.
struct OdeMesh {
  std::vector<dReal> corners;
  std::vector<dTriIndex> indices;
  dTriMeshDataID data = dGeomTriMeshDataCreate();

  explicit OdeMesh(const IndexedMesh& mesh) {
    for (const Vec3& v : mesh.vertices) {
      for (int k = 0; k < 3; ++k) corners.push_back(static_cast<dReal>(v[k]));
    }
    for (const TriangleCorners& t : mesh.triangles) {
      for (const Corner c : t) indices.push_back(static_cast<dTriIndex>(c));
    }
    const int stride = static_cast<int>(3 * sizeof(dReal)), step = static_cast<int>(3 * sizeof(dTriIndex));
    if constexpr (sizeof(dReal) == sizeof(double)) {
      dGeomTriMeshDataBuildDouble(data, corners.data(), stride, static_cast<int>(mesh.vertices.size()), indices.data(),
                                  static_cast<int>(indices.size()), step);
    } else {
      dGeomTriMeshDataBuildSingle(data, corners.data(), stride, static_cast<int>(mesh.vertices.size()), indices.data(),
                                  static_cast<int>(indices.size()), step);
    }
  }
  OdeMesh(const OdeMesh&) = delete;
  OdeMesh& operator=(const OdeMesh&) = delete;
  ~OdeMesh() { dGeomTriMeshDataDestroy(data); }
};

class OdeScene {
 public:
  OdeScene(const IndexedMesh& mesh, const BenchTool& tool) : part_data_(mesh) {
    part_ = dCreateTriMesh(nullptr, part_data_.data, nullptr, nullptr, nullptr);
    if (tool.lower.contour.size() == 2) {
      const double z0 = tool.lower.contour[0].y(), z1 = tool.lower.contour[1].y();
      add(dCreateCapsule(nullptr, static_cast<dReal>(tool.lower.rounding_mm), static_cast<dReal>(z1 - z0)),
          0.5 * (z0 + z1));
      const Vec2 &low = tool.holder.contour[1], &high = tool.holder.contour[2];
      add(dCreateCylinder(nullptr, static_cast<dReal>(low.x()), static_cast<dReal>(high.y() - low.y())),
          0.5 * (low.y() + high.y()));
    } else {
      tool_data_ = std::make_unique<OdeMesh>(tessellate_tool(tool, kChord_mm));
      add(dCreateTriMesh(nullptr, tool_data_->data, nullptr, nullptr, nullptr), 0);
    }
  }
  OdeScene(const OdeScene&) = delete;
  OdeScene& operator=(const OdeScene&) = delete;
  ~OdeScene() {
    dGeomDestroy(part_);
    for (const Piece& p : pieces_) dGeomDestroy(p.geometry);
  }

  bool is_hit(const Pose& pose) {
    const Eigen::Matrix3d m = rotation_of(pose.axis);
    dMatrix3 turn = {};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) turn[4 * row + column] = static_cast<dReal>(m(row, column));
    }
    for (const Piece& p : pieces_) {
      const Vec3 at = pose.tip + p.middle_mm * pose.axis;
      dGeomSetRotation(p.geometry, turn);
      dGeomSetPosition(p.geometry, static_cast<dReal>(at.x()), static_cast<dReal>(at.y()), static_cast<dReal>(at.z()));
      dContactGeom contact;
      const int flags = 1 | static_cast<int>(CONTACTS_UNIMPORTANT);
      if (dCollide(p.geometry, part_, flags, &contact, sizeof contact) > 0) return true;
    }
    return false;
  }

 private:
  struct Piece {
    dGeomID geometry = nullptr;
    double middle_mm = 0;
  };
  void add(dGeomID geometry, double middle_mm) { pieces_.push_back({geometry, middle_mm}); }

  OdeMesh part_data_;
  std::unique_ptr<OdeMesh> tool_data_;
  dGeomID part_ = nullptr;
  std::vector<Piece> pieces_;
};

std::function<void(benchmark::State&)> prepare_poses(const std::shared_ptr<const PeerCase>& c) {
  const auto scene = std::make_shared<OdeScene>(c->work.scene.parts[0], c->work.tool);
  const auto sample = sample_poses(*c, scaled(c->triangles <= 20000 ? 2000 : 400));
  return [=](benchmark::State& state) {
    time_poses(
        state, *c, sample, [&](const Pose& pose) { return scene->is_hit(pose) ? 1.0 : 0.0; }, true);
  };
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge::bench;
  dInitODE2(0);
  register_measurements({{"ode.pose", prepare_poses}});
  return run_measurements(count, words);
}
