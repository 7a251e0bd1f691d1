#include "postproc/image/report_pictures.h"

#include <algorithm>
#include <utility>

#include "postproc/image/heat_map.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/tilt_field.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::size_t kMostEvents = 6;
constexpr std::size_t kViews = 2;
constexpr std::size_t kMostWitnesses = 2000;

struct Album {
  const ProgressCall& progress;
  std::size_t total = 0;
  std::vector<NamedFile> files{};

  [[nodiscard]] Outcome add(const Page& page, std::string name, std::string title, std::size_t move = kNone) {
    Result<std::string> png = render_png(page.drawing, page.rasters);
    if (!png) return png.error();
    files.push_back({std::move(name), std::move(*png), std::move(title), move});
    report();
    return Done{};
  }
  void report() const {
    if (progress) progress("drawing pictures", files.size(), total);
  }
};

// Colours of a correction cover the path before it, so that both halves can be compared.
double worst_depth(const ReportModel& model, const CheckedToolpath& input) {
  const CheckResult* before = model.has_correction ? model.correction.result_before : nullptr;
  return std::max(input.result->worst_depth_mm, before != nullptr ? before->worst_depth_mm : 0.0);
}

/// What colours the surface at most: an overcut, or the depth of a gouge without one or of a head.
double worst_on_surface(const CheckResult& result) {
  double worst = 0;
  for (const MoveVerdict& v : result.verdicts) {
    if (v.state != MoveState::gouge) continue;
    const bool is_head = v.witness && v.witness->body == Body::head;
    worst = std::max(worst, v.overcut_mm.value_or(0) > 0 && !is_head ? *v.overcut_mm : v.depth_mm);
  }
  return worst;
}

double worst_on_surface(const ReportModel& model, const CheckedToolpath& input) {
  const CheckResult* before = model.has_correction ? model.correction.result_before : nullptr;
  return std::max(worst_on_surface(*input.result), before != nullptr ? worst_on_surface(*before) : 0.0);
}

Outcome add_before_after(Album& album, const PictureSet& after, const CheckedToolpath& before_input) {
  ReportModel model = after.model;
  model.toolpath = before_input.toolpath;
  model.result = before_input.result;
  const DepthField field(before_input);
  const OvercutField overcuts(before_input, field);
  PictureSet before{
      model,       before_input,        after.scene, field, overcuts, worst_events(before_input, kMostEvents),
      after.scale, after.surface_scale, {},          {}};
  before.directions = choose_directions(before_input, after.scene, before.events, 1);
  return album.add(draw_before_after(before, after), "before_after.png", "Before and after the correction");
}

Outcome add_scene_pictures(Album& album, const PictureSet& set, const CheckedToolpath& before) {
  if (Outcome done = album.add(draw_heat_map(set), "heat_map.png", heat_map_title(set)); !done) return done;
  if (set.model.has_correction && before.toolpath != nullptr && before.result != nullptr) {
    if (Outcome done = add_before_after(album, set, before); !done) return done;
  }
  if (has_tilt_field(set.model)) {
    if (Outcome done = album.add(draw_tilt_field(set), "tilt_field.png", "Tilted tool axes"); !done) return done;
  }
  for (const PictureEvent& event : set.events) {
    const std::string number = std::to_string(event.number);
    const std::size_t move = event.event.worst_move;
    const std::string title = "Finding " + number + ": line " + std::to_string(set.input.toolpath->moves[move].line) +
                              ", " + event_text(set.model, event.event);
    if (Outcome done = album.add(draw_event(set, event), "event_" + number + ".png", title, move); !done) {
      return done;
    }
  }
  return Done{};
}

}  // namespace

Result<std::vector<NamedFile>> draw_report_pictures(const ReportModel& model, const CheckedToolpath& input,
                                                    const CheckedToolpath& before, const ProgressCall& progress) {
  const PictureScene scene(*input.prepared);
  const DepthField field(input);
  const OvercutField overcuts(input, field);
  const auto scale_to = [&](double worst_mm) {
    return make_colour_scale(model.options.tolerance_mm, worst_mm, model.toolpath->unit);
  };
  PictureSet set{model,
                 input,
                 scene,
                 field,
                 overcuts,
                 worst_events(input, kMostEvents),
                 scale_to(worst_depth(model, input)),
                 scale_to(worst_on_surface(model, input)),
                 {},
                 gouge_witnesses(input, kMostWitnesses)};
  const bool has_before = model.has_correction && before.toolpath != nullptr && before.result != nullptr;
  const std::size_t of_scene =
      scene.face_count() == 0 ? 0
                              : 1 + std::size_t{has_before} + std::size_t{has_tilt_field(model)} + set.events.size();
  Album album{progress, of_scene + 1};
  album.report();
  if (of_scene > 0) {
    set.directions = choose_directions(input, scene, set.events, kViews);
    if (Outcome done = add_scene_pictures(album, set, before); !done) return done.error();
  }
  if (Outcome done = album.add(draw_depth_strip(set), "depth_along_path.png", "Depth along the path"); !done) {
    return done.error();
  }
  return std::move(album.files);
}

}  // namespace gouge
