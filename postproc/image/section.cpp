#include "postproc/image/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lib/tool/evaluate.h"
#include "postproc/image/shade.h"
#include "postproc/image/tool_outline.h"

namespace gouge {
namespace {

void cut_mesh(const IndexedMesh& mesh, const SectionPlane& plane, bool is_fixture,
              std::vector<SectionLine>& out) {
  const Vec3 normal = plane.pose.axis.cross(plane.u);
  // Points on the plane count as above it, so that every cut triangle has two cut sides.
  const auto height = [&](const Vec3& p) { return (p - plane.pose.tip).dot(normal) - plane.offset_mm; };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<Vec2, 2> ends{Vec2::Zero(), Vec2::Zero()};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const Vec3& a = mesh.corner(t, k);
      const Vec3& b = mesh.corner(t, (k + 1) % 3);
      const double ha = height(a);
      const double hb = height(b);
      if ((ha >= 0) == (hb >= 0)) continue;
      ends[found++] = plane.flat(Vec3(a + (b - a) * (ha / (ha - hb))));
    }
    if (found == 2) out.push_back({ends[0], ends[1], is_fixture});
  }
}

// Liang and Barsky: the piece of a line inside a box.
std::optional<std::array<Vec2, 2>> clipped(const Vec2& a, const Vec2& b, const Area& box) {
  double t0 = 0;
  double t1 = 1;
  const Vec2 d = b - a;
  const auto cut = [&](double p, double q) {  // keeps p t <= q
    if (p < 0)
      t0 = std::max(t0, q / p);
    else if (p > 0)
      t1 = std::min(t1, q / p);
    else
      return q >= 0;
    return t0 <= t1;
  };
  const bool is_seen = cut(-d.x(), a.x() - box.x) && cut(d.x(), box.right() - a.x()) &&
                       cut(-d.y(), a.y() - box.y) && cut(d.y(), box.bottom() - a.y());
  if (!is_seen || t0 > t1) return std::nullopt;
  return std::array<Vec2, 2>{Vec2(a + t0 * d), Vec2(a + t1 * d)};
}

void clipped_line(Page& page, const Area& box, const Vec2& a, const Vec2& b, const Colour& colour,
                  double width, const std::vector<double>& dashes = {}) {
  if (const auto seen = clipped(a, b, box)) page.line((*seen)[0], (*seen)[1], colour, width, dashes);
}

