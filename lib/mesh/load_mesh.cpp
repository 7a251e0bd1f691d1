#include "lib/mesh/load_mesh.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "lib/mesh/read_stl.h"

namespace gouge {
namespace {

/// A mesh, and the facts that only its file shows.
struct Welded {
  BuiltMesh built;
  StlFormat format = StlFormat::binary;
  Diagnostics notes;
};

// Releases the file when it returns, before the findings need memory.
Result<Welded> weld(FileView file, const std::string& name, const MeshPlacement& placement,
                    const ProgressCall& progress) {
  Result<TriangleSoup> soup = parse_stl(file.bytes, name, std::move(file.keep), progress);
  if (!soup) return soup.error();
  Result<BuiltMesh> built = build_mesh(*soup, placement, progress);
  if (!built) return built.error();
  return Welded{std::move(*built), soup->format, std::move(soup->notes)};
}

}  // namespace

Result<LoadedMesh> load_mesh_view(FileView file, const std::string& name, const MeshPlacement& placement,
                                  const ProgressCall& progress) {
  Result<Welded> welded = weld(std::move(file), name, placement, progress);
  if (!welded) return welded.error();
  LoadedMesh loaded;
  loaded.findings = find_mesh_findings(welded->built, progress);
  loaded.findings.may_be_cut_off =
      std::ranges::any_of(welded->notes, [](const Diagnostic& note) { return note.code == "stl-no-endsolid"; });
  loaded.mesh = std::move(welded->built.mesh);
  loaded.format = welded->format;
  loaded.notes = std::move(welded->notes);
  for (Diagnostic& reported : describe(loaded.findings, name, placement.unit))
    loaded.notes.push_back(std::move(reported));
  return loaded;
}

Result<LoadedMesh> load_mesh_bytes(std::string_view bytes, const std::string& name, const MeshPlacement& placement) {
  return load_mesh_view({bytes, nullptr}, name, placement);
}

Result<LoadedMesh> load_mesh(const std::string& path, const MeshPlacement& placement, std::uint64_t max_bytes,
                             const ProgressCall& progress) {
  Result<FileView> file = view_file(path, max_bytes);
  if (!file) return file.error();
  return load_mesh_view(std::move(*file), path, placement, progress);
}

}  // namespace gouge
