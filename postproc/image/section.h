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

/// A plane along the tool axis in which a section is seen. Away from the axis is u, along it v; v = 0 is at the tip's
/// height.
struct SectionPlane {
  Pose pose;
  Vec3 u = Vec3::UnitX();  ///< unit, square to the axis
  double beside_mm = 0;    ///< of the plane from the axis, towards axis x u; 0: through it
  double offset_mm = 0;    ///< where it cuts: beside_mm, or a hair off where it would run along a face
  [[nodiscard]] Vec2 flat(const Vec3& p) const {
    const Vec3 d = p - pose.tip;
    return {d.dot(u), d.dot(pose.axis)};
  }
};

struct SectionLine {
  Vec2 a, b;
  bool is_fixture = false;
};
/// Returns where the plane cuts the triangles.
[[nodiscard]] std::vector<SectionLine> cut_scene(const PreparedScene& scene, const SectionPlane& plane);

/// Returns the same of bodies that `to_part` places, one after another.
[[nodiscard]] std::vector<std::vector<SectionLine>> cut_heads(std::span<const HeadBody> heads,
                                                              const RigidTransform& to_part, const SectionPlane& plane);

struct Section {
  SectionPlane plane;
  std::vector<SectionLine> lines;               ///< of the scene
  std::vector<std::vector<SectionLine>> heads;  ///< each a body of its own: they may overlap
};
/// Makes the section through the tool's axis and a surface point, which lies on the side of positive u. A point on the
/// axis leaves the plane open. Then it is the one that shows most of the scene within `size_mm` of the point.
///
/// Where `way_out` is given the section shows it. A tool's way out lies in that plane, but a head's may not. Then the
/// plane runs through the point and along the axis and the direction, beside the axis. Heads are not cut.
[[nodiscard]] Section make_section(const PreparedScene& scene, const Pose& pose, const Vec3& point_part, double size_mm,
                                   const std::optional<Vec3>& way_out = std::nullopt);

/// Returns the piece of a line inside a box, if any.
[[nodiscard]] std::optional<std::array<Vec2, 2>> clipped(const Vec2& a, const Vec2& b, const Area& box);

}  // namespace gouge
