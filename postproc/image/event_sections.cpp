#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "postproc/image/event_scale.h"
#include "postproc/image/heat_map.h"
#include "postproc/image/render_drawing.h"
#include "postproc/image/section_panel.h"
#include "postproc/report/report_text.h"

namespace gouge {

namespace {

constexpr Area kWhole{1016, 142, 548, 400};
constexpr Area kDetail{1016, 582, 548, 390};

// Adds an arrow for the depth between the tool's boundary and the surface, with arrow heads if there is room for them.
void add_depth_arrow(Page& page, const SectionPanel& panel, const SectionPlane& plane, const PictureEvent& event,
                     const std::string& words) {
  const Vec2 from = panel.place(plane.flat(event.at));
  const Vec2 to = panel.place(plane.flat(Vec3(event.at - event.witness.normal * event.depth_mm)));
  const double length = (to - from).norm();
  if (length > Tolerance::kNoSide) {
    const Vec2 along = (to - from) / length;
    const Vec2 across(-along.y(), along.x());
    page.line(from, to, {255, 255, 255, 0.9}, 5);
    page.line(from, to, kInk, 2.2);
    const double head = std::min(11.0, 0.4 * length);
    page.shape({to, to - head * along + 0.45 * head * across, to - head * along - 0.45 * head * across}, kInk);
    page.shape({from, from + head * along + 0.45 * head * across, from + head * along - 0.45 * head * across}, kInk);
  }
  page.disc(from, 4.5, kWhite);
  page.disc(from, 3.2, kAlarm);
  const double width = text_width(words, 18, true) + 20;
  const Vec2 middle = 0.5 * (from + to);
  // A head may move away in any direction, also sideways in the picture.
  const double gap = event.head ? 26 + 0.5 * std::abs(to.x() - from.x()) : 26;
  const bool is_right = middle.x() + gap + 4 + width < panel.area.right() - 8;
  const Area box{is_right ? middle.x() + gap : middle.x() - gap - width, middle.y() - 15, width, 30};
  page.line({is_right ? box.x : box.right(), middle.y()}, middle, kInk, 1.2);
  page.box(box, {255, 255, 255, 0.94});
  page.frame(box, kInk, 1);
  page.text({box.middle().x(), box.y + 21}, words, 18, kAlarm, TextAnchor::middle, true);
}

void add_panel_scale(Page& page, const SectionPanel& panel, LengthUnit unit) {
  View view;
  view.mm_per_pixel = panel.mm_per_unit / kSupersampling;
  constexpr double kWidest = 100, kMargin = 14;
  const double width = scale_bar_width(view, unit, kWidest) + 2 * kMargin;
  page.box({panel.area.x + 1, panel.area.bottom() - 31, width, 30}, {255, 255, 255, 0.85});
  add_scale_bar(page, {panel.area.x + kMargin, panel.area.bottom() - 15}, view, unit, kWidest);
}

bool has_inside(const PictureSet& set) {
  const auto is_closed = [](const std::vector<MeshFacts>& meshes) {
    return std::all_of(meshes.begin(), meshes.end(), [](const MeshFacts& mesh) { return mesh.is_closed; });
  };
  return is_closed(set.model.parts) && is_closed(set.model.fixtures) && !set.model.parts.empty();
}

// Returns the section, including the heads.
Section cut(const PictureSet& set, const PictureEvent& event, double size_mm) {
  std::optional<Vec3> way_out;
  if (event.head && event.has_witness) way_out = event.witness.normal;
  Section section = make_section(*set.input.prepared, event.pose, event.at, size_mm, way_out);
  section.heads = cut_heads(set.input.heads, event.heads, section.plane);
  return section;
}

// Returns the panel of a finding of a head. It shows the heads, up to the shown distance, the finding and the tool's
// tip. If a head is buried, it shows tool and part too.
SectionPanel head_panel(const PictureSet& set, const PictureEvent& event, const Section& section, const Area& area) {
  const Vec2 at = section.plane.flat(event.at);
  const double reach = head_reach_mm(set, event);
  FlatExtent extent;
  const auto take = [&](const std::vector<SectionLine>& lines) {
    for (const SectionLine& line : lines) {
      extent.take(line.a - at, reach);
      extent.take(line.b - at, reach);
    }
  };
  extent.take(Vec2(0, 0) - at, reach);
  for (const std::vector<SectionLine>& head : section.heads) take(head);
  if (!event.has_witness) {
    take(section.lines);
    const CompiledTool& bare = variants_of(set, event).bare;
    take({{Vec2(-bare.r_max_mm, bare.z_min_mm), Vec2(bare.r_max_mm, bare.z_max_mm)}});
  }
  return {area, Vec2(at + extent.middle()), extent.mm_per_unit(area.width, area.height)};
}

SectionPanel buried_tool_panel(const CompiledTool& bare, const Area& area) {
  const double height_mm = 1.25 * (bare.z_max_mm - bare.z_min_mm);
  return {area, Vec2(0, 0.5 * (bare.z_min_mm + bare.z_max_mm)),
          std::max(height_mm / area.height, 2.6 * bare.r_max_mm / area.width)};
}

void add_buried_section(Page& page, const PictureSet& set, const PictureEvent& event) {
  const CompiledTool& bare = variants_of(set, event).bare;
  const Area area{kWhole.x, kWhole.y, kWhole.width, kDetail.bottom() - kWhole.y};
  const Section section = cut(set, event, tool_size_mm(set, event));
  page.text({area.x, area.y - 10}, event.head ? "Section through tool axis and head" : "Section through the tool axis",
            15, kInk, TextAnchor::left, true);
  const SectionPanel panel = event.head ? head_panel(set, event, section, area) : buried_tool_panel(bare, area);
  draw_section(page, panel, section, has_inside(set), bare, bare);
  add_panel_scale(page, panel, set.model.toolpath->unit);
  page.frame(area, kSoftInk, 1);
}

std::string whole_title(const PictureSet& set, const SectionPlane& plane) {
  const double beside = std::abs(plane.beside_mm);
  if (!(beside > 0)) return "Section through tool axis and deepest point";
  return "Section along the depth, " + depth_text(beside, set.model.toolpath->unit) + " beside the tool axis";
}

// Draws a frame in `whole` around the area that `detail` enlarges.
void frame_detail(Page& page, const SectionPanel& whole, const SectionPanel& detail) {
  const Vec2 target = whole.place(detail.centre);
  const double half_width = 0.5 * kDetail.width * detail.mm_per_unit / whole.mm_per_unit;
  const double half_height = 0.5 * kDetail.height * detail.mm_per_unit / whole.mm_per_unit;
  const double w = std::max(half_width, 7.0);
  const double h = std::max(half_height, 5.0);
  const double left = std::max(target.x() - w, kWhole.x + 3);
  const double top = std::max(target.y() - h, kWhole.y + 3);
  page.frame({left, top, std::min(target.x() + w, kWhole.right() - 3) - left,
              std::min(target.y() + h, kWhole.bottom() - 3) - top},
             kAlarm, 1.6);
}

}  // namespace

void add_sections(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words) {
  if (!event.has_witness) return add_buried_section(page, set, event);
  const ToolVariants& variants = variants_of(set, event);
  const CompiledTool& checked = variants.*rule_of(event.event.against).form;
  const double clearance_mm = event.head ? 0 : mesh_clearance_mm(set.model, event.witness);
  const Section section = cut(set, event, tool_size_mm(set, event));
  const SectionPlane& plane = section.plane;
  const LengthUnit unit = set.model.toolpath->unit;
  const Vec2 at = plane.flat(event.at);
  // The panel shows the body that gouges with some room around it, and the finding well inside.
  const double size = tool_size_mm(set, event);
  const SectionPanel whole = event.head
                                 ? head_panel(set, event, section, kWhole)
                                 : SectionPanel{kWhole, Vec2(0, at.y() + 0.55 * size), 3.4 * size / kWhole.height};
  const double radius = event.head ? whole.mm_per_unit * kWhole.height / 3.4 : size;
  const Vec2 foot = plane.flat(Vec3(event.at - event.witness.normal * event.depth_mm));
  const double max_mm = std::max(1.6 * radius, 2.6 * event.depth_mm);
  const double detail_mm = std::clamp(9 * event.depth_mm, 0.02 * radius, max_mm);
  const SectionPanel detail{kDetail, Vec2(0.5 * (at + foot)), detail_mm / kDetail.height};
  const std::string title = whole_title(set, plane);
  page.text({kWhole.x, kWhole.y - 10}, title, fitting_size(title, 15, kWhole.width, true), kInk, TextAnchor::left,
            true);
  draw_section(page, whole, section, has_inside(set), variants.bare, checked, clearance_mm);
  frame_detail(page, whole, detail);
  page.text({kDetail.x, kDetail.y - 10}, "The framed region enlarged", 15, kInk, TextAnchor::left, true);
  draw_section(page, detail, section, has_inside(set), variants.bare, checked, clearance_mm);
  add_depth_arrow(page, detail, plane, event, words);
  add_panel_scale(page, detail, unit);
  page.frame(kDetail, kSoftInk, 1);
  add_panel_scale(page, whole, unit);
  page.frame(kWhole, kSoftInk, 1);
}

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
