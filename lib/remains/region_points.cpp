#include "lib/remains/region_points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "lib/remains/region_proof.h"

namespace gouge {

namespace {

using Matrix3 = Eigen::Matrix3d;

constexpr std::size_t kPointChunk = 256;
// How far points are moved back to the region each time that its proof fails, as a share of the whole way.
constexpr std::array<double, 4> kPulls{0, 0.3, 0.65, 1};
// Points keep away from the corners of their cell by half of the inset, between these shares of the cell.
constexpr double kMinMargin = 0.005, kMaxMargin = 0.05;
// Directions of a feature count if they are at least this strong, of the strongest.
constexpr double kFeature = 0.08;
// Corners of lower values are no seams, in insets.
constexpr double kSeamInsets = 1.1;
constexpr int kCrossingSteps = 7;

}  // namespace

RegionPoints::RegionPoints(const CellGrid& grid, const StockSide& side, double inset_mm)
    : grid_(grid),
      side_(side),
      inset_mm_(inset_mm),
      within_mm_(grid.size.maxCoeff() + 2 * inset_mm),
      margin_(std::clamp(0.5 * inset_mm / grid.size.maxCoeff(), kMinMargin, kMaxMargin)) {}

// Cuts that abut have a seam between them. A corner near the seam of two cuts is in the region all the same.
double RegionPoints::value_at(const Vec3& corner) const {
  const double value = side_.at(corner, within_mm_).mm;
  if (value > 0 || value < -kSeamInsets * inset_mm_ || !side_.has_slivers() || !side_.is_proved()) return value;
  const Vec3 about = Vec3::Constant(2 * inset_mm_);
  RegionProof proof(side_, inset_mm_, RegionProof::Kind::widened);
  return proof.holds(HullRegion::box(corner - about, corner + about)) ? 2 * inset_mm_ : value;
}

std::vector<std::uint64_t> RegionPoints::add_corners(const Keys& corners, const CellWork& work) {
  Keys missing;
  for (const std::uint64_t key : corners)
    if (!corners_.contains(key)) missing.push_back(key);
  std::ranges::sort(missing);
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  std::vector<double> values(missing.size());
  for_each_chunk(missing.size(), kPointChunk, work.threads, "measuring the stock", work.progress,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i)
                     values[i] = value_at(grid_.corner(grid_index(missing[i])));
                 });
  for (std::size_t i = 0; i < missing.size(); ++i) corners_[missing[i]] = {values[i], values[i] > 0};
  return missing;
}

unsigned RegionPoints::corners_in(const GridIndex& cell) const {
  unsigned bits = 0;
  for (unsigned k = 0; k < 8; ++k)
    if (is_in(corner_of(cell, k))) bits |= 1U << k;
  return bits;
}

// The value falls from a positive one to a negative one, unless a corner was taken out of the region.
RegionPoints::EdgePoint RegionPoints::cross(const GridIndex& corner, std::size_t axis) const {
  GridIndex from = corner, to = moved(corner, axis, 1);
  if (!is_in(from)) std::swap(from, to);
  const Vec3 a = grid_.corner(from), b = grid_.corner(to);
  double low = 0, high = 1, at_low = corners_.at(grid_key(from)).value_mm, at_high = corners_.at(grid_key(to)).value_mm;
  const auto value = [&](double t) { return side_.at(a + t * (b - a), within_mm_); };
  for (int k = 1; k < 4 && at_high >= 0; ++k) {
    high = 0.25 * k;
    at_high = value(high).mm;
  }
  if (at_high >= 0) {
    constexpr double kHalf = 0.5;
    return {a + kHalf * (b - a), value(kHalf).rise};
  }
  double t = 0.5;
  StockSide::Value here;
  for (int k = 0; k < kCrossingSteps; ++k) {
    // By the secant, but by halves where that hardly moves an end.
    const double secant = low + (high - low) * at_low / (at_low - at_high);
    t = k % 3 == 2 ? 0.5 * (low + high) : secant;
    here = value(t);
    constexpr double kNear_mm = 1e-4;
    if (std::abs(here.mm) < kNear_mm) break;
    if (here.mm > 0) {
      low = t, at_low = here.mm;
    } else {
      high = t, at_high = here.mm;
    }
  }
  t = std::clamp(t, margin_, 1 - margin_);
  return {a + t * (b - a), here.rise};
}

