#include "postproc/viewer/write_viewer.h"

#include <algorithm>
#include <cmath>

#include "lib/base/printable_text.h"
#include "lib/mesh/union_find.h"
#include "lib/motion/motion_law.h"
#include "lib/surface/surface.h"
#include "postproc/image/event_scale.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/tool_outline.h"
#include "postproc/report/further_text.h"
#include "postproc/report/html_table.h"
#include "postproc/report/report_text.h"
#include "postproc/viewer/scene_writer.h"
#include "postproc/viewer/viewer_sources.h"

namespace gouge {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxStations = 200'000;  // maximum number of moves of a path that are shown
constexpr std::size_t kMaxPoints = 2000;       // maximum number of gouged points that guide the refinement

constexpr Colour kStockColour{226, 160, 60};

Json colour_json(const Colour& c) { return {c.r, c.g, c.b}; }

Json scale_json(const ColourScale& scale, LengthUnit unit, const std::string& title) {
  Json ticks = Json::array(), ramp = Json::array();
  for (const Tick& tick : make_ticks(scale, unit, 0.12)) ticks.push_back({scale.place(tick.depth_mm), tick.text});
  for (int k = 0; k <= 32; ++k) ramp.push_back(colour_json(scale.at(scale.depth_at(k / 32.0))));
  return {{"title", title},
          {"low", scale.low_mm},
          {"high", scale.high_mm},
          {"root", scale.is_root},
          {"start", scale.place(scale.low_mm)},
          {"ramp", ramp},
          {"ticks", ticks}};
}

Json tools_json(const ReportModel& model, const CheckedToolpath& input) {
  Json out = Json::array();
  for (std::size_t i = 0; i < input.tools.size(); ++i) {
    Json runs = Json::array();
    if (input.tools[i] != nullptr) {
      for (const OutlineRun& run : tool_outline(input.tools[i]->bare)) {
        Json points = Json::array();
        for (const Vec2& p : run.points)
          points.insert(points.end(), {std::round(p.x() * 1e5) / 1e5, std::round(p.y() * 1e5) / 1e5});
        runs.push_back({{"body", static_cast<int>(run.body)}, {"points", points}});
      }
    }
    out.push_back({{"label", valid_utf8(tool_label(*model.toolpath, i))}, {"runs", runs}});
  }
  return out;
}

/// Leaves out sharp edges that form no long line: where the surface passes near a corner of a cell, small triangles bend.
void drop_short_lines(ViewerMesh& mesh) {
  constexpr std::size_t kMinEdges = 24;
  UnionFind lines(mesh.positions.size());
  for (const auto& edge : mesh.edges) lines.join(edge[0], edge[1]);
  std::vector<std::size_t> counts(mesh.positions.size(), 0);
  for (const auto& edge : mesh.edges) ++counts[lines.root(edge[0])];
  std::erase_if(mesh.edges, [&](const auto& edge) { return counts[lines.root(edge[0])] < kMinEdges; });
}

Json vector_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

class ViewerWriter {
 public:
  static constexpr std::size_t kSteps = 4;  // the surface, its gouges, all other data, and the text

  ViewerWriter(const ReportScene& shown, const ProgressCall& progress)
      : model_(shown.model),
        input_(shown.path.input),
        progress_(progress),
        scene_(shown.scene),
        scale_(surface_scale(model_, input_)) {
    paths_.push_back(&shown.path);
    if (shown.before) paths_.push_back(&*shown.before);
  }

  [[nodiscard]] bool has_scene() const { return scene_.face_count() > 0; }

  Result<std::string> run() {
    const LengthUnit unit = model_.toolpath->unit;
    write_surface();
    Json tools = tools_json(model_, input_);
    json_["unit"] = {{"name", unit_name(unit)}, {"mm", mm_per(unit)}};
    json_["scale"] = scale_json(scale_, unit, is_overcut_ ? "Overcut" : "Gouge depth");
    json_["depths"] = scale_json(depth_scale(model_, input_), unit, "Depth of the move");
    json_["bodies"] = {colour_json(body_colour(0)), colour_json(body_colour(1)), colour_json(body_colour(2)),
                       colour_json(body_colour(3))};
    json_["greys"] = {colour_json(kPartGrey), colour_json(kFixtureGrey)};
    json_["tools"] = tools;
    write_heads();
    write_stock();
    write_paths();
    json_["findings"] = finding_texts(model_, input_, HtmlTable::kMaxRows);
    json_["view"] = first_view();
    tell(kSteps - 1);
    Result<std::string> text = payload_.text(json_);
    tell(kSteps);
    return text;
  }

  /// Reports that so many steps are done.
  void tell(std::size_t done) const {
    if (progress_) progress_("drawing the 3D view", done, kSteps);
  }

