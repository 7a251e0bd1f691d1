#pragma once

#include <string>
#include <string_view>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/mesh/triangle_soup.h"

// The ASCII part of parse_stl. Callers outside this module use read_stl.h.

namespace gouge::detail {

/// Returns whether the bytes are intended as ASCII STL. Then the first word is `facet`. Or it is `solid`, and `facet`,
/// `solid` or `endsolid` follows the name; text without them is accepted too.
[[nodiscard]] bool looks_like_ascii_stl(std::string_view bytes);

/// Parses ASCII STL. Its errors and tolerance are described at parse_stl.
[[nodiscard]] Result<TriangleSoup> parse_ascii_stl(std::string_view bytes, const std::string& name,
                                                   const ProgressCall& progress = {});

/// Counts a stored normal that points to the other side of the triangle at `index`. Normals that are zero or not finite
/// are ignored, and so are triangles too thin to have a normal.
void count_normal(TriangleSoup& soup, std::size_t index, const TrianglePoints& triangle, const Vec3& stored_normal);

}  // namespace gouge::detail
