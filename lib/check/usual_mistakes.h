#pragma once

#include <string>
#include <vector>

#include "lib/base/units.h"
#include "lib/geom/pose.h"

namespace gouge {

/// One of the usual mistakes with which a path and a part do not belong together, undone: where the tool
/// would be without it. Part coordinates, mm.
struct UndoneMistake {
  std::string text;  ///< to follow "with", for people: "J negated"
  Eigen::Matrix3d tip = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d axis = Eigen::Matrix3d::Identity();
  double corner_radii = 0;    ///< how many radii of the cutter's corner the tip goes along the axis
  double part_scale = 1;      ///< the part's size, about the origin
  bool is_of_tilted = false;  ///< positions with an axis along Z, which files need not write, stay as they are

  [[nodiscard]] Pose pose(const Pose& given, double corner_radius_mm) const;
};

/// Returns the usual mistakes, those most easily made first.
/// (1) Signs of the tool axis, its components exchanged, and X, Y, Z exchanged.
/// (2) The part turned by quarters about its axes.
/// (3) Positions of the centre of the corner taken as the tip, and the other way round.
/// (4) Inches and millimetres, of the path in `unit` and of the part.
[[nodiscard]] std::vector<UndoneMistake> usual_mistakes(LengthUnit unit);

}  // namespace gouge