 private:
  void write_surface() {
    ViewerMesh mesh = ViewerMesh::from(scene_);
    tell(1);
    std::vector<std::unique_ptr<SurfaceValues>> fields;
    std::vector<AskedValues> asked;
    std::vector<Vec3> points;
    for (const PicturedPath* path : paths_) {
      asked.push_back({fields.emplace_back(std::make_unique<SurfaceValues>(*path)).get()});
      for (const GougeWitness& gouge : gouge_witnesses(path->input, kMaxPoints)) points.push_back(gouge.at);
    }
    is_overcut_ = fields.front()->is_overcut() || fields.back()->is_overcut();
    const VertexValues values = refine_surface(mesh, asked, points, scene_.part_size_mm());
    tell(2);
    json_["surface"] = write_mesh(payload_, mesh);
    Json by_path = Json::array();
    for (const std::vector<float>& of_path : values) by_path.push_back(write_values(payload_, of_path, scale_));
    json_["surface"]["values"] = by_path;
    json_["surface"]["meshes"] = meshes_json(mesh);
  }

  // Returns name, kind and number of triangles for each mesh, in their order.
  [[nodiscard]] Json meshes_json(const ViewerMesh& mesh) const {
    std::vector<std::size_t> counts(model_.parts.size() + model_.fixtures.size(), 0);
    for (const auto& t : mesh.triangles) ++counts[mesh.mesh_of[t[0]]];
    Json out = Json::array();
    for (std::size_t m = 0; m < counts.size(); ++m) {
      const bool is_part = m < model_.parts.size();
      const MeshFacts& facts = is_part ? model_.parts[m] : model_.fixtures[m - model_.parts.size()];
      out.push_back(
          {{"name", valid_utf8(facts.name)}, {"part", is_part}, {"closed", facts.is_closed}, {"triangles", counts[m]}});
    }
    return out;
  }

  void write_heads() {
    if (input_.heads.empty()) return;
    const PictureScene heads(input_.heads, RigidTransform{});
    json_["heads"] = write_mesh(payload_, ViewerMesh::from(heads));
  }

  void write_stock() {
    if (model_.shown_stock == nullptr) return;
    const Surface surface(*model_.shown_stock);
    const PictureScene stock(surface);
    ViewerMesh mesh = ViewerMesh::from(stock);
    drop_short_lines(mesh);
    json_["stock"] = write_mesh(payload_, mesh);
    json_["stock"]["colour"] = colour_json(kStockColour);
    json_["stock"]["shown"] =
        std::ranges::any_of(model_.result->events, [](const Event& event) { return event.against == Against::stock; });
  }

  void write_paths() {
    Json out = Json::array();
    const double error_mm = scene_.part_size_mm() / 2000;
    for (const PicturedPath* path : paths_) {
      const CheckedToolpath& input = path->input;
      Json one = write_path(payload_, stations_of(input, error_mm, kMaxStations), input, depth_scale(model_, input_));
      one["name"] = paths_.size() == 1 ? "" : path == paths_.front() ? "After" : "Before";
      one["moves_of_path"] = input.toolpath->moves.size();
      out.push_back(one);
    }
    json_["paths"] = out;
  }

  // Returns the first direction of view, which is that of the heat map.
  [[nodiscard]] Json first_view() const {
    const std::vector<PictureEvent> events = worst_events(input_, kEventsOfReport);
    return vector_json(choose_directions(input_, scene_, events, 1).front());
  }

  const ReportModel& model_;
  const CheckedToolpath& input_;
  const ProgressCall& progress_;
  const PictureScene& scene_;
  ColourScale scale_;
  std::vector<const PicturedPath*> paths_;
  Payload payload_;
  Json json_;
  bool is_overcut_ = false;
};

// Returns the page. The script is after the content that the page shows without the view.
std::string viewer_page(const std::string& scene) {
  std::string page = "<style>\n";
  page += kViewerStyle;
  page += "</style>\n";
  page += kViewerMarkup;
  page += "<script type=\"text/plain\" id=\"desk-data\">";
  page += scene;
  // The table of findings follows in the page and supplies the first finding.
  page += "</script>\n<script>\n\"use strict\";\ndocument.addEventListener(\"DOMContentLoaded\", () => {\n";
  page += kViewerScript;
  return page + "});\n</script>\n";
}

}  // namespace

Result<std::string> write_viewer(const ReportScene& shown, const ProgressCall& progress) {
  if (progress) progress("drawing the 3D view", 0, ViewerWriter::kSteps);
  ViewerWriter writer(shown, progress);
  if (!writer.has_scene()) return std::string();
  const Result<std::string> scene = writer.run();
  if (!scene) return scene.error();
  return viewer_page(*scene);
}

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLinesAround = 3;
constexpr std::size_t kLongestLine = 160;  // maximum number of characters quoted from a line
constexpr std::size_t kMaxLines = 24;

Json scaled_json(const Vec3& v, double scale) {
  Json out = Json::array();
  for (int k = 0; k < 3; ++k) out.push_back(std::round(v[k] * scale) / scale);
  return out;
}

