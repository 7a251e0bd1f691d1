#include <gougecheck/mesh.h>

#include <algorithm>

#include "cli/library/content.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/check/scene_reach.h"
#include "lib/mesh/load_mesh.h"

namespace gougecheck {
namespace {

constexpr const char* kAdvice = "the coordinates and the unit";

[[noreturn]] void refuse_corner(const std::string& name, std::size_t face, std::uint32_t corner, std::size_t vertices) {
  raise(gouge::make_error("mesh-corner",
                          "face " + std::to_string(face) + " names vertex " + std::to_string(corner) +
                              "; expected 0 to " + std::to_string(vertices) + " - 1, one of the vertices given",
                          name));
}

gouge::TriangleSoup soup_of(std::span<const Vec3> vertices, std::span<const Triangle> faces, const std::string& name) {
  std::vector<gouge::TrianglePoints> triangles;
  triangles.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    gouge::TrianglePoints points;
    for (std::size_t k = 0; k < 3; ++k) {
      if (faces[i][k] >= vertices.size()) refuse_corner(name, i, faces[i][k], vertices.size());
      points[k] = to_vector(vertices[faces[i][k]]);
      if (!points[k].allFinite())
        raise(gouge::make_error("mesh-not-finite",
                                "vertex " + std::to_string(faces[i][k]) + " is not three finite numbers", name));
    }
    triangles.push_back(points);
  }
  gouge::TriangleSoup soup;
  soup.name = name;
  soup.triangles = gouge::TriangleList(std::move(triangles));
  return soup;
}

void require_mesh_reach(const gouge::IndexedMesh& mesh) {
  if (const auto error = gouge::find_too_far(mesh, "mesh", kAdvice)) raise(*error);
}

// Returns a mesh of mm as read in `unit`. Triangles that were left out are not visible in it, so their counts are copied.
std::shared_ptr<Mesh::Content> read_in(gouge::LengthUnit unit, const Mesh::Content& given) {
  gouge::IndexedMesh mesh = given.mesh();
  for (gouge::Vec3& vertex : mesh.vertices) vertex *= gouge::mm_per(unit);
  require_mesh_reach(mesh);
  gouge::MeshFindings findings = gouge::find_mesh_findings(mesh);
  findings.degenerate_triangles = given.findings.degenerate_triangles;
  findings.collinear_triangles = given.findings.collinear_triangles;
  findings.opposite_normals = given.findings.opposite_normals;
  auto content = std::make_shared<Mesh::Content>(std::move(mesh));
  content->notes = gouge::describe(findings, given.mesh().name);
  content->findings = std::move(findings);
  content->file = given.file;
  content->unit = unit;
  return content;
}

}  // namespace

