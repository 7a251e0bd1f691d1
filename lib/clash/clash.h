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
  double resolution_mm = 0.001;    ///< certified gap between the bounds of the depth
  double gap_mm = 0.001;           ///< gap between the bounds of the depth for bodies that penetrate
  std::uint64_t budget = 500'000;  ///< number of bounds for each of the two depths
};

enum class ClashState {
  free,           ///< proved: no point is in both bodies
  touching,       ///< proved: no point in both bodies is deeper than tolerance + resolution in either
  penetrating,    ///< a point in both bodies is deeper than the tolerance, or one body is inside the other
  not_certified,  ///< none of these could be proved
};

enum class Containment { none, a_in_b, b_in_a };

/// Result for two bodies that stand still. Lengths are in mm, in the coordinates of A.
struct Clash {
  ClashState state = ClashState::not_certified;
  Containment containment = Containment::none;  ///< set if the surfaces do not meet and one body is completely inside
                                                ///< the other
  ClosestPair closest;                          ///< closest points of the surfaces; if they meet, any pair nearer than
                                                ///< 1e-6
  /// Largest distance of a point in both bodies to the surface of one of them: depth <= true depth <= depth_upper. The
  /// upper bound is infinite if a surface bounds no solid.
  double depth_mm = 0, depth_upper_mm = 0;
  /// The deepest point of B in A (body 1) and that of A in B (body 0), the deeper first, if such points exist. Each has
  /// the direction in which B moves away.
  std::vector<Contact> deepest;
  std::string reason;  ///< reason for not_certified
  std::uint64_t bounds = 0;
};

/// Decides whether two bodies penetrate, and computes how deep. B is moved by `shift_b`.
///
/// Requires triangles in both.
/// Ensures  Free and touching are proved, even for bodies whose inside is not known. The result has the same bits on
///          every machine.
/// Source   docs/method/clash.md, with the proofs.
[[nodiscard]] Clash find_clash(const ClashBody& a, const ClashBody& b, const Vec3& shift_b,
                               const ClashOptions& options);

/// A fixture that penetrates a part, or may penetrate it.
struct SetupOverlap {
  std::size_t fixture = 0, part = 0;
  Clash clash;  ///< result for the part (A) and the fixture (B): penetrating or not certified
};

/// Tests every fixture of a scene against every part, in that order. `is_left_out` has one value for each fixture.
///
/// Requires scene.is_within_reach.
/// Cost  Nothing if the bounding boxes overlap by no more than the tolerance; otherwise the surfaces of the scene and a
///       search (body_depth.h).
[[nodiscard]] std::vector<SetupOverlap> find_setup_overlaps(const PreparedScene& scene,
                                                            const std::vector<bool>& is_left_out,
                                                            const ClashOptions& options);

}  // namespace gouge
