#pragma once

#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/geom/pose.h"

namespace gouge {

/// A change that undoes one of the usual mistakes by which a path does not match its part. It gives the position of the
/// tool without the mistake, in part coordinates and mm.
struct UndoneMistake {
  std::string text;  ///< text for people that follows "with": "J negated"
  Eigen::Matrix3d tip = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axis = Eigen::Matrix3d::Identity();
  double corner_radii = 0;    ///< shift of the tip along the axis, in radii of the cutter's corner
  double part_scale = 1;      ///< factor of the part's size, about the origin
  bool is_of_tilted = false;  ///< positions with an axis along Z, which files need not state, stay unchanged

  [[nodiscard]] Pose pose(const Pose& given, double corner_radius_mm) const;
};

/// Returns the changes that undo the usual mistakes, the most frequent mistake first.
/// (1) Wrong signs of the tool axis, exchanged components of the axis, and exchanged X, Y, Z.
/// (2) A part turned by quarters about its axes.
/// (3) Positions of the corner's centre read as positions of the tip, and the opposite.
/// (4) Inches read as millimetres and the opposite, for the path in `unit` and for the part.
[[nodiscard]] std::vector<UndoneMistake> usual_mistakes(LengthUnit unit);

}  // namespace gouge
