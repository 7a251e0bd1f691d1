#include "lib/clash/clash.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "lib/base/tolerance.h"
#include "lib/clash/body_depth.h"
#include "lib/mesh/enclosure.h"
#include "lib/mesh/union_find.h"

namespace gouge {

namespace {

// Upper bound of the depth if it is unknown.
constexpr double kUnknown_mm = std::numeric_limits<double>::infinity();

constexpr std::uint32_t kOfA = 0, kOfB = 1;

/// Returns one vertex of each connected piece of a surface.
std::vector<Vec3> points_of_pieces(const IndexedMesh& mesh) {
  UnionFind pieces(mesh.vertices.size());
  std::vector<bool> is_used(mesh.vertices.size(), false);
  for (const TriangleCorners& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      pieces.join(t[0], t[k]);
      is_used[t[k]] = true;
    }
  }
  std::vector<Vec3> points;
  for (Corner v = 0; v < mesh.vertices.size(); ++v) {
    if (is_used[v] && pieces.root(v) == v) points.push_back(mesh.vertices[v]);
  }
  return points;
}

struct PieceCounts {
  std::size_t inside = 0, outside = 0, unknown = 0;
  std::string why;  ///< reason for the first unknown piece
};

/// Counts on which side of a body the pieces of another surface lie. Requires that the pieces do not meet the body's
/// boundary. A point inside the boundary is inside, even on a shell that lies there.
PieceCounts sides_of(const IndexedMesh& pieces, const Vec3& shift, const ClashBody& body) {
  const Enclosure enclosure(std::span(&body.whole().mesh(), 1));
  const auto side_of = [&](const Vec3& at) {
    if (enclosure.is_beyond(at)) return Side::outside;
    if (body.is_solid() && body.closest_point(at).is_inside) return Side::inside;
    return enclosure.side_of({{at}, {}});
  };
  PieceCounts counts;
  for (const Vec3& point : points_of_pieces(pieces)) {
    const Side side = side_of(point + shift);
    ++(side == Side::inside ? counts.inside : side == Side::outside ? counts.outside : counts.unknown);
    if (side == Side::unknown && counts.why.empty()) counts.why = enclosure.why_unknown();
  }
  return counts;
}

class Finder {
 public:
  Finder(const ClashBody& a, const ClashBody& b, const Vec3& shift_b, const ClashOptions& options)
      : a_(a),
        b_(b),
        shift_b_(shift_b),
        options_(options),
        is_near_(a.whole().mesh().box().intersects(b.whole().mesh().box().translated(shift_b))) {}

  Clash run() {
    clash_.closest = surface_distance(surface_of(a_), surface_of(b_), shift_b_, Tolerance::kWitness_mm);
    // Surfaces within kWitness_mm count as meeting: the side of a point that near to a surface is not determined.
    if (clash_.closest.distance_mm > Tolerance::kWitness_mm) {
      decide_apart();
    } else {
      measure();
      decide_by_depth();
    }
    return clash_;
  }

 private:
  /// Returns the surface to examine. If the boxes are apart, the bodies are apart too, whatever lies inside them; then
  /// the whole surface is enough.
  [[nodiscard]] const Surface& surface_of(const ClashBody& body) const {
    return is_near_ ? body.boundary() : body.whole();
  }

  /// Decides for surfaces that do not meet: each piece of one is completely on one side of the other.
  void decide_apart() {
    const PieceCounts of_a = sides_of(surface_of(a_).mesh(), -shift_b_, b_);
    const PieceCounts of_b = sides_of(surface_of(b_).mesh(), shift_b_, a_);
    if (of_a.inside + of_b.inside > 0) {
      if (of_b.inside == 0 && of_a.outside + of_a.unknown == 0) clash_.containment = Containment::a_in_b;
      if (of_a.inside == 0 && of_b.outside + of_b.unknown == 0) clash_.containment = Containment::b_in_a;
      measure();
      clash_.state = ClashState::penetrating;
    } else if (of_a.unknown + of_b.unknown > 0) {
      clash_.reason = of_a.unknown > 0 ? of_a.why : of_b.why;
      clash_.depth_upper_mm = kUnknown_mm;
    } else {
      clash_.state = ClashState::free;
    }
  }

