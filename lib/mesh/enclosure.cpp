#include "lib/mesh/enclosure.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>

#include "lib/mesh/cavity.h"
#include "lib/mesh/free_ray.h"
#include "lib/mesh/winding.h"

namespace gouge {
namespace {

// Rounding of a placed vertex and of a point of the tool, relative to their coordinates.
constexpr double kMargin = 1e-9;
// What is missing at a hole lies within this many widths of its rim's middle line: a half sphere over a round hole.
constexpr double kReach = 1;
// A winding number with all gaps filled is whole up to rounding.
constexpr double kWhole = 1e-6;

/// The coordinate axes and the diagonals between them.
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

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string faults_text(const EdgeFaults& faults) {
  std::string text;
  if (faults.open > 0) text = counted(faults.open, "open edge", "open edges");
  if (faults.misoriented > 0) {
    text += (text.empty() ? "" : " and ") +
            counted(faults.misoriented, "edge with triangles oriented against each other",
                    "edges with triangles oriented against each other");
  }
  return text;
}

/// Shells that are looked at together, with what is known of their edges.
class Shells {
 public:
  explicit Shells(const IndexedMesh& mesh) : mesh_(mesh), faults_(find_edge_faults(mesh)) {}

  [[nodiscard]] const EdgeFaults& faults() const { return faults_; }

  [[nodiscard]] Side side_of(const JoinedPlaces& joined) const {
    if (faults_.open == 0 && has_way_out(joined)) return Side::outside;
    for (const Vec3& place : joined.places) {
      if (!is_clear_of_holes(place)) continue;
      const std::optional<long> winding = filled_winding(place);
      if (!winding) continue;
      if (is_inside(*winding)) return Side::inside;
      if (*winding == 0 && faults_.is_empty() && cavities().contain(place)) return Side::outside;
    }
    return Side::unknown;
  }

 private:
  [[nodiscard]] bool has_way_out(const JoinedPlaces& joined) const {
    static const std::vector<Vec3> kFixed = fixed_directions();
    return has_free_ray(mesh_, joined.places, joined.directions) || has_free_ray(mesh_, joined.places, kFixed);
  }

  /// However the holes are closed, within what their width makes likely: the point is on the same side. Where there
  /// are only turned triangles nothing is to be closed.
  [[nodiscard]] bool is_clear_of_holes(const Vec3& point) const {
    const auto is_near = [&](const SurfaceGap& gap) {
      return gap.distance_mm(point) <= kReach * gap.width_mm + kMargin * (1 + point.cwiseAbs().maxCoeff());
    };
    return faults_.open == 0 || std::none_of(faults_.gaps.begin(), faults_.gaps.end(), is_near);
  }

  /// With every gap filled by the triangles from its edges to its middle.
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

  // Where triangles were turned only whether the number is odd can be believed. A hole's rim alone does not say on
  // which side the material is unless the surface faces outward.
  [[nodiscard]] bool is_inside(long winding) const {
    if (faults_.open > 0) return winding == 1;
    return winding % 2 != 0 || (faults_.is_empty() && winding != 0);
  }

  [[nodiscard]] const Cavities& cavities() const {
    std::call_once(cavities_once_, [this] { cavities_.emplace(mesh_); });
    return *cavities_;
  }

  const IndexedMesh& mesh_;
  EdgeFaults faults_;
  mutable std::once_flag cavities_once_;
  mutable std::optional<Cavities> cavities_;
};

}  // namespace

/// What is found out about the edges, once.
struct Enclosure::Surface {
  std::once_flag once;
  IndexedMesh welded;  // of several files
  IndexedMesh closed;  // where some pieces have holes: the others
  Box3 holed_box;      // of those that have
  std::optional<Shells> all, whole;

  void find(std::span<const IndexedMesh> meshes) {
    if (meshes.size() > 1) welded = weld_together(meshes);
    const IndexedMesh& mesh = meshes.size() == 1 ? meshes[0] : welded;
    all.emplace(mesh);
    if (all->faults().open == 0) return;
    closed = pieces_without_holes(mesh, holed_box);
    whole.emplace(closed);
  }

  [[nodiscard]] Side side_of(const JoinedPlaces& joined) const {
    if (!whole) return all->side_of(joined);
    JoinedPlaces apart{{}, joined.directions};
    for (const Vec3& place : joined.places) {
      if (!holed_box.contains(place)) apart.places.push_back(place);
    }
    const Side side = apart.places.empty() ? Side::unknown : whole->side_of(apart);
    return side == Side::unknown ? all->side_of(joined) : side;
  }
};

Enclosure::Enclosure(std::span<const IndexedMesh> meshes)
    : meshes_(meshes), surface_(std::make_unique<Surface>()) {
  for (const IndexedMesh& mesh : meshes) box_.extend(mesh.box());
  if (box_.isEmpty()) return;
  const Vec3 margin = Vec3::Constant(kMargin * (1 + box_.min().cwiseAbs().cwiseMax(box_.max().cwiseAbs()).maxCoeff()));
  beyond_ = Box3(box_.min() - margin, box_.max() + margin);
}

Enclosure::~Enclosure() = default;

bool Enclosure::is_beyond(const Vec3& point) const {
  return box_.isEmpty() || !beyond_.contains(point);
}

const Enclosure::Surface& Enclosure::surface() const {
  std::call_once(surface_->once, [this] { surface_->find(meshes_); });
  return *surface_;
}

Side Enclosure::side_of(const JoinedPlaces& joined) const {
  const auto is_out = [this](const Vec3& p) { return is_beyond(p); };
  if (std::any_of(joined.places.begin(), joined.places.end(), is_out)) return Side::outside;
  return surface().side_of(joined);
}

std::string Enclosure::why_unknown() const {
  const Surface& s = surface();
  std::string names;
  for (const IndexedMesh& mesh : meshes_) names += (names.empty() ? "" : ", ") + mesh.name;
  const std::string what = meshes_.size() == 1 ? " has " : " have together ";
  if (!s.all->faults().is_empty()) return names + what + faults_text(s.all->faults());
  return "the shells of " + names +
         (meshes_.size() == 1 ? " cancel each other there: doubled, or overlapping inside out"
                              : " cancel one another there: doubled, or overlapping inside out");
}

}  // namespace gouge
