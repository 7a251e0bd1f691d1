#include "postproc/image/event_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "postproc/image/render_png.h"
#include "postproc/image/section.h"
#include "postproc/image/shade.h"
#include "postproc/image/tool_outline.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr Area kCloseUp{152, 142, 830, 742};
constexpr Area kWhole{1016, 142, 548, 400};
constexpr Area kDetail{1016, 582, 548, 390};

std::string head_words(const PictureEvent& event) {
  return event.event.body == Body::head ? std::string("; ") + kHeadNotDrawn : std::string();
}

const ToolForms& forms_of(const PictureSet& set, const PictureEvent& event) {
  return *set.input.tools[event.event.tool];
}

// Radius of the body that gouges: what a picture of it should be scaled to.
double body_radius(const CompiledTool& tool, Body body) {
  double radius = 0;
  for (const OutlineRun& run : tool_outline(tool)) {
    if (run.body != body) continue;
    for (const Vec2& p : run.points) radius = std::max(radius, p.x());
  }
  return radius > 0 ? radius : tool.r_max_mm;
}

// What a picture of the finding is scaled to: the body that gouges, or more when it is reached deep inside.
double size_of(const PictureSet& set, const PictureEvent& event) {
  const Vec3 d = event.at - event.pose.tip;
  const double from_axis = (d - event.pose.axis * d.dot(event.pose.axis)).norm();
  return std::max(
      {body_radius(forms_of(set, event).bare, event.event.body), from_axis, 1.3 * event.depth_mm});
}

View close_view(const PictureSet& set, const PictureEvent& event, const Vec3& toward, double height_mm,
                int width, int height) {
  View view = make_view(toward, event.pose.axis, width, height);
  view.mm_per_pixel = height_mm / height;
  // A little of the tool above the finding, most of the part around it.
  const double lift = std::min(0.18 * height_mm, 0.5 * forms_of(set, event).bare.z_max_mm);
  view.centre = event.at + view.up * lift;
  return view;
}

// How much of what is seen within `near_mm` of the finding is gouged.
double gouged_share(const PictureSet& set, const PictureEvent& event, const SurfaceBuffer& buffer,
                    double near_mm) {
  const std::vector<float> depth = set.coarse.depth_on_pixels(set.scene, buffer);
  double gouged = 0;
  for (int y = 0; y < buffer.view.height; ++y) {
    for (int x = 0; x < buffer.view.width; ++x) {
      const std::size_t i = buffer.index(x, y);
      if (depth[i] > 0 && (buffer.point(x, y) - event.at).norm() < near_mm) gouged += 1;
    }
  }
  const double radius = near_mm / buffer.view.mm_per_pixel;
  return std::min(1.0, gouged / (std::numbers::pi * radius * radius));
}

