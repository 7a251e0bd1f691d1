#include <algorithm>

#include <gougecheck/mesh.h>
#include <gougecheck/path.h>
#include <gougecheck/tool.h>

#include "cli/library/content.h"
#include "cli/library/saved.h"
#include "lib/mesh/mesh_findings.h"

namespace gougecheck {
namespace {

constexpr const char* kMeshKind = "Mesh";
constexpr const char* kPathKind = "Path";
constexpr const char* kLibraryKind = "ToolLibrary";

Fields fields_of(const gouge::MeshSpot& spot) {
  const gouge::Vec3& at = spot.position_mm;
  return {spot.count, at.x(), at.y(), at.z(), spot.file_triangle};
}

gouge::MeshSpot spot_in(const Fields& fields) {
  const auto number = [&](std::size_t at) { return fields.at(at).get<double>(); };
  return {fields.at(0), gouge::Vec3(number(1), number(2), number(3)), fields.at(4)};
}

Fields fields_of(const gouge::InputFile& file) { return {file.role, file.name, file.bytes, file.checksum}; }

gouge::InputFile file_in(const Fields& fields) { return {fields.at(0), fields.at(1), fields.at(2), fields.at(3)}; }

gouge::IndexedMesh mesh_in(const Fields& fields) {
  gouge::IndexedMesh mesh;
  mesh.name = fields.at("name");
  take_rows(kMeshKind, fields.at("vertices"), mesh.vertices);
  take_rows(kMeshKind, fields.at("faces"), mesh.triangles);
  take_rows(kMeshKind, fields.at("given_face"), mesh.file_triangle);
  const auto is_within = [&](const Triangle& corners) {
    return std::ranges::all_of(corners, [&](std::uint32_t corner) { return corner < mesh.vertices.size(); });
  };
  if (mesh.triangles.empty() || mesh.file_triangle.size() != mesh.triangles.size() ||
      !std::ranges::all_of(mesh.triangles, is_within))
    refuse_bytes(kMeshKind);
  return mesh;
}

Path path_in(const Fields& fields) {
  if (fields.contains("text")) {
    const ReadFacts facts{fields.at("unit"), fields.at("cutcom")};
    return Path::from_text(text_in(fields["text"]), fields.at("name"), facts);
  }
  std::vector<Vec3> tips, axes;
  std::vector<MoveKind> kinds;
  take_rows(kPathKind, fields.at("tips"), tips);
  take_rows(kPathKind, fields.at("axes"), axes);
  take_rows(kPathKind, fields.at("kinds"), kinds);
  const std::unique_ptr<bool[]> rapids(new bool[kinds.size()]);
  std::ranges::transform(kinds, rapids.get(), [](MoveKind kind) { return kind == MoveKind::rapid; });
  return Path(tips, axes, {rapids.get(), kinds.size()}, fields.at("name"));
}

}  // namespace

std::string Mesh::to_bytes() const {
  const gouge::MeshFindings& findings = content_->findings;
  return pack(kMeshKind, {{"name", name()},
                          {"vertices", packed_rows(vertices())},
                          {"faces", packed_rows(faces())},
                          {"given_face", packed_rows(given_face())},
                          {"file", fields_of(content_->file)},
                          {"unit", static_cast<int>(content_->unit)},
                          {"has_unknown_unit", content_->has_unknown_unit},
                          {"notes", gougecheck::fields_of(content_->notes)},
                          {"may_be_cut_off", findings.may_be_cut_off},
                          {"degenerate", fields_of(findings.degenerate_triangles)},
                          {"collinear", fields_of(findings.collinear_triangles)},
                          {"opposite_normals", fields_of(findings.opposite_normals)}});
}

Mesh Mesh::from_bytes(std::string_view bytes) {
  return unpacked(kMeshKind, bytes, [](const Fields& fields) {
    auto content = std::make_shared<Content>(mesh_in(fields));
    content->findings = gouge::find_mesh_findings(content->mesh());
    content->findings.may_be_cut_off = fields.at("may_be_cut_off");
    content->findings.degenerate_triangles = spot_in(fields.at("degenerate"));
    content->findings.collinear_triangles = spot_in(fields.at("collinear"));
    content->findings.opposite_normals = spot_in(fields.at("opposite_normals"));
    content->notes = diagnostics_in(fields.at("notes"));
    content->file = file_in(fields.at("file"));
    content->unit = static_cast<gouge::LengthUnit>(fields.at("unit").get<int>());
    content->has_unknown_unit = fields.at("has_unknown_unit");
    return Mesh(std::move(content));
  });
}

std::string Path::to_bytes() const {
  if (content_->is_from_memory)
    return pack(kPathKind, {{"name", name()},
                            {"tips", packed_rows(tips())},
                            {"axes", packed_rows(axes())},
                            {"kinds", packed_rows(kinds())}});
  if (const std::optional<ReadFacts>& facts = content_->facts)
    return pack(kPathKind,
                {{"name", name()}, {"text", packed_bytes(text())}, {"unit", facts->unit}, {"cutcom", facts->cutcom}});
  raise(gouge::make_error(
      "path-not-saved",
      "a path of a control's program or of a correction depends on more than its text; pass a program by the name of its "
      "file and read it there, and a corrected path by its text, for Path.from_text",
      name()));
}

Path Path::from_bytes(std::string_view bytes) { return unpacked(kPathKind, bytes, path_in); }

std::string ToolLibrary::to_bytes() const {
  const gouge::ToolLibrary& library = content_->library;
  Fields files = Fields::array();
  for (const gouge::InputFile& file : content_->files) files.push_back(fields_of(file));
  return pack(kLibraryKind, {{"name", library.file},
                             {"json", to_json()},
                             {"files", std::move(files)},
                             {"is_by_facts", content_->is_by_facts},
                             {"notes", gougecheck::fields_of(library.notes)},
                             {"shared_numbers", library.shared_numbers},
                             {"shared_names", library.shared_names}});
}

ToolLibrary ToolLibrary::from_bytes(std::string_view bytes) {
  return unpacked(kLibraryKind, bytes, [](const Fields& fields) {
    Content content = from_json(fields.at("json").get<std::string>(), fields.at("name")).content();
    for (const Fields& file : fields.at("files")) content.files.push_back(file_in(file));
    content.is_by_facts = fields.at("is_by_facts");
    content.library.notes = diagnostics_in(fields.at("notes"));
    content.library.shared_numbers = fields.at("shared_numbers").get<std::vector<int>>();
    content.library.shared_names = fields.at("shared_names").get<std::vector<std::string>>();
    return ToolLibrary(std::make_shared<const Content>(std::move(content)));
  });
}

}  // namespace gougecheck
