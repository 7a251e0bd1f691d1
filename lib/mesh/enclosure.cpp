#include "lib/mesh/enclosure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/mesh/adjacency.h"
#include "lib/mesh/body_pieces.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/mesh/opposite_half_edges.h"
#include "lib/mesh/ray_cone.h"
#include "lib/mesh/union_find.h"

namespace gouge {

namespace {

// The surface that is missing at a hole lies within this many widths of its rim's middle line: a half sphere over a
// round hole.
constexpr double kReach = 1;
// Rounding of a winding number with all gaps filled, which is a whole number.
constexpr double kWhole = 1e-6;

/// Returns the coordinate axes and the diagonals between them.
std::vector<Vec3> fixed_directions() {
  std::vector<Vec3> all;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) all.emplace_back(x, y, z);
      }
    }
  }
  return all;
}

std::string faults_text(const EdgeFaults& faults) {
  std::string text;
  if (faults.open > 0) text = count_text(faults.open, "open edge", "open edges");
  if (faults.misoriented > 0) {
    text += (text.empty() ? "" : " and ") + count_text(faults.misoriented,
                                                       "edge with triangles oriented against each other",
                                                       "edges with triangles oriented against each other");
  }
  return text;
}

/// Shells that are examined together, with the facts about their edges.
class Shells {
 public:
  /// Finds the facts. With `bounds_bodies` every triangle is part of a body's boundary, so a point joined with infinity
  /// is outside of material.
  Shells(const IndexedMesh& mesh, bool bounds_bodies, std::span<const std::uint32_t> file_of)
      : mesh_(mesh), file_of_(file_of), bounds_bodies_(bounds_bodies), faults_(find_edge_faults(mesh)) {}

  [[nodiscard]] const EdgeFaults& faults() const { return faults_; }

  [[nodiscard]] Side side_of(const ConnectedPoints& joined) const {
    if (bounds_bodies_ && has_path_out(joined)) return Side::outside;
    for (const Vec3& candidate : joined.points) {
      if (!is_clear_of_holes(candidate)) continue;
      const std::optional<long> winding = filled_winding(candidate);
      if (!winding) continue;
      if (is_inside(*winding)) return Side::inside;
      if (*winding == 0 && bounds_bodies_ && faults_.is_empty() && cavities().contain(candidate)) return Side::outside;
    }
    return Side::unknown;
  }

 private:
  [[nodiscard]] bool has_path_out(const ConnectedPoints& joined) const {
    static const std::vector<Vec3> kFixed = fixed_directions();
    return has_free_ray(mesh_, joined.points, joined.directions) || has_free_ray(mesh_, joined.points, kFixed);
  }

  /// Returns whether the point is on the same side in whatever way the holes are closed, within the reach that their
  /// width makes likely. If there are only turned triangles, nothing must be closed.
  [[nodiscard]] bool is_clear_of_holes(const Vec3& point) const {
    const auto is_near = [&](const SurfaceGap& gap) {
      return gap.distance_mm(point) <= kReach * gap.width_mm + Tolerance::kRounding * (1 + point.cwiseAbs().maxCoeff());
    };
    return faults_.open == 0 || std::none_of(faults_.gaps.begin(), faults_.gaps.end(), is_near);
  }

  /// Returns the winding number with every gap filled by triangles from its edges to its middle.
  [[nodiscard]] std::optional<long> filled_winding(const Vec3& point) const {
    double winding = winding_number(mesh_, point);
    for (const SurfaceGap& gap : faults_.gaps) {
      const Vec3 apex = 0.5 * (gap.end_a + gap.end_b);
      double angle = 0;
      for (const FaultyEdge& e : gap.edges)
        angle += e.surplus * solid_angle(mesh_.vertices[e.to], mesh_.vertices[e.from], apex, point);
      winding += angle / (4 * std::numbers::pi);
    }
    const double whole = std::round(winding);
    if (!(std::abs(winding - whole) <= kWhole)) return std::nullopt;
    return static_cast<long>(whole);
  }

  // Returns whether a winding number means inside. If triangles were turned, only its parity is reliable. The rim of a
  // hole does not show on which side the material is unless the surface faces outward.
  [[nodiscard]] bool is_inside(long winding) const {
    if (faults_.open > 0) return winding == 1;
    return winding % 2 != 0 || (faults_.is_empty() && winding != 0);
  }

