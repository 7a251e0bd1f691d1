#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"
#include "lib/base/result.h"
#include "lib/mesh/triangle_soup.h"

// Reads STL files. The content decides the format, not the file's name or its first word: many binary files begin with
// "solid".

namespace gouge {

/// Reads the triangles of an STL file, in file order and file units.
///
/// Binary   84 bytes, then 50 for each triangle. In a longer file the extra bytes may follow the last triangle (too few
///          for a triangle, or all zero). Or they follow each triangle as its attribute byte count states:
///          docs/formats/stl.md.
/// ASCII    Words in any case, any line ends, several solids in one file, any bytes in a solid's name, and `end solid`
///          for `endsolid`. The words `normal`, `outer`, `endloop` and `endfacet` may be missing. UTF-16 is read as
///          ASCII. A file that ends after a complete facet without `endsolid` is read with a warning.
/// Errors   (1) stl-empty, stl-no-triangles, stl-truncated, stl-trailing-data, stl-facet-bytes, stl-not-stl. (2)
///          stl-bad-number: a number is not finite, or in ASCII a word is not a number. (3) stl-syntax, in ASCII: a
///          word is missing or out of place. Each error has `name`; ASCII errors have the line.
/// Cost     O(bytes); for a longer binary file that of build_mesh and find_mesh_findings. ASCII takes long enough for
///          progress, which is counted in MB.
///
/// Binary triangles are read from `bytes` when needed, and not copied. The bytes must outlive the soup, unless `keep`
/// ensures that.
[[nodiscard]] Result<TriangleSoup> parse_stl(std::string_view bytes, const std::string& name,
                                             std::shared_ptr<const void> keep = nullptr,
                                             const ProgressCall& progress = {});
Result<TriangleSoup> parse_stl(std::string&& bytes, const std::string& name, std::shared_ptr<const void> keep = nullptr,
                               const ProgressCall& progress = {}) = delete;  ///< deleted: the string would not outlive
                                                                             ///< the soup

/// Returns whether a file of `size` bytes is STL, by its first bytes.
[[nodiscard]] bool looks_like_stl(std::string_view beginning, std::uint64_t size);

}  // namespace gouge
