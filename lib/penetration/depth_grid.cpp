#include "lib/penetration/depth_grid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/penetration/depth_body.h"
#include "lib/penetration/nearest_foot.h"

namespace gouge {
namespace {

constexpr double kMostCells = 4e6;
constexpr double kFewestCells = 100;  // along the longest side: the finer, the fewer points need a search
constexpr double kRoundUp = 1 + 1e-9;
// Of the body's slack, which is single precision's: some roundings of doubles, on which side of a border a
// point is found.
constexpr double kRounding = 1e-3;
constexpr double kBlocks = 32;  // along the longest side

std::size_t place_of(const std::array<int, 3>& cell, const std::array<int, 3>& counts) {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(counts[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(counts[0]) +
         static_cast<std::size_t>(cell[0]);
}

}  // namespace

DepthGrid::DepthGrid(const DepthBody& body) {
  const Box3 box = body.mesh.box();
  const Vec3 size = box.sizes();
  cell_mm_ =
      std::min(body.options.depth_mm / (std::numbers::sqrt3 * kRoundUp), size.maxCoeff() / kFewestCells);
  const auto cells_at = [&](double cell) {
    return (size.x() / cell + 1) * (size.y() / cell + 1) * (size.z() / cell + 1);
  };
  while (cells_at(cell_mm_) > kMostCells) cell_mm_ *= 1.2;
  per_mm_ = 1 / cell_mm_;
  low_ = box.min();
  for (int i = 0; i < 3; ++i)
    counts_[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(size[i] / cell_mm_)) + 1;
  high_ = box.max();
  cell_count_ = index({counts_[0] - 1, counts_[1] - 1, counts_[2] - 1}) + 1;
  std::vector<std::uint8_t> is_near(cell_count_, 0);
  mark_surface(body, is_near);
  const bool is_fine = cell_mm_ * std::numbers::sqrt3 <= body.options.depth_mm;
  std::vector<Answer> answers(cell_count_, is_fine ? Answer::shallow : Answer::ask);
  fill(body, is_near, answers);
  packed_.assign(cell_count_ / 4 + 1, 0);
  for (std::size_t cell = 0; cell < cell_count_; ++cell) {
    const unsigned bits = static_cast<unsigned>(answers[cell]) << (cell % 4 * 2);
    packed_[cell / 4] = static_cast<std::uint8_t>(packed_[cell / 4] | bits);
  }
  if (body.options.has_cells) measure_clearance(body);
}

std::size_t DepthGrid::index(const Cell& c) const {
  return place_of(c, counts_);
}

Vec3 DepthGrid::centre(const Cell& c) const {
  return low_ + cell_mm_ * Vec3(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
}

void DepthGrid::mark_surface(const DepthBody& body, std::vector<std::uint8_t>& is_near) const {
  const double half =
      0.5 * cell_mm_ * std::numbers::sqrt3 * kRoundUp + kRounding * static_cast<double>(body.slack_mm);
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

void DepthGrid::fill(const DepthBody& body, const std::vector<std::uint8_t>& is_near,
                     std::vector<Answer>& answers) {
  std::vector<std::uint8_t> is_done = is_near;
  std::vector<std::array<int, 3>> open;
  for (int z = 0; z < counts_[2]; ++z) {
    for (int y = 0; y < counts_[1]; ++y) {
      for (int x = 0; x < counts_[0]; ++x) {
        if (is_done[index({x, y, z})] != 0) continue;
        const auto foot = nearest_foot(body, centre({x, y, z}));
        const Answer answer = foot && foot->is_inside ? Answer::inside : Answer::outside;
        is_done[index({x, y, z})] = 1;
        open.assign(1, {x, y, z});
        while (!open.empty()) {
          const std::array<int, 3> at = open.back();
          open.pop_back();
          answers[index(at)] = answer;
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

/// Blocks whose middle is outside by more than half their diagonal.
void DepthGrid::measure_clearance(const DepthBody& body) {
  const Vec3 size = high_ - low_;
  block_mm_ = std::max(cell_mm_, size.maxCoeff() / kBlocks);
  per_block_mm_ = 1 / block_mm_;
  for (int i = 0; i < 3; ++i)
    block_counts_[static_cast<std::size_t>(i)] = static_cast<int>(std::floor(size[i] / block_mm_)) + 1;
  const double half =
      0.5 * block_mm_ * std::numbers::sqrt3 * kRoundUp + kRounding * static_cast<double>(body.slack_mm);
  for (int z = 0; z < block_counts_[2]; ++z) {
    for (int y = 0; y < block_counts_[1]; ++y) {
      for (int x = 0; x < block_counts_[0]; ++x) {
        const auto foot = nearest_foot(body, low_ + block_mm_ * Vec3(x + 0.5, y + 0.5, z + 0.5));
        const double clear = foot && !foot->is_inside ? foot->distance_mm - half : 0;
        clear_.push_back(std::max(0.0F, static_cast<float>(clear * (1 - 1e-6))));
      }
    }
  }
}

double DepthGrid::clear_mm(const Vec3& point) const {
  if (clear_.empty()) return 0;
  const Vec3 near = point.cwiseMax(low_).cwiseMin(high_);
  Cell block{};
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    block[k] = std::min(block_counts_[k] - 1, static_cast<int>((near[i] - low_[i]) * per_block_mm_));
  }
  const auto clear = static_cast<double>(clear_[place_of(block, block_counts_)]);
  const double away2 = (point - near).squaredNorm();
  if (!(away2 > 0)) return clear;
  const double away = std::sqrt(away2);
  return std::max(away, clear - away);
}

void DepthGrid::cells_of(const RigidTransform& pose, const double* x, const double* y, const double* z,
                         std::size_t count, std::int32_t* cells) const {
  const Eigen::Matrix3d turn = per_mm_ * pose.rotation;
  const Vec3 shift = per_mm_ * (pose.shift - low_);
  const double xx = turn(0, 0), xy = turn(0, 1), xz = turn(0, 2), x0 = shift.x();
  const double yx = turn(1, 0), yy = turn(1, 1), yz = turn(1, 2), y0 = shift.y();
  const double zx = turn(2, 0), zy = turn(2, 1), zz = turn(2, 2), z0 = shift.z();
  const double nx = counts_[0], ny = counts_[1], nz = counts_[2], none = static_cast<double>(cell_count_);
  const auto whole = [](double a) { return static_cast<double>(static_cast<std::int32_t>(a)); };
  for (std::size_t i = 0; i < count; ++i) {
    const double a = xx * x[i] + xy * y[i] + xz * z[i] + x0;
    const double b = yx * x[i] + yy * y[i] + yz * z[i] + y0;
    const double c = zx * x[i] + zy * y[i] + zz * z[i] + z0;
    const bool is_within = (a >= 0) & (a < nx) & (b >= 0) & (b < ny) & (c >= 0) & (c < nz);
    const double u = is_within ? a : 0, v = is_within ? b : 0, w = is_within ? c : 0;
    const double cell = whole(u) + nx * (whole(v) + ny * whole(w));
    cells[i] = static_cast<std::int32_t>(is_within ? cell : none);
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
