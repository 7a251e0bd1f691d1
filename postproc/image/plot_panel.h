#pragma once

#include <vector>

#include "lib/base/units.h"
#include "lib/drawing/drawing.h"
#include "lib/geom/vec.h"
#include "lib/mesh/indexed_mesh.h"

// The panels of a plot: views along a direction at a scale, with the frame around a path and the parts behind it.

namespace gouge {

/// A view in a rectangle of a drawing. `right` and `up` are perpendicular unit vectors; y points down in the drawing.
struct PlotPanel {
  double x = 0, y = 0, width = 0, height = 0;
  const char* name = "";
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY();
  double scale = 1;  ///< drawing units for a millimetre
  Vec2 shift = Vec2::Zero();

  [[nodiscard]] Vec2 flat(const Vec3& p) const { return {p.dot(right), -p.dot(up)}; }
  [[nodiscard]] Vec2 at(const Vec3& p) const { return scale * flat(p) + shift; }
  /// Returns whether the view is along a coordinate axis. Then ticks at the edges state coordinates.
  [[nodiscard]] bool is_along_axes() const;
  /// Scales and shifts the view so that `box` fits between the margins.
  void fit(const Box3& box);
};

/// Draws the frame with its name. A panel along an axis gets ticks with their coordinates along the edges. Any other
/// panel gets the directions of x, y and z. Both have a bar of a round length. Coordinates are in `unit`.
void draw_frame(const PlotPanel& panel, LengthUnit unit, Drawing& drawing);

/// Draws the parts as shaded surfaces, the nearest on top, in cells of two units. So the size of the panel, not the
/// meshes, bounds the memory. Cost: O(triangles + cells that they cover).
void draw_parts(const PlotPanel& panel, const std::vector<IndexedMesh>& parts, Drawing& drawing);

/// Returns the largest of 1, 2 and 5 times a power of ten that is at most `length` > 0.
[[nodiscard]] double round_length(double length);

}  // namespace gouge
