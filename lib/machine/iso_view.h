#pragma once

#include <string>
#include <vector>

#include "lib/drawing/drawing.h"
#include "lib/geom/vec.h"

// An axonometric view, and the shapes of which the drawing of a machine consists.

namespace gouge {

/// Draws in a parallel view: x to the lower right, y to the upper right, z up. Lengths are in picture units.
class IsoView {
 public:
  /// `origin`: place of (0, 0, 0) in the drawing, which must outlive the view.
  IsoView(Drawing& drawing, const Vec2& origin) : drawing_(drawing), origin_(origin) {}

  [[nodiscard]] Vec2 at(const Vec3& point) const;

  void line(const Vec3& from, const Vec3& to, const Colour& colour, double width,
            const std::vector<double>& dashes = {});
  /// Draws a line with a filled head at its end.
  void arrow(const Vec3& from, const Vec3& to, const Colour& colour, double width);
  /// Draws three quarters of a circle about `axis` with a head in the sense of the right-hand rule.
  void turn_arrow(const Vec3& middle, const Vec3& axis, double radius, const Colour& colour, double width);
  /// Draws an upright disc or cylinder: `low` is the middle of its lower end.
  void cylinder(const Vec3& low, double height, double radius, const Colour& fill, const Colour& outline);
  /// Draws a box with edges along the axes.
  void box(const Vec3& low, const Vec3& high, const Colour& fill, const Colour& outline);
  /// Draws a dot, filled or as a ring.
  void dot(const Vec3& at, double radius, const Colour& colour, bool is_filled);
  /// Draws the symbol of a zero point: a circle with two dark quarters.
  void zero_mark(const Vec3& at, double radius, const Colour& colour);
  /// Draws lines of text at the end of a line from `from` to `to`, on the far side. The first line is bold.
  void end_label(const Vec3& from, const Vec3& to, const std::vector<std::string>& lines, const Colour& colour);
  void text(const Vec2& at, const std::string& text, double size, const Colour& colour,
            TextAnchor anchor = TextAnchor::left, bool is_bold = false);

 private:
  void shape(std::vector<Vec2> points, const Colour& fill, const Colour* outline);
  /// Dims the place of a text.
  void clear(const Vec2& place, std::size_t letters, double size, TextAnchor anchor);
  void head(const Vec2& tip, const Vec2& along, const Colour& colour, double size);

  Drawing& drawing_;
  Vec2 origin_;
};

}  // namespace gouge
