#pragma once

#include <optional>
#include <string>

#include <gougecheck/mesh.h>

namespace gougecheck {

enum class ClashState : std::uint8_t {
  free,           ///< proved: no point is in both bodies
  touching,       ///< proved: no point in both is deeper than tolerance + resolution in either
  penetrating,    ///< a point in both is deeper than the tolerance, or one body is inside the other
  not_certified,  ///< neither of these could be proved
};
/// Returns free, touching, penetrating or not-certified.
[[nodiscard]] GOUGECHECK_EXPORT const char* state_name(ClashState state);

struct PenetrationOptions {
  double tolerance = 0.01;    ///< maximum depth of bodies that count as touching
  double resolution = 0.001;  ///< gap between the certified bounds of a depth
  bool find_shift = false;    ///< whether to search for a shift of B that frees it
};

/// Penetration of two bodies that stand still, in the coordinates of A.
struct Penetration {
  ClashState state = ClashState::not_certified;
  /// Largest distance of a point in both bodies to the surface of one of them; positive inside. Always depth <= true
  /// depth <= depth_upper. depth_upper is infinite if a surface bounds no solid.
  double depth = 0, depth_upper = 0;
  double distance = 0;                                ///< of the surfaces; 0 if they meet
  Vec3 point_a = {0, 0, 0};                           ///< the closest points of both surfaces
  Vec3 point_b = {0, 0, 0};                           ///<
  std::optional<Vec3> deepest;                        ///< a point of one body that is `depth` deep in the other
  std::optional<Vec3> normal;                         ///< unit; the direction in which B moves away from that point
  std::optional<Vec3> shift;                          ///< if requested: a shift that is proved to free B
  bool a_is_inside_b = false, b_is_inside_a = false;  ///< wholly inside, without surfaces that meet
  std::string reason;                                 ///< reason of not_certified
};

/// Returns whether two bodies penetrate and how deep; `pose_b` places B.
/// Ensures  Free and touching are proved, also for bodies whose inside is unknown.
/// Throws   Error: a matrix that is not a rotation, a value that is not a number, a body beyond 100 m.
[[nodiscard]] GOUGECHECK_EXPORT Penetration penetration(const Mesh& a, const Mesh& b, const Transform& pose_b = {},
                                                        const PenetrationOptions& options = {});

}  // namespace gougecheck
