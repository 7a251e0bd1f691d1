#include "lib/mesh/enclosure.h"

#include <algorithm>
#include <array>
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

}  // namespace

/// What is found out about the edges, once.
struct Enclosure::Surface {
  std::once_flag once, cavities_once;
  IndexedMesh welded;  // of several files
  const IndexedMesh* mesh = nullptr;
  EdgeFaults faults;
  std::optional<Cavities> cavities;

  void find(std::span<const IndexedMesh> meshes) {
    if (meshes.size() > 1) welded = weld_together(meshes);
    mesh = meshes.size() == 1 ? meshes.data() : &welded;
    faults = find_edge_faults(*mesh);
  }

  /// However the holes are closed, within what their width makes likely: the point is on the same side. Where there
  /// are only turned triangles nothing is to be closed.
  [[nodiscard]] bool is_clear_of_holes(const Vec3& point) const {
    const auto is_near = [&](const SurfaceGap& gap) {
      return gap.distance_mm(point) <= kReach * gap.width_mm + kMargin * (1 + point.cwiseAbs().maxCoeff());
    };
    return faults.open == 0 || std::none_of(faults.gaps.begin(), faults.gaps.end(), is_near);
  }

  /// With every gap filled by the triangles from its edges to its middle.
  [[nodiscard]] std::optional<long> filled_winding(const Vec3& point) const {
    double winding = winding_number(*mesh, point);
    for (const SurfaceGap& gap : faults.gaps) {
      const Vec3 apex = 0.5 * (gap.end_a + gap.end_b);
      double angle = 0;
      for (const FaultyEdge& e : gap.edges)
        angle += e.surplus * solid_angle(mesh->vertices[e.to], mesh->vertices[e.from], apex, point);
      winding += angle / (4 * std::numbers::pi);
    }
    const double whole = std::round(winding);
    if (!(std::abs(winding - whole) <= kWhole)) return std::nullopt;
    return static_cast<long>(whole);
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
  const Surface& s = surface();
  if (s.faults.open == 0) {
    if (has_free_ray(*s.mesh, joined.places, joined.directions)) return Side::outside;
    static const std::vector<Vec3> kFixed = fixed_directions();
    if (has_free_ray(*s.mesh, joined.places, kFixed)) return Side::outside;
  }
  for (const Vec3& place : joined.places) {
    if (!s.is_clear_of_holes(place)) continue;
    const std::optional<long> winding = s.filled_winding(place);
    if (!winding) continue;
    const bool is_odd = *winding % 2 != 0;
    // Where triangles were turned only whether the number is odd can be believed; a hole's rim alone does not say on
    // which side the material is unless the surface faces outward.
    if (s.faults.open > 0 ? *winding == 1 : is_odd || (s.faults.is_empty() && *winding != 0)) return Side::inside;
    if (!s.faults.is_empty() || *winding != 0) continue;
    std::call_once(surface_->cavities_once, [this] { surface_->cavities.emplace(*surface_->mesh); });
    if (s.cavities->contain(place)) return Side::outside;
  }
  return Side::unknown;
}

std::string Enclosure::why_unknown() const {
  const Surface& s = surface();
  std::string names;
  for (const IndexedMesh& mesh : meshes_) names += (names.empty() ? "" : ", ") + mesh.name;
  const std::string what = meshes_.size() == 1 ? " has " : " have together ";
  if (!s.faults.is_empty()) return names + what + faults_text(s.faults);
  return "the shells of " + names +
         (meshes_.size() == 1 ? " cancel each other there: doubled, or overlapping inside out"
                              : " cancel one another there: doubled, or overlapping inside out");
}

}  // namespace gouge
