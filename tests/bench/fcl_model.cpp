#include "tests/bench/fcl_model.h"

#include <vector>

#include "tests/bench/peer_support.h"

namespace gouge::bench {

std::shared_ptr<FclModel> make_fcl_model(const IndexedMesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const TriangleCorners& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  auto model = std::make_shared<FclModel>();
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

fcl::Transform3d fcl_transform(const Pose& pose, const Pose& like) {
  fcl::Transform3d t = fcl::Transform3d::Identity();
  t.linear() = Eigen::Quaterniond::FromTwoVectors(like.axis, pose.axis).toRotationMatrix() * rotation_of(like.axis);
  t.translation() = pose.tip;
  return t;
}

}  // namespace gouge::bench