std::string line_of(std::string_view source, std::size_t first, std::size_t last) {
  std::string text = valid_utf8(source.substr(first, std::min(last - first, kLongestLine)));
  if (last - first > kLongestLine) text += " ...";
  while (!text.empty() && (text.back() == '\r' || text.back() == ' ')) text.pop_back();
  return text;
}

/// Returns the statement of a move and the lines around it; nothing for a binary file.
Json quote_of(const Toolpath& path, const Move& move) {
  if (move.statement == kNone || move.statement >= path.statements.size()) return nullptr;
  const SourceStatement& statement = path.statements[move.statement];
  const std::string_view source = path.source;
  const std::size_t begin = statement.first_byte, end = statement.last_byte;
  if (end > source.size() || begin >= end || source.substr(0, 4096).find('\0') != std::string_view::npos)
    return nullptr;
  std::size_t first = begin, number = statement.line;
  const auto start_of_line = [&](std::size_t at) {
    const std::size_t found = at == 0 ? std::string_view::npos : source.rfind('\n', at - 1);
    return found == std::string_view::npos ? 0 : found + 1;
  };
  first = start_of_line(first);
  for (std::size_t k = 0; k < kLinesAround && first > 0; ++k) {
    first = start_of_line(first - 1);
    --number;
  }
  Json lines = Json::array();
  std::size_t at = first, after = 0;
  for (std::size_t k = 0; k < kMaxLines && at < source.size() && after < kLinesAround; ++k) {
    const std::size_t found = source.find('\n', at);
    const std::size_t stop = found == std::string_view::npos ? source.size() : found;
    if (at >= end) ++after;
    lines.push_back(line_of(source, at, stop));
    at = stop + 1;
  }
  return {{"first", number}, {"line", std::size_t{statement.line}}, {"lines", lines}};
}

Json finding_json(const ReportModel& model, const CheckedToolpath& input, const Event& event) {
  const Toolpath& path = *model.toolpath;
  const LengthUnit unit = path.unit;
  const MoveVerdict& verdict = model.result->verdicts[event.worst_move];
  const Move& move = path.moves[event.worst_move];
  const bool has_instant = verdict.witness && event.state != MoveState::buried;
  const std::optional<TurnShares> turn = has_instant ? verdict.witness->turn : std::nullopt;
  const Motion motion = input.options.law.of(path, event.worst_move).with(turn);
  const double t = has_instant ? verdict.witness->t : 1;
  const Pose pose = motion.is_defined() ? motion.at(t) : move.end;
  Json out = {{"state", state_name(event.state)},  {"move", event.worst_move},
              {"t", std::round(t * 1e6) / 1e6},    {"tool", event.tool},
              {"tip", scaled_json(pose.tip, 1e6)}, {"axis", scaled_json(pose.axis, 1e7)}};
  Json rows = Json::array();
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) rows.push_back(Json::array({name, valid_utf8(value)}));
  };
  if (event.state == MoveState::gouge) {
    add("Depth", depth_text(verdict.depth_mm, unit, model.options));
    add("At most", depth_text(verdict.depth_upper_mm, unit, model.options));
    if (verdict.overcut_mm() > 0) add("Overcut", depth_text(verdict.overcut_mm(), unit));
  }
  if (event.state == MoveState::near_miss)
    add("Left", depth_text(verdict.clearance_mm.value_or(0), unit, model.options));
  add("Body", std::string(body_name(event.body)) + " " + tool_label(path, event.tool));
  add("Against",
      std::string(against_name(event.against)) + (verdict.witness ? " " + mesh_name(model, *verdict.witness) : ""));
  if (verdict.witness) {
    add("At", point_text(verdict.witness->point, unit));
    out["point"] = scaled_json(verdict.witness->point, 1e6);
    out["normal"] = scaled_json(verdict.witness->normal, 1e6);
  }
  for (const std::string& further : further_texts(model, event)) add("Also", further);
  out["depth"] = event.state == MoveState::gouge ? verdict.depth_mm : 0.0;
  add("Instant", "move " + std::to_string(event.worst_move) + ", t = " + instant_text(t));
  if (event.moves > 1)
    add("Moves", std::to_string(event.moves) + ", " + std::to_string(event.first_move) + " to " +
                     std::to_string(event.last_move));
  add("Operation", operation_name(path, move.operation));
  out["rows"] = rows;
  out["quote"] = quote_of(path, move);
  return out;
}

}  // namespace

Json finding_texts(const ReportModel& model, const CheckedToolpath& input, std::size_t most) {
  Json out = Json::object();
  for (std::size_t i = 0; i < model.result->events.size() && out.size() < most; ++i) {
    const Event& event = model.result->events[i];
    if (event.state == MoveState::not_checked || event.state == MoveState::not_certified) continue;
    out[std::to_string(i)] = finding_json(model, input, event);
  }
  return out;
}

}  // namespace gouge
