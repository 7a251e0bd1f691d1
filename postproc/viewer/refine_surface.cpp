#include "postproc/viewer/refine_surface.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "lib/base/tolerance.h"

namespace gouge {

namespace {

constexpr double kLooks = 60'000;  // number of points that are examined
constexpr std::size_t kMaxTriangles = ViewerMesh::kMoreTriangles;
// relative to the size of the parts, and the factor if that gives too many
constexpr double kFinest = 1.0 / 400, kCoarser = 1.4;
// relative to the size of the parts: minimum distance of points on a flat part without area
constexpr double kMinApart = 1e-6;
constexpr int kMaxCuts = 24;  // maximum depth of repeated cuts of a triangle

using Triangle = std::array<std::uint32_t, 3>;

Vec3 normal_of(const ViewerMesh& mesh, const Triangle& t) {
  const Vec3 a = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

double area_of(const ViewerMesh& mesh) {
  double area = 0;
  for (const Triangle& t : mesh.triangles) area += 0.5 * normal_of(mesh, t).norm();
  return area;
}

/// Returns points that are spread over the surface, about `apart_mm` from each other. There is at least one in the
/// middle of each triangle that is not much smaller.
std::vector<SurfacePoint> spread_points(const ViewerMesh& mesh, double apart_mm) {
  std::vector<SurfacePoint> points;
  double skipped = 0;  // area of triangles without a point so far
  for (const Triangle& t : mesh.triangles) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[t[k]];
    const Vec3 square = (p[1] - p[0]).cross(p[2] - p[0]);
    const double doubled = square.norm();
    if (!(doubled > 0)) continue;
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if ((p[(k + 1) % 3] - p[k]).norm() > (p[(longest + 1) % 3] - p[longest]).norm()) longest = k;
    }
    std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(longest), p.end());
    const double length = (p[1] - p[0]).norm(), height = doubled / length;
    skipped += 0.5 * doubled;
    if (length < apart_mm && skipped < 0.5 * apart_mm * apart_mm) continue;
    skipped = 0;
    const int along = std::max(1, static_cast<int>(length / apart_mm));
    const int across = std::max(1, static_cast<int>(height / apart_mm));
    for (int j = 0; j < across; ++j) {
      const double v = across == 1 ? 1.0 / 3 : (j + 0.5) / across;
      const int row = std::max(1, static_cast<int>(along * (1 - v) + 0.5));
      for (int i = 0; i < row; ++i) {
        const double u = (i + 0.5) / row * (1 - v);
        points.push_back({p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]), square / doubled, mesh.mesh_of[t[0]]});
      }
    }
  }
  return points;
}

/// Cuts triangles into two to four until no edge near a gouge is too long.
class Cutter {
 public:
  Cutter(ViewerMesh& mesh, const GougedCells& cells, double finest_mm)
      : out_(mesh), cells_(cells), finest_mm_(finest_mm) {}

  /// Cuts the triangles; the pieces take the place of the triangle. Returns false if there would be too many; then
  /// nothing is changed.
  bool run() {
    const std::size_t vertices = out_.positions.size();
    for (std::uint32_t face = 0; face < out_.triangles.size(); ++face) {
      const std::size_t first = pieces_.size();
      cut(out_.triangles[face], 0);
      if (pieces_.size() == first + 1 && !is_over_) {
        pieces_.pop_back();
        continue;
      }
      cuts_.push_back({face, first});
      if (!is_over_ && !is_full()) continue;
      out_.positions.resize(vertices);
      out_.normals.resize(vertices);
      out_.mesh_of.resize(vertices);
      return false;
    }
    put_pieces();
    return true;
  }

 private:
  static constexpr std::uint32_t kWhole = 0xFFFFFFFFU;

  /// A triangle that was cut. Its pieces end where those of the next one begin.
  struct Cut {
    std::uint32_t face = 0;
    std::size_t first_piece = 0;
  };

  [[nodiscard]] bool is_full() const { return pieces_.size() > cuts_.size() + kMaxTriangles; }

