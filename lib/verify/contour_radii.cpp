#include "lib/verify/contour_radii.h"

#include <algorithm>

#include "lib/verify/bounds.h"

namespace gouge {

namespace {

/// Returns bounds of the radius at which a piece passes a height between its ends.
Bounds radius_at_height(const ToolContour::Piece& p, double z) {
  if (p.is_arc) {
    const Bounds up = Bounds(z) - Bounds(p.center.y());
    const Bounds out = square_root(CGAL::square(Bounds(p.radius_mm)) - CGAL::square(up));
    const bool is_right = p.a.x() + p.b.x() >= 2 * p.center.x();
    return is_right ? Bounds(p.center.x()) + out : Bounds(p.center.x()) - out;
  }
  const Bounds share = (Bounds(z) - Bounds(p.a.y())) / (Bounds(p.b.y()) - Bounds(p.a.y()));
  return Bounds(p.a.x()) + share * (Bounds(p.b.x()) - Bounds(p.a.x()));
}

/// Returns bounds of the radii of a piece between two heights that it has in common with them.
Bounds radii_between(const ToolContour::Piece& p, double low, double high) {
  const Bounds whole(std::min(p.a.x(), p.b.x()), std::max(p.a.x(), p.b.x()));
  if (p.z_lo() >= low && p.z_hi() <= high) return whole;
  const Bounds part = hull(radius_at_height(p, std::max(low, p.z_lo())), radius_at_height(p, std::min(high, p.z_hi())));
  return {std::max(whole.inf(), part.inf()), std::min(whole.sup(), part.sup())};
}

}  // namespace

double free_radius_mm(const ToolContour& tool, double low, double high) {
  if (!tool.has({0, 0.5 * (low + high)})) return -1;
  double radius = tool.largest_radius_mm();
  for (const ToolContour::Piece& p : tool.pieces())
    if (p.z_hi() > low && p.z_lo() < high) radius = std::min(radius, radii_between(p, low, high).inf());
  return radius > 0 ? radius : -1;  // where the contour meets the axis, the axis itself leaves the tool
}

double widest_radius_mm(const ToolContour& tool, double low, double high) {
  double radius = -1;
  for (const ToolContour::Piece& p : tool.pieces())
    if (p.z_hi() >= low && p.z_lo() <= high) radius = std::max(radius, radii_between(p, low, high).sup());
  return radius;
}

}  // namespace gouge