// Per raster row the places where the material's outline crosses it; an odd number tells nothing and is
// dropped.
std::vector<std::vector<double>> crossings(const SectionPanel& panel, const std::vector<SectionLine>& lines,
                                           int rows) {
  std::vector<std::vector<double>> out(static_cast<std::size_t>(rows));
  for (const SectionLine& line : lines) {
    const Vec2 a = (panel.place(line.a) - Vec2(panel.area.x, panel.area.y)) * kSupersampling;
    const Vec2 b = (panel.place(line.b) - Vec2(panel.area.x, panel.area.y)) * kSupersampling;
    const double low = std::clamp(std::floor(std::min(a.y(), b.y()) - 1), 0.0, static_cast<double>(rows));
    const double high = std::clamp(std::ceil(std::max(a.y(), b.y()) + 1), 0.0, static_cast<double>(rows));
    for (int row = static_cast<int>(low); row < static_cast<int>(high); ++row) {
      const double y = row + 0.5;
      if ((a.y() > y) == (b.y() > y)) continue;
      out[static_cast<std::size_t>(row)].push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  for (std::vector<double>& row : out) {
    if (row.size() % 2 != 0) row.clear();
    std::sort(row.begin(), row.end());
  }
  return out;
}

Body body_at(const std::array<BodyRange, 3>& ranges, double z) {
  for (const Body body : {Body::holder, Body::shank}) {
    const BodyRange& range = ranges[static_cast<std::size_t>(body)];
    if (z >= range.low_mm && z <= range.high_mm) return body;
  }
  return Body::cutter;
}

Raster paint_panel(const SectionPanel& panel, const std::vector<SectionLine>& lines, bool is_closed,
                   const CompiledTool& tool) {
  const int width = static_cast<int>(panel.area.width) * kSupersampling;
  const int height = static_cast<int>(panel.area.height) * kSupersampling;
  Raster raster(width, height, 255, 255, 255);
  const std::vector<std::vector<double>> rows =
      crossings(panel, is_closed ? lines : std::vector<SectionLine>{}, height);
  const std::array<BodyRange, 3> ranges{body_range(tool, Body::cutter), body_range(tool, Body::shank),
                                        body_range(tool, Body::holder)};
  for (int y = 0; y < height; ++y) {
    const std::vector<double>& row = rows[static_cast<std::size_t>(y)];
    std::size_t next = 0;
    for (int x = 0; x < width; ++x) {
      while (next < row.size() && row[next] <= x + 0.5) ++next;
      const bool is_material = next % 2 == 1;
      const Vec2 p(panel.centre.x() + (x + 0.5 - 0.5 * width) / kSupersampling * panel.mm_per_unit,
                   panel.centre.y() - (y + 0.5 - 0.5 * height) / kSupersampling * panel.mm_per_unit);
      const bool is_tool = evaluate(tool, std::abs(p.x()), p.y()).signed_distance_mm < 0;
      if (is_material) {
        const bool is_hatch = (x + y) % 20 < 2;
        blend_pixel(raster, x, y, is_hatch ? Colour{150, 158, 166, 1} : Colour{214, 218, 222, 1}, 1);
      }
      if (is_tool && is_material)
        blend_pixel(raster, x, y, kAlarm, 0.62);
      else if (is_tool)
        blend_pixel(raster, x, y, body_colour(static_cast<int>(body_at(ranges, p.y()))), 0.26);
    }
  }
  return raster;
}

void draw_outline(Page& page, const SectionPanel& panel, const CompiledTool& tool, bool is_dashed) {
  for (const OutlineRun& run : tool_outline(tool)) {
    const Colour colour = is_dashed ? kSoftInk : body_colour(static_cast<int>(run.body));
    for (std::size_t i = 0; i + 1 < run.points.size(); ++i) {
      for (const double side : {1.0, -1.0}) {
        const Vec2 a(side * run.points[i].x(), run.points[i].y());
        const Vec2 b(side * run.points[i + 1].x(), run.points[i + 1].y());
        clipped_line(page, panel.area, panel.place(a), panel.place(b), colour, is_dashed ? 1.2 : 2,
                     is_dashed ? std::vector<double>{6, 4} : std::vector<double>{});
      }
    }
  }
}

bool is_grown(const CompiledTool& bare, const CompiledTool& checked) {
  return std::abs(bare.r_max_mm - checked.r_max_mm) > 1e-9 ||
         std::abs(bare.z_min_mm - checked.z_min_mm) > 1e-9 || bare.elements.size() != checked.elements.size();
}

double length_near(const std::vector<SectionLine>& lines, const Vec2& at, double reach) {
  double length = 0;
  const Area box{at.x() - reach, at.y() - reach, 2 * reach, 2 * reach};
  for (const SectionLine& line : lines) {
    if (const auto seen = clipped(line.a, line.b, box)) length += ((*seen)[1] - (*seen)[0]).norm();
  }
  return length;
}

std::vector<Vec3> around(const Vec3& axis) {
  const Vec3 e1 = axis.cross(std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY()).normalized();
  const Vec3 e2 = axis.cross(e1);
  return {e1, e2, e1 + e2, e1 - e2};
}

}  // namespace

std::vector<SectionLine> cut_scene(const Scene& scene, const SectionPlane& plane) {
  std::vector<SectionLine> out;
  for (const IndexedMesh& mesh : scene.parts) cut_mesh(mesh, plane, false, out);
  for (const IndexedMesh& mesh : scene.fixtures) cut_mesh(mesh, plane, true, out);
  return out;
}

Section make_section(const Scene& scene, const Pose& pose, const Vec3& point_part, double size_mm) {
  const Vec3 d = point_part - pose.tip;
  const Vec3 across = d - pose.axis * d.dot(pose.axis);
  std::vector<Vec3> directions{across};
  if (across.norm() < 1e-6 * size_mm) directions = around(pose.axis);
  Section best;
  double most = -1;
  for (const Vec3& direction : directions) {
    for (const double side : {0.0, 1e-4, -1e-4}) {
      Section one{{pose, direction.normalized(), side * size_mm}, {}};
      one.lines = cut_scene(scene, one.plane);
      const double length = length_near(one.lines, one.plane.flat(point_part), size_mm);
      // The plane itself unless a hair beside it shows clearly more: it ran along a face.
      if (most >= 0 && length <= most + 0.2 * size_mm) continue;
      most = length;
      best = std::move(one);
    }
  }
  return best;
}

void draw_section(Page& page, const SectionPanel& panel, const std::vector<SectionLine>& lines,
                  bool is_closed, const CompiledTool& bare, const CompiledTool& checked) {
  page.rasters.push_back({static_cast<int>(panel.area.x), static_cast<int>(panel.area.y),
                          paint_panel(panel, lines, is_closed, checked.elements.empty() ? bare : checked)});
  for (const SectionLine& line : lines) {
    clipped_line(page, panel.area, panel.place(line.a), panel.place(line.b),
                 line.is_fixture ? Colour{70, 92, 118, 1} : kInk, 1.8);
  }
  draw_outline(page, panel, bare, false);
  if (!checked.elements.empty() && is_grown(bare, checked)) draw_outline(page, panel, checked, true);
  clipped_line(page, panel.area, panel.place({0, bare.z_min_mm - 1e3}), panel.place({0, bare.z_max_mm + 1e3}),
               kSoftInk, 1, {14, 4, 3, 4});
}

}  // namespace gouge