  /// Replaces the triangles by their pieces, from the last one on, so that no second list of all triangles is needed.
  void put_pieces() {
    std::vector<Triangle>& all = out_.triangles;
    auto from = static_cast<std::ptrdiff_t>(all.size());
    all.resize(all.size() + pieces_.size() - cuts_.size());
    auto to = all.end();
    auto last = pieces_.end();
    for (std::size_t k = cuts_.size(); k-- > 0;) {
      const auto face = static_cast<std::ptrdiff_t>(cuts_[k].face);
      const auto first = pieces_.begin() + static_cast<std::ptrdiff_t>(cuts_[k].first_piece);
      to = std::move_backward(all.begin() + face + 1, all.begin() + from, to);
      to = std::copy_backward(first, last, to);
      from = face;
      last = first;
    }
  }

  // Returns the middle of an edge that must be cut, else kWhole. The decision depends only on the position of the edge.
  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const double length = (out_.positions[a] - out_.positions[b]).norm();
    if (length <= finest_mm_) return kWhole;
    const Vec3 at = 0.5 * (out_.positions[a] + out_.positions[b]);
    if (!cells_.is_near(at, 0.6 * length)) return kWhole;
    const std::uint64_t key = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    const auto [found, is_new] = middles_.try_emplace(key, kWhole);
    if (!is_new) return found->second;
    found->second = static_cast<std::uint32_t>(out_.positions.size());
    const Eigen::Vector3f sum = out_.normals[a] + out_.normals[b];
    out_.positions.push_back(at);
    out_.normals.push_back(sum.norm() > 0 ? Eigen::Vector3f(sum.normalized()) : out_.normals[a]);
    out_.mesh_of.push_back(out_.mesh_of[a]);
    return found->second;
  }

  void cut(const Triangle& t, int depth) {
    std::array<std::uint32_t, 3> m{kWhole, kWhole, kWhole};  // m[k]: middle of the edge between k and k + 1
    int cuts = 0;
    for (std::size_t k = 0; k < 3 && depth < kMaxCuts; ++k) {
      m[k] = middle(t[k], t[(k + 1) % 3]);
      cuts += m[k] != kWhole ? 1 : 0;
    }
    if (cuts == 0) return pieces_.push_back(t);
    is_over_ = is_over_ || is_full();
    if (is_over_) return;
    const auto go = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { cut({a, b, c}, depth + 1); };
    if (cuts == 3) {
      for (std::size_t k = 0; k < 3; ++k) go(t[k], m[k], m[(k + 2) % 3]);
      return go(m[0], m[1], m[2]);
    }
    std::size_t k = 0;  // with one cut: the edge that is cut; with two: the first of two consecutive edges that are cut
    while (m[k] == kWhole || (cuts == 2 && m[(k + 1) % 3] == kWhole)) ++k;
    const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    if (cuts == 1) {
      go(a, m[k], c);
      return go(m[k], b, c);
    }
    go(m[k], b, m[(k + 1) % 3]);
    go(a, m[k], m[(k + 1) % 3]);
    go(a, m[(k + 1) % 3], c);
  }

  ViewerMesh& out_;
  std::vector<Triangle> pieces_;
  std::vector<Cut> cuts_;
  bool is_over_ = false;  // pieces were left out because there are too many
  const GougedCells& cells_;
  double finest_mm_;
  std::unordered_map<std::uint64_t, std::uint32_t> middles_;
};

// Returns a point for each vertex, slightly inside of a triangle. At a sharp edge itself a ray along the normal would
// measure nothing.
std::vector<SurfacePoint> vertex_points(const ViewerMesh& mesh, const std::vector<std::uint32_t>& vertices) {
  constexpr double kInside = 0.02;
  std::vector<std::uint32_t> owner(mesh.positions.size(), 0);
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    for (const std::uint32_t v : mesh.triangles[t]) owner[v] = static_cast<std::uint32_t>(t);
  }
  std::vector<SurfacePoint> points;
  points.reserve(vertices.size());
  for (const std::uint32_t v : vertices) {
    const Triangle& t = mesh.triangles[owner[v]];
    const Vec3 centre = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
    const Vec3 square = normal_of(mesh, t);
    const double length = square.norm();
    points.push_back({mesh.positions[v] + kInside * (centre - mesh.positions[v]),
                      length > 0 ? Vec3(square / length) : mesh.normals[v].cast<double>(), mesh.mesh_of[v]});
  }
  return points;
}

