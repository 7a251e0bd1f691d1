#pragma once

#include <string>
#include <vector>

#include "lib/field/overcut_field.h"
#include "postproc/image/page.h"
#include "postproc/image/picture_events.h"
#include "postproc/image/picture_scene.h"
#include "postproc/image/view.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// Everything the pictures of one report share.
struct PictureSet {
  const ReportModel& model;
  const CheckedToolpath& input;
  const PictureScene& scene;
  const DepthField& field;
  const OvercutField& overcuts;
  std::vector<PictureEvent> events;
  ColourScale scale;          ///< of depths
  ColourScale surface_scale;  ///< of what colours the surface: overcuts, where there are any
  std::vector<Vec3> directions;
  std::vector<GougeWitness> gouges;
};

/// Returns the part from the chosen views, coloured by overcut, or by depth where no move has one, with the worst
/// events numbered.
[[nodiscard]] Page draw_heat_map(const PictureSet& set);

/// Returns the part before (left) and after a correction (right), same views, same colours. `after` describes the
/// corrected path, `before` the path as read.
[[nodiscard]] Page draw_before_after(const PictureSet& before, const PictureSet& after);

/// Draws one finding close up: the part with the tool at the worst instant, and a section. The section is through the
/// tool's axis and the deepest point, whole and enlarged with the depth as an arrow.
[[nodiscard]] Page draw_event(const PictureSet& set, const PictureEvent& event);

/// The left of a finding's page: part, tool and heads at its worst instant, `words` pointing at the point,
/// with triad, scale and colours.
void add_close_up(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

/// The right of a finding's page: the section through the deepest point and the region enlarged, with the depth as an
/// arrow called `words`. A buried tool has no deepest point: one section of all of it is drawn.
void add_sections(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

/// Draws the depth of every move over its number. The certain depth is a bar in the colour of the body, and the depth
/// that is not excluded is a pale band above. The tolerance is a line; unchecked and buried stretches stand out.
[[nodiscard]] Page draw_depth_strip(const PictureSet& set);

/// Returns "Overcut on the part", or "Gouge depth on the part" where no move has one.
[[nodiscard]] std::string heat_map_title(const PictureSet& set);

/// Returns "path.apt against part.stl", and the tools with tolerance and resolution: the two lines below a title.
[[nodiscard]] std::vector<std::string> caption_lines(const ReportModel& model, const Toolpath& toolpath);
/// Returns "worst 0.213 mm" and the like, for the badge of a page.
[[nodiscard]] std::string badge_text(const ReportModel& model, const CheckResult& result);
[[nodiscard]] Colour badge_colour(const CheckResult& result);

/// Chooses `count` directions to examine the part from, out of the faces and corners of a cube and the mean tool axis.
/// The first shows the most of the gouged surface (gouge_witnesses.h) and of the worst events. Then comes the best that
/// differs by 50 degrees. Without gouges it is the usual view from above the tool and the one opposite.
[[nodiscard]] std::vector<Vec3> choose_directions(const CheckedToolpath& input, const PictureScene& scene,
                                                  const std::vector<PictureEvent>& events, std::size_t count);

}  // namespace gouge
