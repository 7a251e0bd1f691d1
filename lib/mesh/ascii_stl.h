#pragma once

#include <string>
#include <string_view>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/mesh/triangle_soup.h"

// The ASCII half of parse_stl; callers outside this module use read_stl.h.

namespace gouge::detail {

/// Returns whether the bytes are meant as ASCII STL. The first word is then `facet`, or it is `solid` and `facet`,
/// `solid` or `endsolid` begins a later line or follows.
[[nodiscard]] bool looks_like_ascii_stl(std::string_view bytes);

/// Errors and tolerance as described at parse_stl.
[[nodiscard]] Result<TriangleSoup> parse_ascii_stl(std::string_view bytes, const std::string& name,
                                                   const ProgressCall& progress = {});

/// Counts a stored normal that points to the other side of its triangle, the one at `index`. Normals that are
/// zero or not finite state nothing, nor do triangles too thin to have a normal.
void count_normal(TriangleSoup& soup, std::size_t index, const TrianglePoints& triangle, const Vec3& stored_normal);

}  // namespace gouge::detail
