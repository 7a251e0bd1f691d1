#include "tests/bench/penetration/clearance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr double kBlocks = 32;  // along the longest side
constexpr double kRoundUp = 1 + 1e-9;
constexpr double kRounding = 1e-3;  // of the body's slack, which is single precision's: some roundings of doubles

std::size_t place_of(const std::array<int, 3>& block, const std::array<int, 3>& counts) {
  return (static_cast<std::size_t>(block[2]) * static_cast<std::size_t>(counts[1]) +
          static_cast<std::size_t>(block[1])) *
             static_cast<std::size_t>(counts[0]) +
         static_cast<std::size_t>(block[0]);
}

}  // namespace

/// For blocks whose middle is outside by more than half their diagonal.
Clearance::Clearance(const DepthBody& body) : low_(body.mesh().box().min()), high_(body.mesh().box().max()) {
  const Vec3 size = high_ - low_;
  block_mm_ = std::max(body.depths.cell_mm(), size.maxCoeff() / kBlocks);
  for (int i = 0; i < 3; ++i)
    counts_[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(size[i] / block_mm_)) + 1;
  const double half = 0.5 * block_mm_ * std::numbers::sqrt3 * kRoundUp + kRounding * static_cast<double>(body.slack_mm);
  for (int z = 0; z < counts_[2]; ++z) {
    for (int y = 0; y < counts_[1]; ++y) {
      for (int x = 0; x < counts_[0]; ++x) {
        const auto foot = body.surface.closest_point(low_ + block_mm_ * Vec3(x + 0.5, y + 0.5, z + 0.5));
        const double clear = foot && !foot->is_inside ? foot->distance_mm - half : 0;
        clear_.push_back(std::max(0.0F, static_cast<float>(clear * (1 - 1e-6))));
      }
    }
  }
}

double Clearance::at(const Vec3& point) const {
  const Vec3 near = point.cwiseMax(low_).cwiseMin(high_);
  std::array<int, 3> block{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    block[k] = std::min(counts_[k] - 1, static_cast<int>((near[i] - low_[i]) / block_mm_));
  }
  const auto clear = static_cast<double>(clear_[place_of(block, counts_)]);
  const double away2 = (point - near).squaredNorm();
  if (!(away2 > 0)) return clear;
  const double away = std::sqrt(away2);
  return std::max(away, clear - away);
}

}  // namespace gouge
