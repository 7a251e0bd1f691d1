#include "postproc/image/picture_scene.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

constexpr float kSmoothCosine = 0.819F;  // of 35 degrees
constexpr std::size_t kLargestFan = 64;  // corners of a vertex looked at for its smooth normal

using Normal = Eigen::Vector3f;

// Twice the area times the unit normal.
Vec3 area_normal(const PictureScene& scene, std::size_t face) {
  const auto& c = scene.faces[face].corners;
  const Vec3& a = scene.vertices[c[0]];
  return (scene.vertices[c[1]] - a).cross(scene.vertices[c[2]] - a);
}

Normal unit(const Vec3& v) {
  const double length = v.norm();
  return length > 0 ? Normal((v / length).cast<float>()) : Normal(0, 0, 1);
}

void add_mesh(PictureScene& scene, const IndexedMesh& mesh, bool is_fixture, std::uint32_t number) {
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
  for (const TriangleCorners& t : mesh.triangles) {
    PictureScene::Face face;
    face.corners = {first + t[0], first + t[1], first + t[2]};
    face.is_fixture = is_fixture;
    face.mesh = number;
    scene.faces.push_back(face);
  }
}

void smooth_normals(PictureScene& scene) {
  std::vector<Vec3> weighted(scene.faces.size());
  std::vector<Normal> flat(scene.faces.size());
  std::vector<std::uint32_t> start(scene.vertices.size() + 1, 0);
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    weighted[f] = area_normal(scene, f);
    flat[f] = unit(weighted[f]);
    for (const std::uint32_t v : scene.faces[f].corners) ++start[v + 1];
  }
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) start[v + 1] += start[v];
  std::vector<std::uint32_t> fan(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    for (const std::uint32_t v : scene.faces[f].corners) fan[next[v]++] = static_cast<std::uint32_t>(f);
  }
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = scene.faces[f].corners[k];
      Vec3 sum = Vec3::Zero();
      const std::size_t last = std::min<std::size_t>(start[v + 1], start[v] + kLargestFan);
      for (std::size_t i = start[v]; i < last; ++i) {
        if (flat[fan[i]].dot(flat[f]) >= kSmoothCosine) sum += weighted[fan[i]];
      }
      scene.faces[f].normals[k] = sum.norm() > 0 ? unit(sum) : flat[f];
    }
  }
}

void find_edges(PictureScene& scene) {
  struct Side {
    std::uint32_t a, b, face;
    bool operator<(const Side& o) const { return a != o.a ? a < o.a : b != o.b ? b < o.b : face < o.face; }
  };
  std::vector<Side> sides;
  sides.reserve(scene.faces.size() * 3);
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = scene.faces[f].corners[k];
      const std::uint32_t b = scene.faces[f].corners[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(f)});
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    while (j < sides.size() && sides[j].a == sides[i].a && sides[j].b == sides[i].b) ++j;
    const bool is_smooth =
        j - i == 2 &&
        unit(area_normal(scene, sides[i].face)).dot(unit(area_normal(scene, sides[i + 1].face))) >= kSmoothCosine;
    if (!is_smooth) scene.edges.push_back({sides[i].a, sides[i].b});
    i = j;
  }
}

}  // namespace

PictureScene build_picture_scene(const Scene& scene) {
  PictureScene out;
  std::uint32_t number = 0;
  for (const IndexedMesh& mesh : scene.parts) add_mesh(out, mesh, false, number++);
  out.part_vertices = out.vertices.size();
  for (const Vec3& p : out.vertices) out.part_box.extend(p);
  for (const IndexedMesh& mesh : scene.fixtures) add_mesh(out, mesh, true, number++);
  smooth_normals(out);
  find_edges(out);
  return out;
}

PictureScene build_picture_heads(std::span<const HeadBody> heads) {
  PictureScene out;
  std::uint32_t number = 0;
  for (const HeadBody& head : heads) add_mesh(out, head.surface.mesh(), false, number++);
  out.part_vertices = out.vertices.size();
  smooth_normals(out);
  find_edges(out);
  return out;
}

}  // namespace gouge
