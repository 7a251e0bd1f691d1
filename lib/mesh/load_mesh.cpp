#include "lib/mesh/load_mesh.h"

#include <utility>

#include "lib/base/view_file.h"
#include "lib/mesh/read_stl.h"

namespace gouge {

Result<LoadedMesh> load_mesh_bytes(std::string_view bytes, const std::string& name,
                                   const MeshPlacement& placement) {
  const Result<TriangleSoup> soup = parse_stl(bytes, name);
  if (!soup) return soup.error();
  Result<BuiltMesh> built = build_mesh(*soup, placement);
  if (!built) return built.error();
  LoadedMesh loaded;
  loaded.findings = find_mesh_findings(*built);
  loaded.mesh = std::move(built->mesh);
  loaded.format = soup->format;
  loaded.notes = soup->notes;
  for (Diagnostic& told : describe(loaded.findings, name, placement.unit))
    loaded.notes.push_back(std::move(told));
  return loaded;
}

Result<LoadedMesh> load_mesh(const std::string& path, const MeshPlacement& placement) {
  const Result<FileView> file = view_file(path);
  if (!file) return file.error();
  return load_mesh_bytes(file->bytes, path, placement);
}

}  // namespace gouge
