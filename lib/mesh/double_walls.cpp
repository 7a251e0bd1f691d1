#include "lib/mesh/double_walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gouge {
namespace {

// Two sheets that are nearer to each other than this share of the mesh's size are the same wall written twice.
constexpr double kMinWall = 5e-5;
// Cosines of the angle between two sheets, in this order: of a possible double wall (45 degrees), of sheets that lie on
// each other (30 degrees), of a fold without material (2 degrees).
constexpr double kAny = 0.7071, kParallel = 0.866, kFolded = 0.99939;
// Because of rounding, triangles side by side may overlap by less than this share of the smaller one.
constexpr double kMinOverlap = 1e-3;
constexpr std::size_t kLeafSize = 24;

/// The part of one triangle that lies over another one. Its corners have x, y along the other's plane and z above it.
class Overlap {
 public:
  Overlap(const std::array<Vec3, 3>& base, const std::array<Vec3, 3>& other, const Vec3& normal) {
    const Vec3 e1 = (base[1] - base[0]).normalized(), e2 = normal.cross(e1);
    const auto flat = [&](const Vec3& p) {
      const Vec3 v = p - base[0];
      return Vec3(v.dot(e1), v.dot(e2), v.dot(normal));
    };
    for (const Vec3& p : other) polygon_.push_back(flat(p));
    other_area_ = area();
    const std::array<Vec3, 3> own{flat(base[0]), flat(base[1]), flat(base[2])};
    for (std::size_t k = 0; k < 3 && !polygon_.empty(); ++k) cut(own[k], own[(k + 1) % 3]);
  }

  [[nodiscard]] bool is_larger_than_rounding(double base_area) const {
    return polygon_.size() > 2 && area() > kMinOverlap * std::min(base_area, other_area_);
  }
  [[nodiscard]] double mean_height() const {
    double sum = 0;
    for (const Vec3& p : polygon_) sum += p.z();
    return std::abs(sum / static_cast<double>(polygon_.size()));
  }
  [[nodiscard]] double min_height() const {
    double low = polygon_[0].z(), high = low;
    for (const Vec3& p : polygon_) low = std::min(low, p.z()), high = std::max(high, p.z());
    return std::max({0.0, low, -high});
  }

 private:
  [[nodiscard]] double area() const {
    double twice = 0;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vec3 &p = polygon_[i], &q = polygon_[(i + 1) % polygon_.size()];
      twice += p.x() * q.y() - q.x() * p.y();
    }
    return std::abs(twice) / 2;
  }
  /// Keeps the part to the left of the line from a to b.
  void cut(const Vec3& a, const Vec3& b) {
    const auto left = [&](const Vec3& p) {
      return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
    };
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const Vec3 &p = polygon_[i], &q = polygon_[(i + 1) % polygon_.size()];
      const double at_p = left(p), at_q = left(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon_ = std::move(kept);
  }

  std::vector<Vec3> polygon_;
  double other_area_ = 0;
};

class WallFinder {
 public:
  WallFinder(const IndexedMesh& mesh, const SurfacePieces& pieces)
      : mesh_(mesh), pieces_(pieces), is_double_(mesh.triangles.size(), false) {
    Box3 all;
    normals_.reserve(mesh.triangles.size());
    boxes_.resize(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) boxes_[t].extend(mesh.corner(t, k));
      all.extend(boxes_[t]);
      normals_.push_back((mesh.corner(t, 1) - mesh.corner(t, 0)).cross(mesh.corner(t, 2) - mesh.corner(t, 0)));
    }
    if (!all.isEmpty()) min_mm_ = kMinWall * all.diagonal().norm();
    const Vec3 reach = Vec3::Constant(min_mm_);
    for (Box3& box : boxes_) box = Box3(box.min() - reach, box.max() + reach);
  }

