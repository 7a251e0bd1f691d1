#pragma once

#include <vector>

#include "lib/check/scene.h"
#include "lib/geom/pose.h"
#include "postproc/image/page.h"

namespace gouge {

/// The half planes of the tool in which a section is seen: u away from the axis, v along it, origin at the
/// tip.
struct SectionPlane {
  Pose pose;
  Vec3 u = Vec3::UnitX();  ///< unit, square to the axis
  double offset_mm = 0;    ///< of the cutting plane from the axis: a hair, where it would run along a face
  [[nodiscard]] Vec2 flat(const Vec3& p) const {
    const Vec3 d = p - pose.tip;
    return {d.dot(u), d.dot(pose.axis)};
  }
};

struct SectionLine {
  Vec2 a, b;
  bool is_fixture = false;
};
/// Where the plane cuts the triangles.
[[nodiscard]] std::vector<SectionLine> cut_scene(const Scene& scene, const SectionPlane& plane);

struct Section {
  SectionPlane plane;
  std::vector<SectionLine> lines;
};
/// The section through the tool's axis and a surface point, which lies on the side of positive u. A point on
/// the axis leaves the plane open: then the one that shows most of the scene within `size_mm` of the point.
[[nodiscard]] Section make_section(const Scene& scene, const Pose& pose, const Vec3& point_part,
                                   double size_mm);

/// What one section panel shows.
struct SectionPanel {
  Area area;
  Vec2 centre = Vec2::Zero();  ///< of the plane, in the middle of the panel
  double mm_per_unit = 1;
  [[nodiscard]] Vec2 place(const Vec2& p) const {
    return {area.middle().x() + (p.x() - centre.x()) / mm_per_unit,
            area.middle().y() - (p.y() - centre.y()) / mm_per_unit};
  }
};

/// Paints material (only where `is_closed`, else just its outline), the tool and where both overlap, with the
/// outline that was checked dashed where clearances or stock to leave make it larger than the tool.
void draw_section(Page& page, const SectionPanel& panel, const std::vector<SectionLine>& lines,
                  bool is_closed, const CompiledTool& bare, const CompiledTool& checked);

}  // namespace gouge
