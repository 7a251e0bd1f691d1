#include "lib/verify/surface_proof.h"

#include <array>

#include "lib/geom/triangle.h"
#include "lib/verify/proof_time.h"
#include "lib/verify/separation.h"

namespace gouge {
namespace {

constexpr int kDeepest = 160;  // maximum number of nested cuts

/// A part of the surface: a node of several triangles, a triangle, or a part of a triangle.
struct Place {
  TriangleOrder::Node node;  // valid if it has two or more triangles
  std::array<Vec3, 3> corners{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  bool is_node = false;
};

Place place_of(const TriangleOrder& order, const TriangleOrder::Node& node) {
  Place place;
  place.is_node = node.size() > 1;
  place.node = node;
  if (!place.is_node) place.corners = order.corners(node.first);
  return place;
}

std::array<Place, 2> halves_of(const TriangleOrder& order, const Place& place) {
  if (place.is_node)
    return {place_of(order, {place.node.first, place.node.middle()}),
            place_of(order, {place.node.middle(), place.node.last})};
  std::array<Place, 2> both{place, place};
  const auto parts = halves(place.corners, longest_edge(place.corners));
  both[0].corners = parts[0];
  both[1].corners = parts[1];
  return both;
}

SurfacePatch patch_of(const TriangleOrder& order, const Place& place) {
  return place.is_node ? node_patch(order, place.node) : triangle_patch(place.corners);
}

class Finder {
 public:
  Finder(const ProofQuestion& question, std::uint64_t max_tries, std::string& steps)
      : question_(question),
        depth_mm_(question.depth_mm + 0.9 * kProofSlack_mm),  // the rest is a margin for different rounding on other
                                                              // machines
        separation_(question.tool, question.depth_mm + kProofSlack_mm),
        left_(max_tries),
        steps_(steps) {}

  bool prove(const Place& place, const ProofTime& time, int level) {
    if (left_ == 0 || level > kDeepest) return false;
    --left_;
    const SurfacePatch patch = patch_of(question_.surface, place);
    separation_.look_at(patch, time.span);
    if (const auto kind = kind_that_holds(place, patch, time)) {
      steps_.push_back(static_cast<char>(*kind));
      return true;
    }
    const double moves = time.span.path_mm + patch_reach(patch, time) * time.span.swing;
    const double by_time = separation_.time_loss_mm() + 0.1 * moves + vague(time),
                 by_patch = separation_.patch_loss_mm() + 0.2 * patch.radius_mm;
    constexpr double kNothing_mm = 1e-10;
    if (patch.radius_mm < kNothing_mm && moves + vague(time) < kNothing_mm) return false;
    if (by_time > by_patch) {
      steps_.push_back(kCutTime);
      return for_halves(time, [&](const ProofTime& half) { return prove(place, half, level + 1); });
    }
    steps_.push_back(kCutSurface);
    for (const Place& half : halves_of(question_.surface, place))
      if (!prove(half, time, level + 1)) return false;
    return true;
  }

 private:
  static double patch_reach(const SurfacePatch& patch, const ProofTime& time) {
    return (patch.center - time.span.middle.tip).norm() + patch.radius_mm;
  }
  // Returns the size of the box that contains the poses.
  static double vague(const ProofTime& time) {
    if (time.span.poses.size() > 1) return 0;
    double wide = 0;
    for (std::size_t k = 0; k < 3; ++k)
      wide = std::max(wide, time.span.poses[0].tip[k].sup() - time.span.poses[0].tip[k].inf());
    return wide;
  }

  std::optional<ProofKind> kind_that_holds(const Place& place, const SurfacePatch& patch, const ProofTime& time) {
    using enum ProofKind;
    const auto holds = [&](ProofKind kind) { return separation_.holds(kind, depth_mm_); };
    if (patch.into.squaredNorm() > 0 && holds(own_plane)) return own_plane;
    if (holds(center_plane)) return center_plane;
    if (place.is_node) return std::nullopt;
    if (holds(closest_plane)) return closest_plane;
    if (!question_.tool.is_stepped()) return std::nullopt;
    for (const ProofKind kind : {own_ring, center_ring, closest_ring})
      if (holds(kind)) return kind;
    if (patch.radius_mm + time.span.path_mm < depth_mm_ + 0.01 && holds(exit_point)) return exit_point;
    return std::nullopt;
  }

  const ProofQuestion& question_;
  double depth_mm_;
  Separation separation_;
  std::uint64_t left_;
  std::string& steps_;
};

class Follower {
 public:
  Follower(const ProofQuestion& question, std::string_view& steps, ProofFault& fault)
      : question_(question),
        separation_(question.tool, question.depth_mm + kProofSlack_mm),
        steps_(steps),
        fault_(fault) {}

  bool follow(const Place& place, const ProofTime& time, int level) {
    if (steps_.empty()) return fails(place, time, "the proof ends too early");
    const char step = steps_.front();
    steps_.remove_prefix(1);
    if (level > kDeepest) return fails(place, time, "the proof cuts too finely");
    if (step == kCutTime)
      return for_halves(time, [&](const ProofTime& half) { return follow(place, half, level + 1); });
    if (step == kCutSurface) {
      for (const Place& half : halves_of(question_.surface, place))
        if (!follow(half, time, level + 1)) return false;
      return true;
    }
    if (step < static_cast<char>(ProofKind::own_plane) || step > static_cast<char>(ProofKind::exit_point))
      return fails(place, time, "the proof has a step that is none");
    const SurfacePatch patch = patch_of(question_.surface, place);
    separation_.look_at(patch, time.span);
    return separation_.holds(static_cast<ProofKind>(step), question_.depth_mm + kProofSlack_mm) ||
           fails(place, time, "what the proof names does not keep the tool and the surface apart");
  }

 private:
  bool fails(const Place& place, const ProofTime& time, const char* what) {
    fault_ = {time.piece, patch_of(question_.surface, place).center, what};
    return false;
  }

  const ProofQuestion& question_;
  Separation separation_;
  std::string_view& steps_;
  ProofFault& fault_;
};

bool is_nothing(const ProofQuestion& question) { return question.tool.empty() || question.surface.root().size() == 0; }

}  // namespace

bool find_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces, std::uint64_t max_tries,
                std::string& steps) {
  if (is_nothing(question)) return true;
  const std::size_t before = steps.size();
  const ProofTime all(pieces.data(), pieces.data() + pieces.size(), 0);
  if (Finder(question, max_tries, steps).prove(place_of(question.surface, question.surface.root()), all, 0))
    return true;
  steps.resize(before);
  return false;
}

bool follow_proof(const ProofQuestion& question, std::span<const MotionPiece> pieces, std::string_view& steps,
                  ProofFault& fault) {
  if (is_nothing(question)) return true;
  const ProofTime all(pieces.data(), pieces.data() + pieces.size(), 0);
  return Follower(question, steps, fault).follow(place_of(question.surface, question.surface.root()), all, 0);
}

}  // namespace gouge