Vec3 best_direction(const PictureSet& set, const PictureEvent& event, double height_mm) {
  const Vec3 side = std::abs(event.pose.axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  const Vec3 e1 = event.pose.axis.cross(side).normalized();
  const Vec3 e2 = event.pose.axis.cross(e1);
  Vec3 best = event.pose.axis;
  double best_score = -1;
  // Large meshes are looked at from fewer sides.
  const int sides = set.scene.faces.size() > 200000 ? 6 : 12;
  for (const double rise : {0.45, 0.8}) {
    for (int k = 0; k < sides; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / sides;
      const Vec3 around = std::cos(angle) * e1 + std::sin(angle) * e2;
      const Vec3 toward = std::cos(rise) * around + std::sin(rise) * event.pose.axis;
      const View view = close_view(set, event, toward, height_mm, 120, 108);
      const SurfaceBuffer buffer = draw_surface(set.scene, view);
      double score = is_visible(buffer, event.at, view.mm_per_pixel + 1e-3) ? 1 : 0;
      score += 0.5 * gouged_share(set, event, buffer, 0.15 * height_mm);
      if (event.has_witness) score += 0.3 * event.witness.normal.dot(toward);
      if (rise < 0.5) score += 0.05;
      if (score > best_score + 1e-9) {
        best_score = score;
        best = toward;
      }
    }
  }
  return best;
}

// The tool over the picture: clear glass where it is in front, a faint trace where the part hides it, and a
// line around it.
void lay_tool(Raster& raster, const SurfaceBuffer& part, const ToolSurface& tool) {
  const SurfaceBuffer buffer = draw_surface(tool.vertices, tool.faces, part.view);
  const auto body_of = [&](std::size_t i) {
    return buffer.face[i] == kNoFace ? -1 : static_cast<int>(tool.bodies[buffer.face[i]]);
  };
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) {
      const std::size_t i = buffer.index(x, y);
      const int right = x + 2 < raster.width ? body_of(buffer.index(x + 2, y)) : body_of(i);
      const int below = y + 2 < raster.height ? body_of(buffer.index(x, y + 2)) : body_of(i);
      const int body = body_of(i);
      const bool is_edge = right != body || below != body;
      if (body < 0 && !is_edge) continue;
      const bool is_hidden = body >= 0 && part.face[i] != kNoFace && buffer.z[i] < part.z[i];
      if (is_edge) {
        blend_pixel(raster, x, y, body_colour(std::max({body, right, below})), is_hidden ? 0.5 : 0.85);
        continue;
      }
      const FaceCorners& corners = tool.faces[buffer.face[i]];
      const Vec3& a = tool.vertices[corners[0]];
      Vec3 normal = (tool.vertices[corners[1]] - a).cross(tool.vertices[corners[2]] - a);
      if (normal.norm() < 1e-12) normal = part.view.toward;
      normal.normalize();
      if (normal.dot(part.view.toward) < 0) normal = -normal;
      const double light = std::min(1.15, 0.25 + light_on(part.view, normal));
      Colour colour = body_colour(body);
      const auto lit = [&](unsigned char c) {
        return static_cast<unsigned char>(std::min(255.0, (0.35 * 255 + 0.65 * c) * light));
      };
      colour = {lit(colour.r), lit(colour.g), lit(colour.b), 1};
      blend_pixel(raster, x, y, colour, is_hidden ? 0.10 : 0.34);
    }
  }
}

void add_callout(Page& page, const Area& area, const Vec2& target, const std::string& words) {
  const double width = text_width(words, 21, true) + 28;
  const bool is_left = target.x() < area.middle().x();
  const Vec2 corner(is_left ? area.right() - width - 24 : area.x + 24, area.bottom() - 150);
  const Area box{corner.x(), corner.y(), width, 38};
  const Vec2 from(is_left ? box.x : box.right(), box.middle().y());
  page.line(from, target, {255, 255, 255, 0.9}, 5);
  page.line(from, target, kInk, 1.8);
  page.disc(target, 6, {255, 255, 255, 1});
  page.disc(target, 4.2, kAlarm);
  page.box(box, {255, 255, 255, 0.94});
  page.frame(box, kInk, 1.5);
  page.text({box.middle().x(), box.y + 26}, words, 21, kAlarm, TextAnchor::middle, true);
}

