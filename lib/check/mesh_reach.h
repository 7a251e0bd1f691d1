#pragma once

#include <optional>
#include <string>

#include "lib/base/diagnostic.h"
#include "lib/mesh/indexed_mesh.h"

namespace gouge {

/// The error for a mesh with a vertex beyond kFarthest_mm (reach.h) or that is no number, or nothing. `body`, such as
/// "part", and `advice`, what to look at, are words of the message. Code: mesh-too-far.
[[nodiscard]] std::optional<Diagnostic> find_too_far(const IndexedMesh& mesh, const std::string& body,
                                                     const std::string& advice);

}  // namespace gouge
