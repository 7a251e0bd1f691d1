#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/geom/vec.h"
#include "postproc/image/picture_scene.h"

namespace gouge {

/// A surface for a graphics card: a vertex has one normal, so corners of sharp edges are vertices of their own. Of a
/// picture only: positions are rounded when they are written.
struct ViewerMesh {
  std::vector<Vec3> positions;
  std::vector<Eigen::Vector3f> normals;  ///< unit, by vertex
  std::vector<std::uint32_t> mesh_of;    ///< by vertex: among the meshes of the scene
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< sharp ones, of these vertices

  /// Vertices are as in the meshes, in the order in which triangles first name them, once for each normal.
  [[nodiscard]] static ViewerMesh from(const PictureScene& scene);
};

}  // namespace gouge
