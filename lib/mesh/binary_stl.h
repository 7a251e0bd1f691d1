#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/result.h"
#include "lib/mesh/triangle_soup.h"

// The binary part of parse_stl. Callers outside this module use read_stl.h.

namespace gouge::detail {

/// Returns whether the file is long enough for the header and the number of facets.
[[nodiscard]] bool has_binary_stl_header(std::string_view bytes);

/// Returns whether the file has exactly the size that its header states: 84 bytes and 50 for each facet.
[[nodiscard]] bool has_binary_stl_size(std::string_view beginning, std::uint64_t size);

/// Returns the triangles of a binary STL. A file that is longer than its header states is read if the places of its
/// facets are certain. The extra bytes may follow the last facet, or each facet as its attribute byte count states. The
/// first reading is certain if no attribute is set and the bytes are too few for one after each facet. Otherwise
/// exactly one of the two readings must be confirmed: each of its edges has a partner, or its stored normals match its
/// corners.
///
/// Requires has_binary_stl_header.
/// Errors   stl-no-triangles, stl-truncated, stl-trailing-data, stl-facet-bytes, stl-bad-number.
/// Cost     O(bytes); if a reading must be confirmed, that of build_mesh and find_mesh_findings twice.
[[nodiscard]] Result<TriangleSoup> parse_binary_stl(std::string_view bytes, const std::string& name,
                                                    std::shared_ptr<const void> keep);

}  // namespace gouge::detail
