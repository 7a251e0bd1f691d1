#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "lib/check/prepared_scene.h"
#include "lib/geom/pose.h"
#include "lib/head/head_body.h"
#include "postproc/image/page.h"

namespace gouge {

/// A plane along the tool axis in which a section is seen. Its coordinates are u, away from the axis, and v, along the
/// axis. v = 0 is at the height of the tip.
struct SectionPlane {
  Pose pose;
  Vec3 u = Vec3::UnitX();  ///< unit vector, perpendicular to the axis
  double beside_mm = 0;    ///< distance of the plane from the axis, towards axis x u; 0: through it
  /// distance at which it cuts: beside_mm, or slightly more or less if the plane would run along a face
  double offset_mm = 0;
  [[nodiscard]] Vec2 flat(const Vec3& p) const {
    const Vec3 d = p - pose.tip;
    return {d.dot(u), d.dot(pose.axis)};
  }
};

struct SectionLine {
  Vec2 a, b;
  bool is_fixture = false;
};
/// Returns the lines in which the plane cuts the triangles.
[[nodiscard]] std::vector<SectionLine> cut_scene(const PreparedScene& scene, const SectionPlane& plane);

/// Returns these lines for each of several bodies, at the place to which `to_part` moves them.
[[nodiscard]] std::vector<std::vector<SectionLine>> cut_heads(std::span<const HeadBody> heads,
                                                              const RigidTransform& to_part, const SectionPlane& plane);

struct Section {
  SectionPlane plane;
  std::vector<SectionLine> lines;               ///< lines of the scene
  std::vector<std::vector<SectionLine>> heads;  ///< one list for each head, because heads may overlap
};
/// Makes the section through the tool's axis and a surface point, which has a positive u. A point on the axis leaves
/// the plane open. Then the plane is the one that shows most of the scene within `size_mm` of the point.
///
/// If `way_out` is given, the section shows it. The way out of a tool lies in that plane, but that of a head may not.
/// Then the plane runs through the point, along the axis and the direction, beside the axis. Heads are not cut.
[[nodiscard]] Section make_section(const PreparedScene& scene, const Pose& pose, const Vec3& point_part, double size_mm,
                                   const std::optional<Vec3>& way_out = std::nullopt);

/// Returns the piece of a line inside a box, if any.
[[nodiscard]] std::optional<std::array<Vec2, 2>> clipped(const Vec2& a, const Vec2& b, const Area& box);

}  // namespace gouge
