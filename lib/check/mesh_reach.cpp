#include "lib/check/mesh_reach.h"

#include <algorithm>

#include "lib/check/reach.h"

namespace gouge {

std::optional<Diagnostic> find_too_far(const IndexedMesh& mesh, const std::string& body, const std::string& advice) {
  if (std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_within_reach)) return std::nullopt;
  return make_error("mesh-too-far",
                    "reaches more than 100 m from the origin; expected a " + body + " within that; check " + advice,
                    mesh.name);
}

}  // namespace gouge