// The point nearest to the tangent planes at the edges (Kobbelt et al., Feature sensitive surface extraction, 2001).
Vec3 RegionPoints::feature_of(const GridIndex& cell) const {
  Vec3 mean = Vec3::Zero();
  std::vector<const EdgePoint*> points;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned k = 0; k < 8; ++k) {
      if ((k >> axis & 1U) != 0) continue;
      const GridIndex corner = corner_of(cell, k);
      if (is_in(corner) == is_in(moved(corner, axis, 1))) continue;
      points.push_back(&edges_[axis].at(grid_key(corner)));
      mean += points.back()->at;
    }
  }
  mean /= static_cast<double>(points.size());
  Matrix3 square = Matrix3::Zero();
  Vec3 right = Vec3::Zero();
  for (const EdgePoint* point : points) {
    square += point->rise * point->rise.transpose();
    right += point->rise * point->rise.dot(point->at - mean);
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(square);
  const double strongest = solver.eigenvalues().maxCoeff();
  Vec3 feature = mean;
  for (int k = 0; k < 3; ++k) {
    if (!(solver.eigenvalues()[k] > kFeature * strongest)) continue;
    const Vec3 direction = solver.eigenvectors().col(k);
    feature += direction * (direction.dot(right) / solver.eigenvalues()[k]);
  }
  return kept_within(cell, feature);
}

Vec3 RegionPoints::kept_within(const GridIndex& cell, const Vec3& point) const {
  const Vec3 low = grid_.corner(cell), inset = margin_ * grid_.size;
  return point.cwiseMax(low + inset).cwiseMin(low + grid_.size - inset);
}

void RegionPoints::add_points(const Keys& cells, const CellWork& work) {
  std::array<Keys, 3> edges;
  Keys without;
  for (const std::uint64_t key : cells) {
    if (features_.contains(key)) continue;
    without.push_back(key);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (unsigned k = 0; k < 8; ++k) {
        if ((k >> axis & 1U) != 0) continue;
        const GridIndex corner = corner_of(grid_index(key), k);
        if (is_in(corner) != is_in(moved(corner, axis, 1)) && !edges_[axis].contains(grid_key(corner)))
          edges[axis].push_back(grid_key(corner));
      }
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::ranges::sort(edges[axis]);
    edges[axis].erase(std::unique(edges[axis].begin(), edges[axis].end()), edges[axis].end());
    std::vector<EdgePoint> points(edges[axis].size());
    for_each_chunk(points.size(), kPointChunk, work.threads, "measuring the stock", work.progress,
                   [&](std::size_t first, std::size_t last) {
                     for (std::size_t i = first; i < last; ++i) points[i] = cross(grid_index(edges[axis][i]), axis);
                   });
    for (std::size_t i = 0; i < points.size(); ++i) edges_[axis][edges[axis][i]] = points[i];
  }
  for (const std::uint64_t key : without) features_[key] = feature_of(grid_index(key));
}

void RegionPoints::take_out(std::uint64_t corner) {
  corners_.at(corner).is_in = false;
  const GridIndex at = grid_index(corner);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    edges_[axis].erase(corner);
    edges_[axis].erase(grid_key(moved(at, axis, -1)));
  }
  for (unsigned k = 0; k < 8; ++k) features_.erase(grid_key(corner_of({at[0] - 1, at[1] - 1, at[2] - 1}, k)));
}

bool RegionPoints::can_pull_back(const GridIndex& cell) const {
  return pull_of(cell) + 1 < static_cast<int>(kPulls.size());
}

bool RegionPoints::pull_back(const GridIndex& cell) {
  if (!can_pull_back(cell)) return false;
  ++pulls_[grid_key(cell)];
  return true;
}

int RegionPoints::pull_of(const GridIndex& cell) const {
  const auto found = pulls_.find(grid_key(cell));
  return found == pulls_.end() ? 0 : found->second;
}