  std::vector<bool> find() {
    std::vector<std::uint32_t> closed;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (!pieces_.is_open[pieces_.piece_of[t]]) closed.push_back(t);
    }
    look_at(std::move(closed));
    return std::move(is_double_);
  }

 private:
  /// Halves the triangles by position until there are few pairs. Triangles on the border are in both halves.
  void look_at(std::vector<std::uint32_t> some) {
    std::erase_if(some, [this](std::uint32_t t) { return is_double_[pieces_.piece_of[t]]; });
    std::vector<std::uint32_t> low, high;
    if (some.size() <= kLeafSize || !halve(some, low, high)) return look_at_pairs(std::move(some));
    some = {};
    look_at(std::move(low));
    look_at(std::move(high));
  }

  [[nodiscard]] bool halve(const std::vector<std::uint32_t>& some, std::vector<std::uint32_t>& low,
                           std::vector<std::uint32_t>& high) const {
    std::vector<double> middles(some.size());
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<std::uint32_t> below, above;
      for (std::size_t i = 0; i < some.size(); ++i) middles[i] = boxes_[some[i]].center()[axis];
      const auto half = middles.begin() + static_cast<std::ptrdiff_t>(middles.size() / 2);
      std::nth_element(middles.begin(), half, middles.end());
      for (const std::uint32_t t : some) {
        if (boxes_[t].min()[axis] <= *half) below.push_back(t);
        if (boxes_[t].max()[axis] >= *half) above.push_back(t);
      }
      const std::size_t most = std::max(below.size(), above.size());
      if (10 * most < 9 * some.size() && (low.empty() || most < std::max(low.size(), high.size()))) {
        low = std::move(below);
        high = std::move(above);
      }
    }
    return !low.empty();
  }

  void look_at_pairs(std::vector<std::uint32_t> some) {
    std::sort(some.begin(), some.end(), [this](std::uint32_t a, std::uint32_t b) {
      return std::pair(boxes_[a].min().x(), a) < std::pair(boxes_[b].min().x(), b);
    });
    for (std::size_t i = 0; i < some.size(); ++i) {
      const std::uint32_t a = some[i], piece = pieces_.piece_of[a];
      for (std::size_t k = i + 1; k < some.size() && boxes_[some[k]].min().x() <= boxes_[a].max().x(); ++k) {
        const std::uint32_t b = some[k];
        if (pieces_.piece_of[b] != piece || is_double_[piece] || !boxes_[a].intersects(boxes_[b])) continue;
        if (is_double_wall(a, b)) is_double_[piece] = true;
      }
    }
  }

  [[nodiscard]] std::array<Vec3, 3> corners(std::uint32_t t) const {
    return {mesh_.corner(t, 0), mesh_.corner(t, 1), mesh_.corner(t, 2)};
  }

  [[nodiscard]] bool is_double_wall(std::uint32_t a, std::uint32_t b) const {
    const double area_a = normals_[a].norm() / 2, area_b = normals_[b].norm() / 2;
    const double cosine = std::abs(normals_[a].dot(normals_[b])) / (4 * area_a * area_b);
    if (!(cosine > kAny)) return false;  // also rejects triangles without area
    const Overlap overlap(corners(a), corners(b), normals_[a].normalized());
    if (!overlap.is_larger_than_rounding(area_a)) return false;
    const TriangleCorners &own = mesh_.triangles[a], &other = mesh_.triangles[b];
    const auto shared = std::count_if(
        own.begin(), own.end(), [&](Corner c) { return std::find(other.begin(), other.end(), c) != other.end(); });
    if (shared >= 2 && (pieces_.is_pinched[pieces_.piece_of[a]] || cosine > kFolded)) return true;
    return cosine > kParallel && (shared == 0 ? overlap.min_height() : overlap.mean_height()) <= min_mm_;
  }

  const IndexedMesh& mesh_;
  const SurfacePieces& pieces_;
  std::vector<bool> is_double_;
  std::vector<Vec3> normals_;
  std::vector<Box3> boxes_;
  double min_mm_ = 0;
};

}  // namespace

std::vector<bool> find_double_walls(const IndexedMesh& mesh, const SurfacePieces& pieces) {
  return WallFinder(mesh, pieces).find();
}

}  // namespace gouge