void add_close_up(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words) {
  const ToolForms& forms = forms_of(set, event);
  const double part_mm = set.scene.vertices.empty() ? 10 : [&] {
    Box3 box;
    for (const Vec3& p : set.scene.part_points()) box.extend(p);
    return box.diagonal().norm();
  }();
  const double times = event.event.body == Body::cutter ? 8 : 5.5;
  const double reach = event.has_witness ? times * size_of(set, event) : 1.2 * part_mm;
  const double height_mm =
      std::clamp(reach, std::min(8 * event.depth_mm, reach), std::max(1.1 * part_mm, 1e-3));
  const Vec3 toward = best_direction(set, event, height_mm);
  const View view =
      close_view(set, event, toward, height_mm, static_cast<int>(kCloseUp.width) * kSupersampling,
                 static_cast<int>(kCloseUp.height) * kSupersampling);
  const SurfaceBuffer buffer = draw_surface(set.scene, view);
  Raster raster = shade(set.scene, buffer, set.field.depth_on_pixels(set.scene, buffer), set.scale);
  lay_tool(raster, buffer, tool_surface(forms.bare, event.pose));
  page.rasters.push_back({static_cast<int>(kCloseUp.x), static_cast<int>(kCloseUp.y), std::move(raster)});
  add_callout(page, kCloseUp, on_page(kCloseUp, view.project(event.at)), words);
  page.frame(kCloseUp, kSoftInk, 1);
  page.text({kCloseUp.x, kCloseUp.y - 10}, "Part and tool at the worst instant" + head_words(event), 15, kInk,
            TextAnchor::left, true);
  add_triad(page, {kCloseUp.x + 40, kCloseUp.bottom() + 58}, view, 28);
  add_scale_bar(page, {kCloseUp.x + 112, kCloseUp.bottom() + 56}, view, set.model.toolpath->unit, 160);
  add_colour_bar(page, {40, 204, 22, 350}, set.scale, set.model.toolpath->unit, "Gouge depth");
}

// The depth between the tool's boundary and the surface, with arrow heads when there is room for them.
void add_depth_arrow(Page& page, const SectionPanel& panel, const SectionPlane& plane,
                     const PictureEvent& event, const std::string& words) {
  const Vec2 from = panel.place(plane.flat(event.at));
  const Vec2 to = panel.place(plane.flat(Vec3(event.at - event.witness.normal * event.depth_mm)));
  const double length = (to - from).norm();
  if (length > 1e-6) {
    const Vec2 along = (to - from) / length;
    const Vec2 across(-along.y(), along.x());
    page.line(from, to, {255, 255, 255, 0.9}, 5);
    page.line(from, to, kInk, 2.2);
    const double head = std::min(11.0, 0.4 * length);
    page.shape({to, to - head * along + 0.45 * head * across, to - head * along - 0.45 * head * across},
               kInk);
    page.shape({from, from + head * along + 0.45 * head * across, from + head * along - 0.45 * head * across},
               kInk);
  }
  page.disc(from, 4.5, {255, 255, 255, 1});
  page.disc(from, 3.2, kAlarm);
  const double width = text_width(words, 18, true) + 20;
  const Vec2 middle = 0.5 * (from + to);
  const bool is_right = middle.x() + 30 + width < panel.area.right() - 8;
  const Area box{is_right ? middle.x() + 26 : middle.x() - 26 - width, middle.y() - 15, width, 30};
  page.line({is_right ? box.x : box.right(), middle.y()}, middle, kInk, 1.2);
  page.box(box, {255, 255, 255, 0.94});
  page.frame(box, kInk, 1);
  page.text({box.middle().x(), box.y + 21}, words, 18, kAlarm, TextAnchor::middle, true);
}

void add_panel_scale(Page& page, const SectionPanel& panel, LengthUnit unit) {
  View view;
  view.mm_per_pixel = panel.mm_per_unit / kSupersampling;
  page.box({panel.area.x + 1, panel.area.bottom() - 31, 190, 30}, {255, 255, 255, 0.85});
  add_scale_bar(page, {panel.area.x + 14, panel.area.bottom() - 15}, view, unit, 100);
}

// A buried tool has no deepest point: the whole of it in the part.
void add_buried_section(Page& page, const PictureSet& set, const PictureEvent& event, const Section& section,
                        bool has_inside) {
  const CompiledTool& bare = forms_of(set, event).bare;
  const Area area{kWhole.x, kWhole.y, kWhole.width, kDetail.bottom() - kWhole.y};
  const double height_mm = 1.25 * (bare.z_max_mm - bare.z_min_mm);
  const SectionPanel panel{area, Vec2(0, 0.5 * (bare.z_min_mm + bare.z_max_mm)),
                           std::max(height_mm / area.height, 2.6 * bare.r_max_mm / area.width)};
  page.text({area.x, area.y - 10}, "Section through the tool axis" + head_words(event), 15, kInk,
            TextAnchor::left, true);
  draw_section(page, panel, section.lines, has_inside, bare, bare);
  add_panel_scale(page, panel, set.model.toolpath->unit);
  page.frame(area, kSoftInk, 1);
}

