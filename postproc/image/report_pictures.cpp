#include "postproc/image/report_pictures.h"

#include <algorithm>
#include <utility>

#include "postproc/image/event_scale.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/mask_painter.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/tilt_field.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::size_t kViews = 2;
constexpr std::size_t kMaxWitnessesDrawn = 2000;

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

Outcome add_before_after(Album& album, const PictureSet& after, const PicturedPath& path) {
  ReportModel model = after.model;
  model.toolpath = path.input.toolpath;
  model.result = path.input.result;
  PictureSet before{model,       path.input,          after.scene,
                    path.depths, path.overcuts,       worst_events(path.input, kEventsOfReport),
                    after.scale, after.surface_scale, {},
                    {}};
  before.directions = choose_directions(path.input, after.scene, before.events, 1);
  return album.add(draw_before_after(before, after), "before_after.png", "Before and after the correction");
}

Outcome add_scene_pictures(Album& album, const PictureSet& set, const std::optional<PicturedPath>& before) {
  if (Outcome done = album.add(draw_heat_map(set), "heat_map.png", heat_map_title(set)); !done) return done;
  if (before) {
    if (Outcome done = add_before_after(album, set, *before); !done) return done;
  }
  if (has_tilt_field(set.model)) {
    if (Outcome done = album.add(draw_tilt_field(set), "tilt_field.png", "Tilted tool axes"); !done) return done;
  }
  for (const PictureEvent& event : set.events) {
    const std::string number = std::to_string(event.number);
    const std::size_t move = event.event.worst_move;
    const std::string title = "Finding " + number + ": line " + std::to_string(set.input.toolpath->moves[move].line) +
                              ", " + event_text(set.model, event.event);
    if (Outcome done = album.add(draw_event(set, event), "event_" + std::to_string(event.rank) + ".png", title, move);
        !done) {
      return done;
    }
  }
  return Done{};
}

}  // namespace

Outcome load_pictures() {
  const Result<const MaskPainter*> painter = mask_painter();
  if (!painter) return painter.error();
  return Done{};
}

Result<std::vector<NamedFile>> draw_report_pictures(const ReportScene& shown, const ProgressCall& progress) {
  const ReportModel& model = shown.model;
  const CheckedToolpath& input = shown.path.input;
  PictureSet set{model,
                 input,
                 shown.scene,
                 shown.path.depths,
                 shown.path.overcuts,
                 worst_events(input, kEventsOfReport),
                 depth_scale(model, input),
                 surface_scale(model, input),
                 {},
                 gouge_witnesses(input, kMaxWitnessesDrawn)};
  const std::size_t of_path = 1U + (shown.before ? 1U : 0U) + (has_tilt_field(model) ? 1U : 0U);
  const std::size_t of_scene = shown.scene.face_count() == 0 ? 0 : of_path + set.events.size();
  Album album{progress, of_scene + 1};
  album.report();
  if (of_scene > 0) {
    set.directions = choose_directions(input, shown.scene, set.events, kViews);
    if (Outcome done = add_scene_pictures(album, set, shown.before); !done) return done.error();
  }
  if (Outcome done = album.add(draw_depth_strip(set), "depth_along_path.png", "Depth along the path"); !done) {
    return done.error();
  }
  return std::move(album.files);
}

}  // namespace gouge