/// Adds the points at which a quantity is above 0.
void add_gouged(GougedCells& cells, const std::vector<SurfacePoint>& looks, const std::vector<AskedValues>& asked) {
  for (const AskedValues& one : asked) {
    const std::vector<float> found = one.values->at(looks, one.quantity);
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (found[i] > 0) cells.add(looks[i].at);
    }
  }
}

}  // namespace

VertexValues refine_surface(ViewerMesh& mesh, const std::vector<AskedValues>& asked, const std::vector<Vec3>& points,
                            double size_mm) {
  const double apart_mm = std::max(std::sqrt(area_of(mesh) / kLooks), kMinApart * size_mm + Tolerance::kSamePoint_mm);
  GougedCells cells(apart_mm);
  for (const Vec3& point : points) cells.add(point);
  add_gouged(cells, spread_points(mesh, apart_mm), asked);
  for (double finest_mm = kFinest * size_mm; finest_mm < size_mm; finest_mm *= kCoarser) {
    if (Cutter(mesh, cells, finest_mm).run()) break;
  }
  std::vector<std::uint32_t> near;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (cells.is_near(mesh.positions[v], apart_mm)) near.push_back(v);
  }
  const std::vector<SurfacePoint> at = vertex_points(mesh, near);
  VertexValues values;
  for (const AskedValues& one : asked) {
    const std::vector<float> found = one.values->at(at, one.quantity);
    values.emplace_back(mesh.positions.size(), 0.0F);
    for (std::size_t i = 0; i < near.size(); ++i) values.back()[near[i]] = found[i];
  }
  return values;
}

namespace {

struct Cell {
  std::int64_t x, y, z;
  [[nodiscard]] std::uint64_t key() const {
    constexpr std::int64_t kMiddle = 1 << 20;
    constexpr std::uint64_t kMask = (1U << 21) - 1;
    const auto part = [&](std::int64_t v) { return static_cast<std::uint64_t>(v + kMiddle) & kMask; };
    return part(x) << 42 | part(y) << 21 | part(z);
  }
};

Cell cell_of(const Vec3& p, double side) {
  return {static_cast<std::int64_t>(std::floor(p.x() / side)), static_cast<std::int64_t>(std::floor(p.y() / side)),
          static_cast<std::int64_t>(std::floor(p.z() / side))};
}

bool has_any(const std::unordered_set<std::uint64_t>& cells, const Cell& low, const Cell& high) {
  for (std::int64_t x = low.x; x <= high.x; ++x) {
    for (std::int64_t y = low.y; y <= high.y; ++y) {
      for (std::int64_t z = low.z; z <= high.z; ++z) {
        if (cells.contains(Cell{x, y, z}.key())) return true;
      }
    }
  }
  return false;
}

}  // namespace

void GougedCells::add(const Vec3& point) {
  double side = finest_mm_;
  for (auto& level : levels_) {
    if (!level.insert(cell_of(point, side).key()).second) return;  // then all levels above have it too
    side *= 2;
  }
}

bool GougedCells::is_near(const Vec3& at, double reach_mm) const {
  double side = finest_mm_;
  std::size_t level = 0;
  while (side < reach_mm && level + 1 < levels_.size()) {
    side *= 2;
    ++level;
  }
  const Cell c = cell_of(at, side);
  // If a cell has a point, the larger cells around it have it too. So one of those is tested first, and is usually
  // empty.
  for (const std::size_t up : {std::size_t{4}, std::size_t{2}, std::size_t{0}}) {
    if (level + up >= levels_.size()) continue;
    if (!has_any(levels_[level + up], {(c.x - 1) >> up, (c.y - 1) >> up, (c.z - 1) >> up},
                 {(c.x + 1) >> up, (c.y + 1) >> up, (c.z + 1) >> up}))
      return false;
  }
  return true;
}

}  // namespace gouge