  void decide_by_depth() {
    if (clash_.depth_mm > options_.tolerance_mm) {
      clash_.state = ClashState::penetrating;
    } else if (clash_.depth_upper_mm <= options_.tolerance_mm + options_.resolution_mm) {
      clash_.state = ClashState::touching;
    } else if (!(clash_.depth_upper_mm < kUnknown_mm)) {
      clash_.reason = "the surfaces meet, and " + no_solid() +
                      " bounds no solid (it is open, inside out or doubled), so nothing says what is inside";
    } else {
      clash_.reason = "the surfaces lie on each other at too many points: the budget of bounds ran out";
    }
  }

  [[nodiscard]] std::string no_solid() const { return (a_.is_solid() ? b_ : a_).whole().mesh().name; }

  void measure() {
    const bool is_bounded = a_.is_solid() && b_.is_solid();
    if (b_.is_solid()) take(find_body_depth(a_, b_, -shift_b_, goal()), kOfA);
    if (a_.is_solid()) take(find_body_depth(b_, a_, shift_b_, goal()), kOfB);
    if (!is_bounded) clash_.depth_upper_mm = kUnknown_mm;
  }

  [[nodiscard]] SearchGoal goal() const {
    return {options_.tolerance_mm, options_.resolution_mm, options_.gap_mm, options_.budget};
  }

  void take(const BodyDepth& found, std::uint32_t body) {
    clash_.bounds += found.bounds;
    clash_.depth_upper_mm = std::max(clash_.depth_upper_mm, found.depth_upper_mm);
    clash_.depth_mm = std::max(clash_.depth_mm, found.depth_mm);
    if (!(found.depth_mm > 0)) return;
    const ClashBody& other = body == kOfA ? b_ : a_;
    Contact contact{found.point, found.normal, found.depth_mm, body,
                    other.boundary().mesh().file_triangle[found.triangle]};
    if (body == kOfA) {
      contact.point += shift_b_;
      contact.normal = -contact.normal;
    }
    const bool is_deeper = !clash_.deepest.empty() && contact.depth_mm > clash_.deepest.front().depth_mm;
    clash_.deepest.insert(is_deeper ? clash_.deepest.begin() : clash_.deepest.end(), contact);
  }

  const ClashBody& a_;
  const ClashBody& b_;
  Vec3 shift_b_;
  const ClashOptions& options_;
  bool is_near_;
  Clash clash_;
};

}  // namespace

Clash find_clash(const ClashBody& a, const ClashBody& b, const Vec3& shift_b, const ClashOptions& options) {
  return Finder(a, b, shift_b, options).run();
}

namespace {

std::vector<Box3> boxes_of(std::span<const IndexedMesh> meshes) {
  std::vector<Box3> boxes;
  for (const IndexedMesh& mesh : meshes) boxes.push_back(mesh.box());
  return boxes;
}

/// Returns whether two bodies may be deeper in each other than the tolerance. They are not if their boxes share a slab
/// that is at most that thick. Each point of the slab is that near to an end of both bodies, along the slab's normal.
bool may_be_deeper(const Box3& a, const Box3& b, double tolerance_mm) {
  return a.intersects(b) && a.intersection(b).sizes().minCoeff() > tolerance_mm;
}

void add_overlaps(const PreparedObstacle& workpiece, const PreparedObstacle& other,
                  const std::vector<bool>& is_left_out, const ClashOptions& options, std::vector<SetupOverlap>& found) {
  const std::vector<Box3> parts = boxes_of(workpiece.meshes), others = boxes_of(other.meshes);
  for (std::size_t f = 0; f < others.size(); ++f) {
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (is_left_out[f] || !may_be_deeper(parts[p], others[f], options.tolerance_mm)) continue;
      Clash clash = find_clash(ClashBody(workpiece.surfaces[p]), ClashBody(other.surfaces[f]), Vec3::Zero(), options);
      if (clash.state != ClashState::free && clash.state != ClashState::touching)
        found.push_back({f, p, std::move(clash)});
    }
  }
}

}  // namespace

std::vector<SetupOverlap> find_setup_overlaps(const PreparedScene& scene, const std::vector<bool>& is_left_out,
                                              const ClashOptions& options) {
  std::vector<SetupOverlap> found;
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    if (!obstacle.rule.is_workpiece) add_overlaps(scene.workpiece(), obstacle, is_left_out, options, found);
  }
  return found;
}

}  // namespace gouge