Mesh::Mesh(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Mesh::Mesh(std::span<const Vec3> vertices, std::span<const Triangle> faces, std::string name) {
  gouge::BuiltMesh built = value_or_raise(gouge::build_mesh(soup_of(vertices, faces, name)));
  require_mesh_reach(built.mesh);
  gouge::MeshFindings findings = gouge::find_mesh_findings(built);
  auto content = std::make_shared<Content>(std::move(built.mesh));
  content->notes = gouge::describe(findings, name);
  content->findings = std::move(findings);
  content_ = std::move(content);
}

Mesh Mesh::read_stl(const std::string& file, const std::string& unit) {
  const auto known = unit.empty() ? gouge::LengthUnit::mm : gouge::unit_called(unit);
  if (!known) raise(gouge::make_error("usage", "unit '" + unit + "': expected um, mm, cm, m or inch", file));
  gouge::FileView view = value_or_raise(gouge::view_file(file, gouge::kMaxInputBytes));
  gouge::InputFile described = gouge::describe_input("", file, view.bytes);
  gouge::LoadedMesh loaded = value_or_raise(gouge::load_mesh_view(std::move(view), file, {*known, {}}));
  require_mesh_reach(loaded.mesh);
  auto content = std::make_shared<Content>(std::move(loaded.mesh));
  content->findings = std::move(loaded.findings);
  content->notes = std::move(loaded.notes);
  content->file = std::move(described);
  content->unit = *known;
  content->has_unknown_unit = unit.empty();
  return Mesh(std::move(content));
}

Mesh MeshAccess::in(const Mesh& mesh, gouge::LengthUnit unit) {
  const Mesh::Content& content = mesh.content();
  if (!content.has_unknown_unit || unit == gouge::LengthUnit::mm) return mesh;
  std::call_once(content.inch_once, [&] { content.in_inches = read_in(unit, content); });
  return Mesh(content.in_inches);
}

Scene scene_in(const Scene& scene, gouge::LengthUnit unit) {
  const Scene::Content& content = scene.content();
  if (!content.has_unknown_unit() || unit == gouge::LengthUnit::mm) return scene;
  std::call_once(content.inch_once, [&] {
    const auto taken = [unit](const std::vector<Mesh>& meshes) {
      std::vector<Mesh> all;
      for (const Mesh& mesh : meshes) all.push_back(MeshAccess::in(mesh, unit));
      return all;
    };
    const std::vector<Mesh> parts = taken(content.parts);
    const bool is_one_part = parts.size() == 1 && content.fixtures.empty();
    content.in_inches =
        is_one_part ? Scene(parts.front()) : Scene(parts, taken(content.fixtures), content.fixture_clearances);
  });
  return *content.in_inches;
}

std::span<const Vec3> Mesh::vertices() const {
  static_assert(sizeof(gouge::Vec3) == sizeof(Vec3) && alignof(gouge::Vec3) == alignof(Vec3));
  const auto& vertices = content_->mesh().vertices;
  return {reinterpret_cast<const Vec3*>(vertices.data()), vertices.size()};
}

std::span<const Triangle> Mesh::faces() const { return content_->mesh().triangles; }
std::span<const std::uint32_t> Mesh::given_face() const { return content_->mesh().file_triangle; }
const std::string& Mesh::name() const { return content_->mesh().name; }
bool Mesh::is_solid() const { return content_->findings.is_solid(); }
std::vector<Note> Mesh::notes() const { return to_notes(content_->notes); }

Scene::Scene(const Mesh& part) {
  const std::shared_ptr<const Mesh::Content> mesh = part.content_;
  auto content = std::make_shared<Content>();
  content->parts = {part};
  content->index = std::shared_ptr<const SceneIndex>(mesh, &mesh->index);
  content_ = std::move(content);
}

namespace {

std::vector<gouge::MeshLimit> limits_of(const std::vector<double>& clearances, std::size_t fixtures) {
  if (clearances.empty()) return {};
  if (clearances.size() != fixtures)
    raise(gouge::make_error("usage", "fixture_clearances: found " + std::to_string(clearances.size()) + " for " +
                                         std::to_string(fixtures) + " fixtures; expected one for each"));
  std::vector<gouge::MeshLimit> limits;
  for (std::size_t i = 0; i < fixtures; ++i) {
    if (!(clearances[i] >= 0) || !(clearances[i] <= gouge::kFarthest_mm))
      raise(gouge::make_error(
          "usage", "fixture_clearances[" + std::to_string(i) + "]: expected a length from 0 to 100 m, in mm"));
    if (clearances[i] > 0) limits.push_back({gouge::Against::fixture, i, clearances[i], 0});
  }
  return limits;
}

}  // namespace

Scene::Scene(std::vector<Mesh> parts, std::vector<Mesh> fixtures, std::vector<double> fixture_clearances) {
  gouge::Scene scene;
  scene.limits = limits_of(fixture_clearances, fixtures.size());
  for (const Mesh& part : parts) scene.parts.push_back(part.content().mesh());
  for (const Mesh& fixture : fixtures) scene.fixtures.push_back(fixture.content().mesh());
  if (parts.empty() && fixtures.empty())
    raise(gouge::make_error("usage", "a scene without meshes: expected at least one part or fixture"));
  auto content = std::make_shared<Content>();
  content->parts = std::move(parts);
  content->fixtures = std::move(fixtures);
  content->fixture_clearances = std::move(fixture_clearances);
  content->index = std::make_shared<const SceneIndex>(std::move(scene));
  content_ = std::move(content);
}

bool Scene::Content::has_unknown_unit() const {
  const auto is_unknown = [](const Mesh& mesh) { return mesh.content().has_unknown_unit; };
  return std::ranges::any_of(parts, is_unknown) || std::ranges::any_of(fixtures, is_unknown);
}

std::span<const double> Scene::fixture_clearances() const { return content_->fixture_clearances; }
std::span<const Mesh> Scene::parts() const { return content_->parts; }
std::span<const Mesh> Scene::fixtures() const { return content_->fixtures; }

}  // namespace gougecheck
