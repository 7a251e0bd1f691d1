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

/// All data that the pictures of one report share.
struct PictureSet {
  const ReportModel& model;
  const CheckedToolpath& input;
  const PictureScene& scene;
  const DepthField& field;
  const OvercutField& overcuts;
  std::vector<PictureEvent> events;
  ColourScale scale;          ///< scale of depths
  ColourScale surface_scale;  ///< scale of the surface's colours: overcuts, if there are any
  std::vector<Vec3> directions;
  std::vector<GougeWitness> gouges;
};

/// Draws the part from the chosen views, with the worst events numbered. It is coloured by overcut, or by depth if no
/// move has an overcut.
[[nodiscard]] Page draw_heat_map(const PictureSet& set);

/// Draws the part before (left) and after a correction (right), with the same views and colours. `after` belongs to the
/// corrected path, `before` to the path as read.
[[nodiscard]] Page draw_before_after(const PictureSet& before, const PictureSet& after);

/// Draws one finding close up: the part with the tool at the worst instant, and a section. The section is through the
/// tool's axis and the deepest point. It is shown whole, and enlarged with the depth as an arrow.
[[nodiscard]] Page draw_event(const PictureSet& set, const PictureEvent& event);

/// Adds the left side of a finding's page: part, tool and heads at the worst instant, with triad, scale and colours.
/// `words` point at the finding.
void add_close_up(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

/// Adds the right side of a finding's page: the section through the deepest point, and an enlarged region. There an
/// arrow with `words` shows the depth. A buried tool has no deepest point, so one section of the whole tool is drawn.
void add_sections(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words);

/// Draws the depth of every move over its number. The certain depth is a bar in the colour of the body. The depth that
/// is not excluded is a pale band above it. The tolerance is a line. Stretches of unchecked moves and of buried tools
/// have their own colours.
[[nodiscard]] Page draw_depth_strip(const PictureSet& set);

/// Returns "Overcut on the part", or "Gouge depth on the part" if no move has an overcut.
[[nodiscard]] std::string heat_map_title(const PictureSet& set);

/// Returns the two lines below a title: "path.apt against part.stl", and the tools with tolerance and resolution.
[[nodiscard]] std::vector<std::string> caption_lines(const ReportModel& model, const Toolpath& toolpath);
/// Returns the text for the badge of a page, such as "worst 0.213 mm".
[[nodiscard]] std::string badge_text(const ReportModel& model, const CheckResult& result);
[[nodiscard]] Colour badge_colour(const CheckResult& result);

/// Chooses `count` directions of view for the part, from the faces and corners of a cube and the mean tool axis. The
/// first one shows the most of the gouged surface (gouge_witnesses.h) and of the worst events. The next one is the best
/// that differs by at least 50 degrees. Without gouges they are the usual view from above the tool and the opposite
/// one.
[[nodiscard]] std::vector<Vec3> choose_directions(const CheckedToolpath& input, const PictureScene& scene,
                                                  const std::vector<PictureEvent>& events, std::size_t count);

}  // namespace gouge