  [[nodiscard]] const Cavities& cavities() const {
    std::call_once(cavities_once_, [this] { cavities_.emplace(mesh_, file_of_); });
    return *cavities_;
  }

  const IndexedMesh& mesh_;
  std::span<const std::uint32_t> file_of_;
  bool bounds_bodies_;
  EdgeFaults faults_;
  mutable std::once_flag cavities_once_;
  mutable std::optional<Cavities> cavities_;
};

}  // namespace

/// Facts about the surface, computed once.
struct Enclosure::Surface {
  std::once_flag once;
  WeldedMesh welded;  // of several files, or of one with triangles that share an edge in the same direction
  BodyPieces pieces;
  std::vector<std::uint32_t> file_of_sound;
  std::optional<Shells> all, sound;
  std::vector<std::unique_ptr<Shells>> files;  // each file alone, if there are several

  void find(std::span<const IndexedMesh> meshes) {
    const bool is_used_as_it_is = meshes.size() == 1 && find_opposite_half_edges(meshes[0]);
    if (!is_used_as_it_is) welded = weld_together(meshes);
    const IndexedMesh& mesh = is_used_as_it_is ? meshes[0] : welded.mesh;
    pieces = find_body_pieces(mesh);
    const bool bounds_bodies = pieces.doubtful_box.isEmpty();
    all.emplace(mesh, bounds_bodies, welded.file_of);
    if (meshes.size() > 1) {
      for (const IndexedMesh& file : meshes)
        files.push_back(std::make_unique<Shells>(file, false, std::span<const std::uint32_t>{}));
    }
    if (bounds_bodies) {
      pieces = {};  // `all` is the same then
      return;
    }
    for (const std::uint32_t t : pieces.origin) file_of_sound.push_back(welded.file_of.empty() ? 0 : welded.file_of[t]);
    sound.emplace(pieces.sound, true, file_of_sound);
  }

  [[nodiscard]] Side side_of(const ConnectedPoints& joined) const {
    Side side = sound ? side_beyond_doubtful(joined) : Side::unknown;
    if (side == Side::unknown) side = all->side_of(joined);
    // A file is a separate part: a point that it encloses alone is inside, even if other files cancel that.
    const auto encloses = [&](const auto& file) {
      return file->faults().open == 0 && file->side_of(joined) == Side::inside;
    };
    const bool is_in_one = side == Side::unknown && std::any_of(files.begin(), files.end(), encloses);
    return is_in_one ? Side::inside : side;
  }

  [[nodiscard]] std::string faults() const {
    std::string text = faults_text(all->faults());
    if (welded.repeated > 0 && !text.empty())
      text += " when triangles that stand there more than once are counted once";
    if (pieces.double_walls > 0) {
      text += (text.empty() ? "" : " and ") +
              count_text(pieces.double_walls, "piece of surface that lies", "pieces of surface that lie") +
              " on itself and may enclose nothing";
    }
    return text;
  }

 private:
  /// Decides by the sound pieces for points beyond the box of the pieces that may not bound a body.
  [[nodiscard]] Side side_beyond_doubtful(const ConnectedPoints& joined) const {
    ConnectedPoints apart{{}, joined.directions};
    for (const Vec3& candidate : joined.points) {
      if (!pieces.doubtful_box.contains(candidate)) apart.points.push_back(candidate);
    }
    return apart.points.empty() ? Side::unknown : sound->side_of(apart);
  }
};

Enclosure::Enclosure(std::span<const IndexedMesh> meshes)
    : meshes_(meshes), box_(box_of(meshes)), surface_(std::make_unique<Surface>()) {
  if (box_.isEmpty()) return;
  const Vec3 margin =
      Vec3::Constant(Tolerance::kRounding * (1 + box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs()).maxCoeff()));
  beyond_ = Box3(box_.min() - margin, box_.max() + margin);
}

Enclosure::~Enclosure() = default;

bool Enclosure::is_beyond(const Vec3& point) const { return box_.isEmpty() || !beyond_.contains(point); }

const Enclosure::Surface& Enclosure::surface() const {
  std::call_once(surface_->once, [this] { surface_->find(meshes_); });
  return *surface_;
}

