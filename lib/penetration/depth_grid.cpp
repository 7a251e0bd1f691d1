#include "lib/penetration/depth_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/penetration/depth_body.h"

namespace gouge {
namespace {

constexpr double kMaxCells = 4e6;
constexpr double kFewestCells = 100;  // minimum number along the longest side; with smaller cells fewer points need a
                                      // search
constexpr double kRoundUp = 1 + Tolerance::kRounding;
// Share of the body's slack, which is that of single precision. It covers some roundings of doubles, and the side of a
// border on which a point is found.
constexpr double kRounding = 1e-3;

std::size_t index_of(const std::array<int, 3>& cell, const std::array<int, 3>& counts) {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(counts[1]) + static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(counts[0]) +
         static_cast<std::size_t>(cell[0]);
}

}  // namespace

DepthGrid::DepthGrid(const DepthBody& body) {
  const Box3 box = body.mesh().box();
  const Vec3 size = box.sizes();
  cell_mm_ = std::min(body.options.depth_mm / (std::numbers::sqrt3 * kRoundUp), size.maxCoeff() / kFewestCells);
  const auto cells_at = [&](double cell) {
    return (size.x() / cell + 1) * (size.y() / cell + 1) * (size.z() / cell + 1);
  };
  while (cells_at(cell_mm_) > kMaxCells) cell_mm_ *= 1.2;
  per_mm_ = 1 / cell_mm_;
  low_ = box.min();
  for (int i = 0; i < 3; ++i)
    counts_[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(size[i] / cell_mm_)) + 1;
  cell_count_ = index({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 1;
  std::vector<std::uint8_t> is_near(cell_count_, 0);
  mark_surface(body, is_near);
  const bool is_fine = cell_mm_ * std::numbers::sqrt3 <= body.options.depth_mm;
  std::vector<Cover> results(cell_count_, is_fine ? Cover::shallow : Cover::ask);
  fill(body, is_near, results);
  packed_.assign(cell_count_ / 4 + 1, 0);
  for (std::size_t cell = 0; cell < cell_count_; ++cell) {
    const unsigned bits = static_cast<unsigned>(results[cell]) << (cell % 4 * 2);
    packed_[cell / 4] = static_cast<std::uint8_t>(packed_[cell / 4] | bits);
  }
}

std::size_t DepthGrid::index(const Cell& c) const { return index_of(c, counts_); }

Vec3 DepthGrid::centre(const Cell& c) const { return low_ + cell_mm_ * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5); }

void DepthGrid::mark_surface(const DepthBody& body, std::vector<std::uint8_t>& is_near) const {
  const double half = 0.5 * cell_mm_ * std::numbers::sqrt3 * kRoundUp + kRounding * static_cast<double>(body.slack_mm);
  for (const std::array<Vec3, 3>& facet : body.corners) {
    Box3 box;
    for (const Vec3& corner : facet) box.extend(corner);
    std::array<int, 3> first{}, last{};
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const auto cell = [&](double x) { return static_cast<int>(std::floor((x - low_[i]) / cell_mm_)); };
      first[k] = std::max(0, cell(box.min()[i] - half));
      last[k] = std::min(counts_[k] - 1, cell(box.max()[i] + half));
    }
    for (int z = first[2]; z <= last[2]; ++z) {
      for (int y = first[1]; y <= last[1]; ++y) {
        for (int x = first[0]; x <= last[0]; ++x) {
          std::uint8_t& mark = is_near[index({x, y, z})];
          if (mark != 0) continue;
          if (closest_on_triangle(centre({x, y, z}), facet).distance2_mm2 <= half * half) mark = 1;
        }
      }
    }
  }
}

void DepthGrid::fill(const DepthBody& body, const std::vector<std::uint8_t>& is_near, std::vector<Cover>& results) {
  std::vector<std::uint8_t> is_done = is_near;
  std::vector<std::array<int, 3>> open;
  for (int z = 0; z < counts_[2]; ++z) {
    for (int y = 0; y < counts_[1]; ++y) {
      for (int x = 0; x < counts_[0]; ++x) {
        if (is_done[index({x, y, z})] != 0) continue;
        const auto foot = body.surface.closest_point(centre({x, y, z}));
        const Cover result = foot && foot->is_inside ? Cover::inside : Cover::outside;
        is_done[index({x, y, z})] = 1;
        open.assign(1, {x, y, z});
        while (!open.empty()) {
          const std::array<int, 3> at = open.back();
          open.pop_back();
          results[index(at)] = result;
          for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const int step : {-1, 1}) {
              std::array<int, 3> next = at;
              next[axis] += step;
              if (next[axis] < 0 || next[axis] >= counts_[axis] || is_done[index(next)] != 0) continue;
              is_done[index(next)] = 1;
              open.push_back(next);
            }
          }
        }
      }
    }
  }
}

std::size_t DepthGrid::cell_of(const Vec3& point) const {
  Cell cell{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double at = (point[i] - low_[i]) * per_mm_;
    if (!(at >= 0) || at >= counts_[k]) return cell_count_;
    cell[k] = static_cast<int>(at);
  }
  return index(cell);
}

}  // namespace gouge
