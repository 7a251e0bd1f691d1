#pragma once

#include <cstddef>

#include "postproc/cldata/interpreting/motion_records.h"

namespace gouge {

/// A position of one statement, before it becomes a move: the file's numbers made mm, in the block's frame.
struct Position {
  Vec3 tip_local = Vec3::Zero();
  Vec3 axis_local = Vec3::UnitZ();
  std::size_t point = 0, points = 1, first_argument = 0, numbers = 0;
  PositionForm form = PositionForm::go_to;
  const char* doubt = nullptr;  ///< why it cannot be checked, whatever the state it is read in
};

inline constexpr const char* kPositionForm = "expected x,y,z or x,y,z,i,j,k";

}  // namespace gouge