Side Enclosure::side_of(const ConnectedPoints& joined) const {
  const auto is_out = [this](const Vec3& p) { return is_beyond(p); };
  if (std::any_of(joined.points.begin(), joined.points.end(), is_out)) return Side::outside;
  return surface().side_of(joined);
}

std::string Enclosure::why_unknown() const {
  const Surface& s = surface();
  std::string names;
  for (const IndexedMesh& mesh : meshes_) names += (names.empty() ? "" : ", ") + mesh.name;
  const std::string what = meshes_.size() == 1 ? " has " : " have together ";
  if (const std::string faults = s.faults(); !faults.empty()) return names + what + faults;
  return "the shells of " + names +
         (meshes_.size() == 1 ? " cancel each other there: doubled, or overlapping inside out"
                              : " cancel one another there: doubled, or overlapping inside out");
}

namespace {

// Minimum thickness of the material around a cavity, as a share of the cavity's size. Two shells closer to each other
// are probably the same wall written twice.
constexpr double kMinCavityWall = 0.01;
constexpr double kWholeCavity = 1e-6;

bool is_about(double value, double whole) { return std::abs(value - whole) <= kWholeCavity; }

/// Returns false only if the triangle and the box are apart.
bool may_meet(const std::array<Vec3, 3>& triangle, const Box3& box) {
  Box3 own;
  for (const Vec3& corner : triangle) own.extend(corner);
  if (!own.intersects(box)) return false;
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double height = normal.dot(box.center() - triangle[0]);
  const double reach = normal.cwiseAbs().dot(0.5 * box.diagonal());
  return std::abs(height) <= reach;
}

}  // namespace

Cavities::Cavities(const IndexedMesh& mesh, std::span<const std::uint32_t> file_of)
    : mesh_(mesh), shell_of_(mesh.triangles.size()) {
  const MeshAdjacency adjacency(mesh);
  UnionFind roots(mesh.triangles.size());
  for (const MeshEdge& edge : adjacency.edges()) {
    for (const EdgeUse& use : adjacency.uses(edge)) roots.join(adjacency.uses(edge)[0].triangle, use.triangle);
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::uint32_t root = roots.root(t);
    if (root == t) {
      shell_of_[t] = static_cast<std::uint32_t>(shells_.size());
      shells_.emplace_back();
    }
    shell_of_[t] = shell_of_[root];
    Shell& shell = shells_[shell_of_[t]];
    const std::uint32_t file = file_of.empty() ? 0 : file_of[t];
    if (root == t) shell.file = file;
    shell.is_of_one_file = shell.is_of_one_file && shell.file == file;
    for (std::size_t k = 0; k < 3; ++k) shell.box.extend(mesh.corner(t, k));
  }
  for (const MeshEdge& edge : adjacency.edges()) {
    if (edge.use_count != 2) shells_[shell_of_[adjacency.uses(edge)[0].triangle]].is_manifold = false;
  }
}

bool Cavities::contain(const Vec3& point) const {
  std::vector<double> windings(shells_.size(), 0);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    windings[shell_of_[t]] +=
        solid_angle(mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2), point) / (4 * std::numbers::pi);
  }
  double others = 0;
  std::vector<std::uint32_t> inward;
  for (std::uint32_t k = 0; k < shells_.size(); ++k) {
    if (is_about(windings[k], -1) && shells_[k].is_manifold)
      inward.push_back(k);
    else
      others += windings[k];
  }
  if (inward.size() != 1) return false;
  const Shell& cavity = shells_[inward[0]];
  // A region around which another file winds is a separate part: it neither fills this file's cavity nor empties it.
  for (std::uint32_t k = 0; k < shells_.size(); ++k) {
    const bool is_same_file = shells_[k].is_of_one_file && shells_[k].file == cavity.file;
    if (!is_same_file && !is_about(windings[k], 0)) return false;
  }
  return cavity.is_of_one_file && is_about(others, 1) && stands_alone(inward[0], point);
}

bool Cavities::stands_alone(std::uint32_t shell, const Vec3& point) const {
  Box3 box = shells_[shell].box;
  const Vec3 wall = Vec3::Constant(kMinCavityWall * box.diagonal().norm());
  box = Box3(box.min() - wall, box.max() + wall);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (shell_of_[t] == shell || !shells_[shell_of_[t]].box.contains(point)) continue;
    if (may_meet({mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)}, box)) return false;
  }
  return true;
}

}  // namespace gouge
