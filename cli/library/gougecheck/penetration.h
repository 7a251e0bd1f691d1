#pragma once

#include <optional>
#include <string>

#include <gougecheck/mesh.h>

namespace gougecheck {

enum class ClashState : std::uint8_t {
  free,           ///< proved: no point is in both bodies
  touching,       ///< proved: no point in both is deeper than tolerance + resolution in either
  penetrating,    ///< a point in both is deeper than the tolerance, or one body is inside the other
  not_certified,  ///< neither could be proved
};
/// Returns free, touching, penetrating or not-certified.
[[nodiscard]] GOUGECHECK_EXPORT const char* state_name(ClashState state);

struct PenetrationOptions {
  double tolerance = 0.01;    ///< depth that counts as touching
  double resolution = 0.001;  ///< certified gap
  bool find_shift = false;    ///< look for a shift of B that frees it
};

/// Two bodies that stand still; coordinates of A.
struct Penetration {
  ClashState state = ClashState::not_certified;
  /// Largest distance of a point in both bodies to the surface of one of them; positive inside. Always depth <= true
  /// depth <= depth_upper. The latter is infinite where a surface bounds no solid.
  double depth = 0, depth_upper = 0;
  double distance = 0;                                ///< of the surfaces; 0 where they meet
  Vec3 point_a = {0, 0, 0};                           ///< the closest points of both surfaces
  Vec3 point_b = {0, 0, 0};                           ///<
  std::optional<Vec3> deepest;                        ///< a point of the one that is `depth` deep in the other
  std::optional<Vec3> normal;                         ///< unit; the direction in which B moves away from there
  std::optional<Vec3> shift;                          ///< where requested: takes B out of A, which was proved there
  bool a_is_inside_b = false, b_is_inside_a = false;  ///< wholly, without surfaces that meet
  std::string reason;                                 ///< of not_certified
};

/// Returns whether two bodies penetrate and how deep, B placed by `pose_b`.
/// Ensures  Free and touching are proved, for bodies whose inside is not known as well.
/// Throws   Error: a rotation that is none, a number that is none, a body beyond 100 m.
[[nodiscard]] GOUGECHECK_EXPORT Penetration penetration(const Mesh& a, const Mesh& b, const Transform& pose_b = {},
                                                        const PenetrationOptions& options = {});

}  // namespace gougecheck
