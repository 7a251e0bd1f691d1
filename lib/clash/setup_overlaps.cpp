#include "lib/clash/setup_overlaps.h"

#include <algorithm>
#include <memory>

#include "lib/mesh/winding.h"

namespace gouge {
namespace {

/// Bodies by number, each indexed when it is first asked for.
class Bodies {
 public:
  explicit Bodies(std::span<const IndexedMesh> meshes) : meshes_(meshes), indexes_(meshes.size()) {
    for (const IndexedMesh& mesh : meshes) boxes_.push_back(mesh.box());
  }

  [[nodiscard]] const Box3& box(std::size_t i) const { return boxes_[i]; }

  [[nodiscard]] ClashBody body(std::size_t i) {
    if (!indexes_[i]) {
      DepthBodyOptions options;
      options.directions = *make_directions(DirectionFamily::cube, 6);
      options.is_distance_only = true;
      indexes_[i] = std::make_unique<DepthBody>(build_depth_body(meshes_[i], options));
    }
    return ClashBody(*indexes_[i]);
  }

 private:
  std::span<const IndexedMesh> meshes_;
  std::vector<Box3> boxes_;
  std::vector<std::unique_ptr<DepthBody>> indexes_;
};

/// Two bodies whose boxes have a slab of at most that thickness in common are nowhere deeper in each other: along the
/// slab's normal each point of it is that near to the end of either body.
bool may_be_deeper(const Box3& a, const Box3& b, double tolerance_mm) {
  return a.intersects(b) && a.intersection(b).sizes().minCoeff() > tolerance_mm;
}

void confirm(const ClashBody& part, const ClashBody& fixture, Clash& clash) {
  const bool is_confirmed = std::all_of(clash.deepest.begin(), clash.deepest.end(), [&](const Contact& contact) {
    const ClashBody& other = contact.body == 0 ? fixture : part;
    return is_inside({&other.surface().mesh, 1}, contact.point);
  });
  if (is_confirmed || clash.containment != Containment::none) return;
  clash.state = ClashState::not_certified;
  clash.reason = "one of the surfaces crosses itself, so what is inside is not defined";
}

}  // namespace

std::vector<SetupOverlap> find_setup_overlaps(std::span<const IndexedMesh> parts, std::span<const IndexedMesh> fixtures,
                                              const std::vector<bool>& is_left_out, const ClashOptions& options) {
  Bodies of_parts(parts), of_fixtures(fixtures);
  std::vector<SetupOverlap> found;
  for (std::size_t f = 0; f < fixtures.size(); ++f) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (is_left_out[f] || !may_be_deeper(of_parts.box(p), of_fixtures.box(f), options.tolerance_mm)) continue;
      const ClashBody part = of_parts.body(p), fixture = of_fixtures.body(f);
      Clash clash = find_clash(part, fixture, Vec3::Zero(), options);
      if (clash.state == ClashState::penetrating) confirm(part, fixture, clash);
      if (clash.state != ClashState::free && clash.state != ClashState::touching) found.push_back({f, p, clash});
    }
  }
  return found;
}

}  // namespace gouge
