#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lib/field/checked_toolpath.h"
#include "lib/geom/pose.h"
#include "lib/geom/vec.h"
#include "postproc/image/picture_scene.h"

namespace gouge {

/// A surface for a graphics card. A vertex has one normal, so corners at sharp edges are separate vertices. It serves
/// only for pictures: positions are rounded on output.
struct ViewerMesh {
  static constexpr std::size_t kMoreTriangles = 150'000;  ///< maximum number of triangles that a refinement adds

  std::vector<Vec3> positions;
  std::vector<Eigen::Vector3f> normals;  ///< unit vector, for each vertex
  std::vector<std::uint32_t> mesh_of;    ///< for each vertex: the index of its mesh in the scene
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< sharp edges, as indices of these vertices

  /// Makes the mesh of a scene. Vertices are those of the meshes, in the order in which triangles first use them, once
  /// for each normal.
  [[nodiscard]] static ViewerMesh from(const PictureScene& scene);
};

/// A pose of the path that the viewer shows: the end of a move, or an instant of a curve. The viewer interpolates
/// between two.
struct Station {
  Pose pose;
  std::size_t move = 0;
  double t = 1;
  bool is_start = false;  ///< no motion leads to it: it is the first position, or follows an unknown motion
};

/// Returns stations of a path, with curves as chords within `error_mm`. For a path of more than `most` moves, some are
/// taken at equal steps. The worst move of each finding is taken too, with its neighbours.
[[nodiscard]] std::vector<Station> stations_of(const CheckedToolpath& input, double error_mm, std::size_t most);

}  // namespace gouge
