#include "postproc/image/heat_map.h"

#include "postproc/report/report_text.h"

namespace gouge {

Page draw_event(const PictureSet& set, const PictureEvent& event) {
  const LengthUnit unit = set.model.toolpath->unit;
  const Toolpath& path = *set.input.toolpath;
  const bool is_buried = event.event.state == MoveState::buried;
  const std::string depth = is_buried ? std::string("buried") : depth_text(event.depth_mm, unit);
  const std::string title = "Finding " + std::to_string(event.number) + ": " + path.file + " line " +
                            std::to_string(path.moves[event.event.worst_move].line);
  Page page = make_page(title, is_buried ? (event.head ? "HEAD BURIED" : "TOOL BURIED") : "GOUGE " + depth, kAlarm,
                        {event_text(set.model, event.event) + span_text(event.event),
                         caption_lines(set.model, path)[0] + "; " + caption_lines(set.model, path)[1]});
  add_close_up(page, set, event, depth);
  add_sections(page, set, event, depth);
  page.line({1000, 120}, {1000, kPageHeight - 28}, kHairline, 1);
  return page;
}

}  // namespace gouge
