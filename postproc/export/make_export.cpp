#include "postproc/export/make_export.h"

#include <set>

#include "lib/mesh/mesh_builder.h"
#include "lib/path/run_kind.h"
#include "postproc/image/event_scale.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/picture_scene.h"
#include "postproc/image/tool_outline.h"
#include "postproc/report/report_text.h"
#include "postproc/viewer/refine_surface.h"
#include "postproc/viewer/viewer_mesh.h"

namespace gouge {
namespace {

constexpr std::size_t kMaxStations = 200'000;  // maximum number of moves of the path that are kept
constexpr std::size_t kMaxPoints = 2000;       // maximum number of gouged points that guide the refinement
constexpr std::size_t kMaxFindings = 50;       // maximum number of findings whose tools are shown

/// Returns the meshes of which a surface consists, without values; some may be empty.
std::vector<ExportMesh> split(const ViewerMesh& mesh, std::size_t count) {
  std::vector<ExportMesh> out(count);
  std::vector<std::uint32_t> place(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    ExportMesh& its = out[mesh.mesh_of[v]];
    place[v] = static_cast<std::uint32_t>(its.positions.size());
    its.positions.push_back(mesh.positions[v]);
    its.normals.push_back(mesh.normals[v]);
  }
  for (const auto& t : mesh.triangles)
    out[mesh.mesh_of[t[0]]].triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
  return out;
}

class ExportMaker {
 public:
  ExportMaker(const ReportModel& model, const CheckedToolpath& input)
      : model_(model), input_(input), scene_(*input.prepared), scale_(surface_scale(model, input)) {}

  ExportScene run() {
    out_.unit = model_.toolpath->unit;
    add_surface();
    add_tools();
    add_path();
    return std::move(out_);
  }

 private:
  void add_surface() {
    ViewerMesh mesh = ViewerMesh::from(scene_);
    const PicturedPath path(input_);
    const SurfaceValues fields(path);
    std::vector<Vec3> points;
    for (const GougeWitness& gouge : gouge_witnesses(input_, kMaxPoints)) points.push_back(gouge.at);
    const VertexValues values = refine_surface(
        mesh,
        {{&fields, SurfaceQuantity::pictured}, {&fields, SurfaceQuantity::depth}, {&fields, SurfaceQuantity::overcut}},
        points, scene_.part_size_mm());
    const std::size_t parts = model_.parts.size();
    std::vector<ExportMesh> meshes = split(mesh, parts + model_.fixtures.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      ExportMesh& its = meshes[mesh.mesh_of[v]];
      const auto pictured = static_cast<double>(values[0][v]);
      its.colours.push_back(pictured > 0 ? scale_.at(pictured) : mesh.mesh_of[v] < parts ? kPartGrey : kFixtureGrey);
      its.depth_mm.push_back(values[1][v]);
      its.overcut_mm.push_back(values[2][v]);
    }
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      meshes[m].kind = m < parts ? ExportKind::part : ExportKind::fixture;
      meshes[m].name = m < parts ? model_.parts[m].name : model_.fixtures[m - parts].name;
      keep(std::move(meshes[m]));
    }
  }

  // Adds each tool once, at its worst finding.
  void add_tools() {
    std::set<std::size_t> shown;
    for (const PictureEvent& event : worst_events(input_, kMaxFindings)) {
      const std::size_t tool = event.event.tool;
      if (tool >= input_.tools.size() || input_.tools[tool] == nullptr || !shown.insert(tool).second) continue;
      if (shown.size() == 1 && !input_.heads.empty()) add_heads(event.heads);
      add_tool(tool_surface(input_.tools[tool]->bare, event.pose), tool_label(*model_.toolpath, tool));
    }
  }

  void add_heads(const RigidTransform& to_part) {
    const PictureScene heads(input_.heads, to_part);
    std::vector<std::string> names;
    for (const HeadBody& head : input_.heads) names.push_back(head.surface.mesh().name);
    add_plain(heads, ExportKind::head, names, std::vector<Body>(names.size(), Body::head));
  }

  void add_tool(const ToolSurface& tool, const std::string& label) {
    std::vector<HeadBody> bodies;
    std::vector<std::string> names;
    std::vector<Body> kinds;
    for (const Body body : {Body::cutter, Body::shank, Body::holder}) {
      TriangleSoup soup;
      for (std::size_t f = 0; f < tool.faces.size(); ++f) {
        const auto& [a, b, c] = tool.faces[f];
        if (tool.bodies[f] == body) soup.triangles.push_back({tool.vertices[a], tool.vertices[b], tool.vertices[c]});
      }
      if (soup.triangles.empty()) continue;
      Result<BuiltMesh> built = build_mesh(soup);
      if (!built) continue;
      const Surface surface(std::move(built->mesh));
      bodies.push_back({surface, surface, {}, {}, {}, {}, {}});
      names.push_back(label + " " + body_name(body));
      kinds.push_back(body);
    }
    if (!bodies.empty()) add_plain(PictureScene(bodies, RigidTransform{}), ExportKind::tool, names, kinds);
  }

  void add_plain(const PictureScene& scene, ExportKind kind, const std::vector<std::string>& names,
                 const std::vector<Body>& bodies) {
    std::vector<ExportMesh> meshes = split(ViewerMesh::from(scene), names.size());
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      meshes[m].kind = kind;
      meshes[m].name = names[m];
      meshes[m].depth_mm.assign(meshes[m].positions.size(), 0.0F);
      meshes[m].overcut_mm = meshes[m].depth_mm;
      meshes[m].colours.assign(meshes[m].positions.size(), body_colour(static_cast<int>(bodies[m])));
      keep(std::move(meshes[m]));
    }
  }

  void keep(ExportMesh mesh) {
    if (!mesh.triangles.empty()) out_.meshes.push_back(std::move(mesh));
  }

  void add_path() {
    const Station* last = nullptr;
    const std::vector<Station> stations = stations_of(input_, scene_.part_size_mm() / 2000, kMaxStations);
    bool is_open = false;  // the last line continues
    for (const Station& station : stations) {
      if (station.is_start || last == nullptr) {
        last = &station;
        is_open = false;
        continue;
      }
      const MoveState state = input_.result->verdicts[station.move].state;
      const bool is_rapid = runs_rapid(model_.toolpath->moves[station.move]);
      if (!is_open || out_.lines.back().state != state || out_.lines.back().is_rapid != is_rapid)
        out_.lines.push_back({state, is_rapid, {last->pose.tip}, {}});
      out_.lines.back().points.push_back(station.pose.tip);
      out_.lines.back().moves.push_back(station.move);
      is_open = true;
      last = &station;
    }
  }

  const ReportModel& model_;
  const CheckedToolpath& input_;
  PictureScene scene_;
  ColourScale scale_;
  ExportScene out_;
};

}  // namespace

ExportScene make_export(const ReportModel& model, const CheckedToolpath& input, const ProgressCall& progress) {
  if (progress) progress("measuring the surface for the export", 0, 1);
  return ExportMaker(model, input).run();
}

}  // namespace gouge
