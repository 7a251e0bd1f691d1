#pragma once

#include <optional>
#include <span>

#include "lib/check/scene.h"
#include "lib/geom/pose.h"
#include "lib/head/head_body.h"

// Finds the head of a finding, because a verdict names only the body "head".

namespace gouge {

/// Returns the head in which `point_tool`, in the tool's frame, is deepest, or to which it is closest. Requires at
/// least one head.
[[nodiscard]] std::size_t deepest_head(std::span<const HeadBody> heads, const Vec3& point_tool);

/// A core of a head that is inside a solid of the scene.
struct BuriedCore {
  std::size_t head = 0;
  Vec3 at = Vec3::Zero();  ///< the core, in part coordinates
};

/// Returns the first core of a head that is inside a solid; none if there is none. The heads are placed by `to_part`
/// from the tool's frame. On surfaces that are not closed the result is only a hint (is_inside of
/// lib/mesh/opposite_half_edges.h).
/// Cost  O(triangles) for each core within a mesh's box.
[[nodiscard]] std::optional<BuriedCore> find_buried_core(std::span<const HeadBody> heads, const RigidTransform& to_part,
                                                         const Scene& scene);

}  // namespace gouge
