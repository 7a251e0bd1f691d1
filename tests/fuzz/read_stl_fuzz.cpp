#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "lib/mesh/join_vertices.h"
#include "lib/mesh/load_mesh.h"
#include "lib/mesh/write_stl.h"
#include "tests/fuzz/require.h"

// STL of either kind: what was read is a mesh with sound indices and finite vertices, its findings agree with it,
// joining near vertices moves none farther than allowed, and what is written of a binary file in mm reads back as the
// same mesh.

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace gouge {
namespace {

using fuzz::require;

constexpr std::size_t kHeader = 80, kTriangle = 50;

void require_sound(const IndexedMesh& mesh, const MeshFindings& found) {
  require(!mesh.triangles.empty() && mesh.file_triangle.size() == mesh.triangles.size());
  require(std::adjacent_find(mesh.file_triangle.begin(), mesh.file_triangle.end(), std::greater_equal<>()) ==
          mesh.file_triangle.end());
  for (const TriangleCorners& corners : mesh.triangles)
    for (const Corner corner : corners) require(corner < mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) require(vertex.allFinite());
  require(found.triangles == mesh.triangles.size() && found.vertices == mesh.vertices.size());
  require(found.components >= 1 && found.components <= found.triangles);
  require(found.edges <= 3 * found.triangles && found.boundary_edges.count <= found.edges);
  require(found.boundary_edges.count <= found.unbalanced_edges.count);
  require(!found.is_solid() || found.is_closed());
  require(found.box_mm.min() == mesh.box().min() && found.box_mm.max() == mesh.box().max());
}

void require_joined(const IndexedMesh& mesh, double reach_mm) {
  const Result<JoinedMesh> joined = join_near_vertices(mesh, reach_mm);
  require(joined.has_value() || joined.error().code == "mesh-weld");
  if (!joined) return;
  require(joined->largest_shift_mm <= reach_mm);
  require_sound(joined->mesh, joined->findings);
  require(joined->mesh.vertices.size() <= mesh.vertices.size());
  require(joined->mesh.triangles.size() + joined->triangles_collapsed == mesh.triangles.size());
}

void require_written(const LoadedMesh& loaded, LengthUnit unit) {
  const std::string bytes = binary_stl_bytes(loaded.mesh, unit);
  require(bytes.size() == kHeader + 4 + kTriangle * loaded.mesh.triangles.size());
  const Result<LoadedMesh> again = load_mesh_bytes(bytes, "again", {unit, {}});
  if (loaded.format != StlFormat::binary || unit != LengthUnit::mm) return;
  require(again.has_value() && again->mesh.vertices == loaded.mesh.vertices &&
          again->mesh.triangles == loaded.mesh.triangles);
}

void read_and_write(std::string_view bytes) {
  constexpr std::array<LengthUnit, 3> kUnits = {LengthUnit::mm, LengthUnit::inch, LengthUnit::m};
  constexpr std::array<double, 4> kReaches_mm = {1e-9, 0.01, 1, 1e4};
  const LengthUnit unit = kUnits[bytes.size() % kUnits.size()];
  const Result<LoadedMesh> loaded = load_mesh_view({bytes, nullptr}, "fuzz", {unit, {}});
  require(loaded.has_value() || !loaded.error().code.empty());
  if (!loaded) return;
  require_sound(loaded->mesh, loaded->findings);
  for (const Diagnostic& note : loaded->notes) require(!note.code.empty() && !note.message.empty());
  require_joined(loaded->mesh, kReaches_mm[bytes.size() / kTriangle % kReaches_mm.size()]);
  require_written(*loaded, unit);
}

}  // namespace
}  // namespace gouge

// Mostly the count of a binary file is set right after a mutation, or none would ever get past it.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  using gouge::kHeader, gouge::kTriangle;
  size = LLVMFuzzerMutate(data, size, most);
  const bool is_text = size >= 5 && std::memcmp(data, "solid", 5) == 0 && seed % 2 == 0;
  if (is_text || seed % 8 == 1 || size < kHeader + 4 + kTriangle) return size;
  const auto count = static_cast<std::uint32_t>((size - kHeader - 4) / kTriangle);
  std::memcpy(data + kHeader, &count, sizeof count);
  return kHeader + 4 + kTriangle * count;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gouge::read_and_write({reinterpret_cast<const char*>(data), size});
  return 0;
}
