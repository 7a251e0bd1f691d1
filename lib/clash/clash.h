#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/clash/clash_body.h"
#include "lib/clash/surface_distance.h"
#include "lib/penetration/contact.h"

namespace gouge {

struct ClashOptions {
  double tolerance_mm = 0.01;      ///< depth that counts as touching
  double resolution_mm = 0.001;    ///< certified gap
  double gap_mm = 0.001;           ///< of the depth of bodies that penetrate
  std::uint64_t budget = 500'000;  ///< bounds for each of the two depths
};

enum class ClashState {
  free,           ///< proved: no point is in both bodies
  touching,       ///< proved: no point in both is deeper than tolerance + resolution in either
  penetrating,    ///< a point in both is deeper than the tolerance, or one body is inside the other
  not_certified,  ///< neither could be proved
};

enum class Containment { none, a_in_b, b_in_a };

/// Two bodies that stand still. Lengths in mm, coordinates of A.
struct Clash {
  ClashState state = ClashState::not_certified;
  Containment containment = Containment::none;  ///< of whole bodies whose surfaces do not meet
  ClosestPair closest;                          ///< of the surfaces; where they meet any pair nearer than 1e-6
  /// Largest distance of a point in both bodies to the surface of one of them: depth <= true depth <=
  /// depth_upper. The upper bound is infinite where a surface bounds no solid.
  double depth_mm = 0, depth_upper_mm = 0;
  /// The deepest point of B in A (body 1) and of A in B (body 0), the deeper first, where such points exist. Each has
  /// the direction in which B moves away.
  std::vector<Contact> deepest;
  std::string reason;  ///< of not_certified
  std::uint64_t bounds = 0;
};

/// Returns whether two bodies penetrate and how deep, B moved by `shift_b`.
///
/// Requires triangles in both.
/// Ensures  Free and touching are proved, for bodies whose inside is not known as well; the same bits on
/// every machine.
/// Source   docs/method/clash.md, with the proofs.
[[nodiscard]] Clash find_clash(const ClashBody& a, const ClashBody& b, const Vec3& shift_b,
                               const ClashOptions& options);

/// A fixture that penetrates a part, or that may.
struct SetupOverlap {
  std::size_t fixture = 0, part = 0;
  Clash clash;  ///< of the part (A) and the fixture (B): penetrating or not certified
};

/// Tests every fixture of a scene against every part, in that order. The list `is_left_out` is by fixture.
///
/// Requires scene.is_within_reach.
/// Cost  Nothing for bodies whose bounding boxes have no more than the tolerance in common; else the surfaces of the
///       scene and a search (body_depth.h).
[[nodiscard]] std::vector<SetupOverlap> find_setup_overlaps(const PreparedScene& scene,
                                                            const std::vector<bool>& is_left_out,
                                                            const ClashOptions& options);

}  // namespace gouge
