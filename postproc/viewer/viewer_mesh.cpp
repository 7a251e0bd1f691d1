#include "postproc/viewer/viewer_mesh.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "lib/motion/chord_instants.h"
#include "lib/motion/motion_law.h"
#include "lib/path/chords.h"

namespace gouge {

namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMaxEdges = 300'000;
constexpr float kSameNormal = 0.9999F;
constexpr std::size_t kMoreVertices = 200'000;  // additional vertices along sharp edges and by refinement

}  // namespace

ViewerMesh ViewerMesh::from(const PictureScene& scene) {
  const std::uint32_t faces = scene.face_count();
  ViewerMesh out;
  out.triangles.reserve(faces + kMoreTriangles);
  const std::size_t vertices = scene.vertex_count() + kMoreVertices;
  out.positions.reserve(vertices);
  out.normals.reserve(vertices);
  out.mesh_of.reserve(vertices);
  // For each vertex of the scene its last copy, and for each copy the previous copy.
  std::vector<std::uint32_t> latest(scene.vertex_count(), kNoVertex), before;
  before.reserve(scene.vertex_count());
  for (std::uint32_t f = 0; f < faces; ++f) {
    const std::array<std::uint32_t, 3> corners = scene.corner_vertices(f);
    const std::array<Eigen::Vector3f, 3> normals = scene.normals(f);
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t copy = latest[corners[k]];
      while (copy != kNoVertex && out.normals[copy].dot(normals[k]) < kSameNormal) copy = before[copy];
      if (copy == kNoVertex) {
        copy = static_cast<std::uint32_t>(out.positions.size());
        out.positions.push_back(scene.vertex(corners[k]));
        out.normals.push_back(normals[k]);
        out.mesh_of.push_back(scene.mesh_of(f));
        before.push_back(latest[corners[k]]);
        latest[corners[k]] = copy;
      }
      triangle[k] = copy;
    }
    out.triangles.push_back(triangle);
  }
  if (scene.edges().size() <= kMaxEdges) {
    for (const PictureScene::Edge& edge : scene.edges()) {
      if (latest[edge.a] != kNoVertex && latest[edge.b] != kNoVertex)
        out.edges.push_back({latest[edge.a], latest[edge.b]});
    }
  }
  return out;
}

namespace {

constexpr std::size_t kMaxChords = 64;  // maximum number of chords of a curve

void add_motion(const CheckedToolpath& input, std::size_t move, double error_mm, std::vector<Station>& out) {
  const Toolpath& path = *input.toolpath;
  const Move& m = path.moves[move];
  const Motion motion = input.options.law.of(path, move);
  if (!motion.is_defined()) {
    out.push_back({m.end, move, 1, true});
    return;
  }
  if (m.curve_kind != CurveKind::none) {
    const std::size_t chords = std::clamp<std::size_t>(chords_of(path, move, error_mm).size(), 1, kMaxChords);
    for (std::size_t k = 1; k < chords; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(chords);
      out.push_back({motion.at(t), move, t, false});
    }
  } else {
    for (const double t : chord_instants(motion, error_mm, kMaxChords)) {
      if (t < 1) out.push_back({motion.at(t), move, t, false});
    }
  }
  out.push_back({m.end, move, 1, false});
}

}  // namespace

std::vector<Station> stations_of(const CheckedToolpath& input, double error_mm, std::size_t most) {
  const Toolpath& path = *input.toolpath;
  const std::size_t every = 1 + path.moves.size() / most;
  std::vector<bool> is_kept(path.moves.size(), every == 1);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (i % every == 0 || !path.moves[i].has_start) is_kept[i] = true;
  }
  for (const Event& event : input.result->events) {
    is_kept[event.worst_move] = true;
    if (event.worst_move > 0) is_kept[event.worst_move - 1] = true;
  }
  std::vector<Station> out;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_kept[i]) continue;
    if (!path.moves[i].has_start)
      out.push_back({path.moves[i].end, i, 1, true});
    else if (!is_kept[i - 1])
      out.push_back({path.moves[i].end, i, 1, false});
    else
      add_motion(input, i, error_mm, out);
  }
  return out;
}

}  // namespace gouge
