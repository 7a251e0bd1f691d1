#include "postproc/viewer/scene_writer.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::uint32_t>;

std::uint32_t rounded(double value, double top) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value, 0.0, top)));
}

/// Origin and step of a grid with `levels` + 1 places along the longest side of a box.
struct Grid {
  Vec3 origin = Vec3::Zero();
  double step = 1;
  double levels;

  Grid(const Box3& box, double count) : levels(count) {
    if (box.isEmpty()) return;
    origin = box.min();
    step = std::max(box.sizes().maxCoeff(), Tolerance::kSamePoint_mm) / count;
  }
  [[nodiscard]] std::uint32_t place(const Vec3& p, int axis) const {
    return rounded((p[axis] - origin[axis]) / step, levels);
  }
  [[nodiscard]] Json json() const { return {{"origin", {origin.x(), origin.y(), origin.z()}}, {"step", step}}; }
};

/// Returns a unit direction as a place on the square of an unfolded octahedron with `top` + 1 places along each side.
std::array<std::uint32_t, 2> octahedral(const Vec3& n, double top) {
  const double sum = std::abs(n.x()) + std::abs(n.y()) + std::abs(n.z());
  double x = sum > 0 ? n.x() / sum : 0, y = sum > 0 ? n.y() / sum : 0;
  if (n.z() < 0) {
    const double fx = (1 - std::abs(y)) * (x < 0 ? -1 : 1);
    y = (1 - std::abs(x)) * (y < 0 ? -1 : 1);
    x = fx;
  }
  return {rounded((0.5 * x + 0.5) * top, top), rounded((0.5 * y + 0.5) * top, top)};
}

template <class Directions>
Json write_directions(Payload& payload, const Directions& directions, int bytes) {
  std::array<Numbers, 2> parts;
  for (Numbers& part : parts) part.reserve(directions.size());
  for (const auto& d : directions) {
    const double top = bytes == 1 ? 254 : 65534;  // even, so that the six axes are exact
    const auto place = octahedral(d.template cast<double>(), top);
    for (std::size_t k = 0; k < 2; ++k) parts[k].push_back(place[k]);
  }
  return {payload.add_differences(parts[0], bytes), payload.add_differences(parts[1], bytes)};
}

// Writes each corner as the distance back from the first vertex that no triangle has used so far; 0: it is that vertex.
Json write_corners(Payload& payload, const ViewerMesh& mesh) {
  std::uint32_t next = 0;
  return payload.add(3 * mesh.triangles.size(), 4, [&](std::size_t i) {
    const std::uint32_t corner = mesh.triangles[i / 3][i % 3], back = next - corner;
    if (corner == next) ++next;
    return back;
  });
}

}  // namespace

Json write_mesh(Payload& payload, const ViewerMesh& mesh) {
  constexpr std::size_t kBytesOfVertex = 12, kBytesOfTriangle = 12, kBytesOfEdge = 8;  // with the values of two paths
  payload.reserve(kBytesOfVertex * mesh.positions.size() + kBytesOfTriangle * mesh.triangles.size() +
                  kBytesOfEdge * mesh.edges.size());
  Box3 box;
  for (const Vec3& p : mesh.positions) box.extend(p);
  const Grid grid(box, 65535);
  Json out = grid.json();
  Json positions = Json::array();
  Numbers places(mesh.positions.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::transform(mesh.positions.begin(), mesh.positions.end(), places.begin(),
                   [&](const Vec3& p) { return grid.place(p, axis); });
    positions.push_back(payload.add_differences(places, 2));
  }
  out["positions"] = positions;
  out["normals"] = write_directions(payload, mesh.normals, 1);
  out["corners"] = write_corners(payload, mesh);
  Numbers ends;
  for (const auto& edge : mesh.edges) ends.insert(ends.end(), {edge[0], edge[1]});
  out["edges"] = payload.add_differences(ends, 4);
  return out;
}

Json write_values(Payload& payload, const std::vector<float>& values_mm, const ColourScale& scale) {
  Numbers places(values_mm.size());
  std::transform(values_mm.begin(), values_mm.end(), places.begin(), [&](float value) {
    return value > 0 ? std::max(1U, rounded(scale.place(static_cast<double>(value)) * 65535, 65535)) : 0U;
  });
  return payload.add_differences(places, 2);
}

Json write_path(Payload& payload, const std::vector<Station>& stations, const CheckedToolpath& input,
                const ColourScale& depths) {
  constexpr double kFine = 0xFFFFFF;
  Box3 box;
  for (const Station& s : stations) box.extend(s.pose.tip);
  const Grid grid(box, kFine);
  Json out = grid.json();
  Json tips = Json::array();
  Numbers numbers(stations.size());
  const auto each = [&](auto&& of) {
    std::transform(stations.begin(), stations.end(), numbers.begin(), of);
    return std::span<const std::uint32_t>(numbers);
  };
  for (int axis = 0; axis < 3; ++axis)
    tips.push_back(payload.add_differences(each([&](const Station& s) { return grid.place(s.pose.tip, axis); }), 3));
  out["tips"] = tips;
  std::vector<Vec3> axes;
  for (const Station& s : stations) axes.push_back(s.pose.axis);
  out["axes"] = write_directions(payload, axes, 2);
  const auto move = [&](const Station& s) -> const Move& { return input.toolpath->moves[s.move]; };
  const auto verdict = [&](const Station& s) -> const MoveVerdict& { return input.result->verdicts[s.move]; };
  out["moves"] = payload.add_differences(each([](const Station& s) { return static_cast<std::uint32_t>(s.move); }), 4);
  out["lines"] = payload.add_differences(
      each([&](const Station& s) { return static_cast<std::uint32_t>(std::size_t{move(s).line}); }), 4);
  out["t"] = payload.add(each([](const Station& s) { return rounded(s.t * 65535, 65535); }), 2);
  out["tools"] = payload.add(each([&](const Station& s) {
                               return move(s).tool == kNone
                                          ? 0xFFFFU
                                          : static_cast<std::uint32_t>(std::min<std::size_t>(move(s).tool, 0xFFFF));
                             }),
                             2);
  // The state is in the lower three bits, then the kind in two, then whether no motion leads to the station.
  out["states"] = payload.add(each([&](const Station& s) {
                                return static_cast<std::uint32_t>(verdict(s).state) |
                                       static_cast<std::uint32_t>(move(s).kind) << 3 | (s.is_start ? 32U : 0U);
                              }),
                              1);
  out["depths"] = payload.add(
      each([&](const Station& s) {
        const MoveVerdict& v = verdict(s);
        return v.state == MoveState::gouge ? std::max(1U, rounded(depths.place(v.depth_mm) * 65535, 65535)) : 0U;
      }),
      2);
  return out;
}

}  // namespace gouge