void add_sections(Page& page, const PictureSet& set, const PictureEvent& event, const std::string& words) {
  const ToolForms& forms = forms_of(set, event);
  const CompiledTool& checked =
      event.event.against == Against::part ? forms.against_part : forms.against_fixture;
  const double radius = size_of(set, event);
  const Section section = make_section(*set.input.scene, event.pose, event.at, radius);
  const SectionPlane& plane = section.plane;
  const std::vector<SectionLine>& lines = section.lines;
  const auto is_closed = [](const std::vector<MeshFacts>& meshes) {
    return std::all_of(meshes.begin(), meshes.end(), [](const MeshFacts& mesh) { return mesh.is_closed; });
  };
  const bool has_inside =
      is_closed(set.model.parts) && is_closed(set.model.fixtures) && !set.model.parts.empty();
  const LengthUnit unit = set.model.toolpath->unit;
  const Vec2 at = plane.flat(event.at);
  if (!event.has_witness) {
    add_buried_section(page, set, event, section, has_inside);
    return;
  }
  // The body that gouges with some room around it, the finding well inside the panel.
  const SectionPanel whole{kWhole, Vec2(0, at.y() + 0.55 * radius), 3.4 * radius / kWhole.height};
  const Vec2 foot = plane.flat(Vec3(event.at - event.witness.normal * event.depth_mm));
  const double most_mm = std::max(1.6 * radius, 2.6 * event.depth_mm);
  const double detail_mm = std::clamp(9 * event.depth_mm, 0.02 * radius, most_mm);
  const SectionPanel detail{kDetail, Vec2(0.5 * (at + foot)), detail_mm / kDetail.height};
  const std::string title = "Section through tool axis and deepest point" + head_words(event);
  page.text({kWhole.x, kWhole.y - 10}, title, fitting_size(title, 15, kWhole.width, true), kInk,
            TextAnchor::left, true);
  draw_section(page, whole, lines, has_inside, forms.bare, checked);
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
  page.text({kDetail.x, kDetail.y - 10}, "The framed place enlarged", 15, kInk, TextAnchor::left, true);
  draw_section(page, detail, lines, has_inside, forms.bare, checked);
  add_depth_arrow(page, detail, plane, event, words);
  add_panel_scale(page, detail, unit);
  page.frame(kDetail, kSoftInk, 1);
  add_panel_scale(page, whole, unit);
  page.frame(kWhole, kSoftInk, 1);
}

}  // namespace

Page draw_event(const PictureSet& set, const PictureEvent& event) {
  const LengthUnit unit = set.model.toolpath->unit;
  const Toolpath& path = *set.input.toolpath;
  const bool is_buried = event.event.state == MoveState::buried;
  const std::string depth = is_buried ? std::string("buried") : depth_text(event.depth_mm, unit);
  const std::string title = "Finding " + std::to_string(event.number) + ": " + path.file + " line " +
                            std::to_string(path.moves[event.event.worst_move].line);
  Page page = make_page(title, is_buried ? "TOOL BURIED" : "GOUGE " + depth, kAlarm,
                        {event_text(set.model, event.event) + span_text(event.event),
                         caption_lines(set.model, path)[0] + "; " + caption_lines(set.model, path)[1]});
  add_close_up(page, set, event, depth);
  add_sections(page, set, event, depth);
  page.line({1000, 120}, {1000, kPageHeight - 28}, kHairline, 1);
  return page;
}

}  // namespace gouge
