#include "lib/kdop/directions.h"

#include <cassert>

namespace gouge {

DirectionSet cube_directions(std::size_t k) {
  assert(k == 6 || k == 14 || k == 18 || k == 26);
  DirectionSet set{{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}};
  const auto add = [&](std::initializer_list<Vec3> axes) {
    for (const Vec3& axis : axes) set.axes.push_back(axis.normalized());
  };
  if (k == 14 || k == 26) add({Vec3(1, 1, 1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)});
  if (k == 18 || k == 26)
    add({Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(1, 0, 1), Vec3(1, 0, -1), Vec3(0, 1, 1), Vec3(0, 1, -1)});
  return set;
}

}  // namespace gouge
