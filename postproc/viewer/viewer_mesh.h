#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/pose.h"
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

  /// Makes the mesh of a scene. Vertices are as in the meshes, in the order in which triangles first name them, once
  /// for each normal.
  [[nodiscard]] static ViewerMesh from(const PictureScene& scene);
};

/// A pose of the path that the viewer shows, and interpolates between: the end of a move, or an instant of a curve.
struct Station {
  Pose pose;
  std::size_t move = 0;
  double t = 1;
  bool is_start = false;  ///< no motion leads here: the first position, or one after a motion that is not known
};

/// Returns stations of a path: curves with chords `error_mm` from them. Of a path of more than `most` moves some are
/// taken, at equal steps. The worst move of each finding is taken with its neighbours, where the next but one would not
/// be distinguished.
[[nodiscard]] std::vector<Station> stations_of(const CheckedToolpath& input, double error_mm, std::size_t most);

}  // namespace gouge
