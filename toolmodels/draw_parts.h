#pragma once

#include <string>
#include <vector>

#include "lib/drawing/drawing.h"
#include "lib/tool/compiled_tool.h"
#include "toolmodels/profile.h"

// Parts of which drawings of tools consist.

namespace gouge::detail {

/// The map from the half plane (r, z) in mm to a panel of the picture; a negative r is in the mirrored half.
struct ProfileView {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();  ///< window of the half plane
  Vec2 origin = Vec2::Zero();                    ///< picture point of r = 0, z = 0
  double scale = 1;                              ///< picture units per mm

  [[nodiscard]] Vec2 at(const Vec2& rz) const { return origin + scale * Vec2(rz.x(), -rz.y()); }
  [[nodiscard]] Vec2 mirrored(const Vec2& rz) const { return at(Vec2(-rz.x(), rz.y())); }
};

[[nodiscard]] Colour body_colour(Body body);
/// Returns the colour mixed with white: amount 0 keeps the colour, amount 1 gives white.
[[nodiscard]] Colour lightened(const Colour& colour, double amount);

void draw_line(Drawing& drawing, const Vec2& from, const Vec2& to, const Colour& colour, double width,
               const std::vector<double>& dashes = {});
void draw_text(Drawing& drawing, const Vec2& at, const std::string& text, double size, TextAnchor anchor,
               bool is_bold = false);
/// Draws an arrow with a filled head.
void draw_arrow(Drawing& drawing, const Vec2& from, const Vec2& to, const Colour& colour, double width);

/// Draws the regions within the view's window: as tinted areas, then their bisectors as lines. `with_outside` adds the
/// regions outside the contour.
void draw_regions(Drawing& drawing, const CompiledTool& tool, const ProfileView& view, bool with_outside);
/// Draws short arrows inside the tool, on a grid of `spacing` picture units. Each points along the shortest way out.
void draw_exit_arrows(Drawing& drawing, const CompiledTool& tool, const ProfileView& view, double spacing);
/// Draws the contour within the view's window.
void draw_contour(Drawing& drawing, const Profile& profile, const ProfileView& view, double width);

}  // namespace gouge::detail
