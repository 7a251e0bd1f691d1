#include "lib/penetration/turned_axes.h"

#include <limits>

#include "lib/kdop/intervals.h"

namespace gouge {
namespace {

constexpr std::size_t kFloatsPerBlock = 12;

}  // namespace

TurnedAxes::TurnedAxes(const DirectionSet& directions)
    : directions_(directions), stride_(interval_stride(directions.axes.size())), axes_(3 * stride_, 0.0F) {}

void TurnedAxes::turn(const Eigen::Matrix3d& rotation) {
  for (std::size_t i = 0; i < directions_.axes.size(); ++i) {
    const Vec3 turned = rotation.transpose() * directions_.axes[i];
    for (std::size_t k = 0; k < 3; ++k) axes_[k * stride_ + i] = static_cast<float>(turned[static_cast<int>(k)]);
  }
}

void TurnedAxes::bound(const float* blocks, std::size_t count, float* intervals) const {
  for (std::size_t i = 0; i < stride_; ++i) {
    const Float4 x = all4(axes_[i]), y = all4(axes_[stride_ + i]), z = all4(axes_[2 * stride_ + i]);
    Float4 least = all4(std::numeric_limits<float>::max()), most = -least;
    for (std::size_t b = 0; b < count; ++b) {
      const float* const p = blocks + kFloatsPerBlock * b;
      const Float4 at = x * load4(p) + y * load4(p + 4) + z * load4(p + 8);
      least = min4(least, at);
      most = max4(most, at);
    }
    intervals[low_slot(i)] = lowest4(least);
    intervals[high_slot(i)] = highest4(most);
  }
}

}  // namespace gouge