Vec3 RegionPoints::on_edge(const GridIndex& corner, std::size_t axis) const {
  const Vec3 at = edges_[axis].at(grid_key(corner)).at;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  int pull = 0;
  for (const std::int32_t du : {-1, 0})
    for (const std::int32_t dv : {-1, 0}) pull = std::max(pull, pull_of(moved(moved(corner, u, du), v, dv)));
  if (pull == 0) return at;
  const bool is_first = is_in(corner);
  const Vec3 a = grid_.corner(corner), b = grid_.corner(moved(corner, axis, 1));
  const Vec3 goal = is_first ? Vec3(a + margin_ * (b - a)) : Vec3(b + margin_ * (a - b));
  return at + kPulls[static_cast<std::size_t>(pull)] * (goal - at);
}

Vec3 RegionPoints::in_cell(const GridIndex& cell) const {
  const Vec3 at = features_.at(grid_key(cell));
  const int pull = pull_of(cell);
  if (pull == 0) return at;
  Vec3 goal = Vec3::Zero();
  double count = 0;
  for (unsigned k = 0; k < 8; ++k) {
    if (!is_in(corner_of(cell, k))) continue;
    goal += grid_.corner(corner_of(cell, k));
    ++count;
  }
  return at + kPulls[static_cast<std::size_t>(pull)] * (kept_within(cell, goal / count) - at);
}

RegionPoints::FacePoint RegionPoints::on_face(const GridIndex& cell, std::size_t axis) const {
  const GridIndex before = moved(cell, axis, -1);
  const auto k = static_cast<Eigen::Index>(axis);
  const Vec3 a = in_cell(before), b = in_cell(cell), low = grid_.corner(cell);
  const double plane = low[k];
  const double t = (plane - a[k]) / (b[k] - a[k]);
  Vec3 at = a + t * (b - a);
  at[k] = plane;
  Vec3 kept = kept_within(cell, at);
  kept[k] = plane;
  const bool is_kept = (kept - at).isZero(0);
  const int pull = std::max(pull_of(before), pull_of(cell));
  if (pull == 0) return {kept, is_kept};
  Vec3 goal = Vec3::Zero();
  double count = 0;
  for (unsigned n = 0; n < 8; ++n) {
    if ((n >> axis & 1U) != 0 || !is_in(corner_of(cell, n))) continue;
    goal += grid_.corner(corner_of(cell, n));
    ++count;
  }
  goal = kept_within(cell, goal / count);
  goal[k] = plane;
  return {kept + kPulls[static_cast<std::size_t>(pull)] * (goal - kept), false};
}

std::vector<HullRegion> RegionPoints::pieces(const GridIndex& cell) const {
  const unsigned in = corners_in(cell);
  if (in == 0) return {};
  if (in == 0xffU) return {HullRegion::box(grid_.corner(cell), grid_.corner(corner_of(cell, 7)))};
  std::vector<HullRegion> all;
  const Vec3 v = in_cell(cell);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, w = (axis + 2) % 3;
    for (const std::int32_t side : {0, 1}) {
      const GridIndex face = moved(cell, axis, side);
      const std::array<GridIndex, 4> ring{face, moved(face, u, 1), moved(moved(face, u, 1), w, 1), moved(face, w, 1)};
      std::array<bool, 4> is{};
      for (std::size_t k = 0; k < 4; ++k) is[k] = is_in(ring[k]);
      const auto count = std::ranges::count(is, true);
      if (count == 0) continue;
      const auto at = [&](std::size_t k) { return grid_.corner(ring[k % 4]); };
      if (count == 4) {
        all.push_back(HullRegion::tetrahedron({at(0), at(1), at(2), v}));
        all.push_back(HullRegion::tetrahedron({at(0), at(2), at(3), v}));
        continue;
      }
      const Vec3 f = on_face(face, axis).at;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        if (!is[k] && !is[next]) continue;
        if (is[k] && is[next]) {
          all.push_back(HullRegion::tetrahedron({at(k), at(next), f, v}));
          continue;
        }
        const std::size_t along = k % 2 == 0 ? u : w;
        const Vec3 e = on_edge(k < 2 ? ring[k] : ring[next], along);
        all.push_back(HullRegion::tetrahedron({at(is[k] ? k : next), e, f, v}));
      }
    }
  }
  return all;
}

}  // namespace gouge
