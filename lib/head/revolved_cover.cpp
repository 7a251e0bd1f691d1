#include "lib/head/revolved_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"

namespace gouge {
namespace {

constexpr double kShort = 1e-6;    // share of the mesh's size: the direction of a shorter line is rounding
constexpr double kMaxEmpty = 3;    // a cover with more than this many times the mesh's volume is not used
constexpr double kMinGain = 0.03;  // a cut into two pieces must reduce the cover's volume by this share
constexpr std::size_t kMaxPieces = 6, kMaxHeights = 48, kMaxRoundings = 24, kMaxLines = CoverPiece::kMaxChain - 1;
constexpr int kDirections = 128;

using Points = std::vector<Vec2>;  // (r, z)

/// Returns the side of the convex hull away from the axis, from the lowest point to the highest.
Points outer_hull(Points all) {
  std::sort(all.begin(), all.end(),
            [](const Vec2& a, const Vec2& b) { return a.y() < b.y() || (!(b.y() < a.y()) && a.x() < b.x()); });
  Points hull;
  for (const Vec2& p : all) {
    while (hull.size() > 1 && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) hull.pop_back();
    hull.push_back(p);
  }
  return hull;
}

double turned_volume(const Points& hull) {
  double volume = 0;
  for (std::size_t k = 0; k + 1 < hull.size(); ++k) {
    const double a = hull[k].x(), b = hull[k + 1].x();
    volume += std::numbers::pi / 3 * (a * a + a * b + b * b) * (hull[k + 1].y() - hull[k].y());
  }
  return volume;
}

double volume_of(const IndexedMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += mesh.corner(t, 0).dot(mesh.corner(t, 1).cross(mesh.corner(t, 2))) / 6;
  return std::abs(sum);
}

/// Returns some heights of vertices in increasing order, including the lowest and the highest.
std::vector<double> heights_of(const IndexedMesh& mesh) {
  std::vector<double> all;
  for (const Vec3& v : mesh.vertices) all.push_back(v.z());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() <= kMaxHeights) return all;
  std::vector<double> some;
  for (std::size_t k = 0; k < kMaxHeights; ++k) some.push_back(all[k * (all.size() - 1) / (kMaxHeights - 1)]);
  return some;
}

/// Returns, for each pair of neighbouring heights, the outer hull in (r, z) of the triangles between them. Triangles
/// are cut at both heights.
std::vector<Points> slices(const IndexedMesh& mesh, const std::vector<double>& heights) {
  std::vector<Points> all(heights.size() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::array<Vec3, 3> corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
    const auto [low, high] = std::minmax({corners[0].z(), corners[1].z(), corners[2].z()});
    const auto first = std::upper_bound(heights.begin(), heights.end(), low) - heights.begin();
    for (auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(first, 1)) - 1; k < all.size() && heights[k] < high;
         ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        const Vec3 &from = corners[c], &to = corners[(c + 1) % 3];
        if (from.z() >= heights[k] && from.z() <= heights[k + 1]) all[k].push_back({from.head<2>().norm(), from.z()});
        for (const double z : {heights[k], heights[k + 1]}) {
          if ((from.z() < z) == (to.z() < z) || !(std::abs(to.z() - from.z()) > 0)) continue;
          const Vec3 at = from + (z - from.z()) / (to.z() - from.z()) * (to - from);
          all[k].push_back({at.head<2>().norm(), z});
        }
      }
    }
  }
  for (Points& slice : all) slice = outer_hull(std::move(slice));
  return all;
}

/// A line of a chain. The core is on its left.
struct Line {
  Vec2 through = Vec2::Zero(), along = Vec2::UnitY();
};

Vec2 meeting(const Line& a, const Line& b) {
  return a.through + cross(b.through - a.through, b.along) / cross(a.along, b.along) * a.along;
}

double length_between(const std::vector<Line>& lines, std::size_t k) {
  return (meeting(lines[k], lines[k + 1]) - meeting(lines[k - 1], lines[k])).dot(lines[k].along);
}

/// Removal of line k lets its neighbours meet in a corner. Returns the distance of that corner from line k, on the
/// outer side; infinite if the neighbours do not meet.
double loss_without(const std::vector<Line>& lines, std::size_t k) {
  if (cross(lines[k - 1].along, lines[k + 1].along) <= kShort) return std::numeric_limits<double>::infinity();
  return -cross(lines[k].along, meeting(lines[k - 1], lines[k + 1]) - lines[k].through);
}

class PieceMaker {
 public:
  PieceMaker(const Points& hull, double size_mm) : hull_(hull), size_mm_(size_mm) {
    for (std::size_t k = 0; k + 1 < hull.size(); ++k) {
      const Vec2 step = hull[k + 1] - hull[k];
      if (step.norm() > kShort * size_mm) lines_.push_back({hull[k], step.normalized()});
    }
  }

  [[nodiscard]] std::optional<CoverPiece> make() const {
    std::optional<CoverPiece> best;
    double least = std::numeric_limits<double>::infinity();
    for (const double rounding_mm : roundings()) {
      const auto piece = rounded(rounding_mm);
      if (!piece) continue;
      const double stands_off = stand_off(*piece);
      if (stands_off >= least) continue;
      least = stands_off;
      best = piece;
    }
    return best;
  }

 private:
  [[nodiscard]] std::vector<double> roundings() const {
    std::vector<double> all{0};
    const std::size_t step = std::max<std::size_t>(1, hull_.size() / kMaxRoundings);
    for (std::size_t k = 1; k + 1 < hull_.size(); k += step) {
      const Vec2 a = hull_[k] - hull_[k - 1], b = hull_[k + 1] - hull_[k];
      const double radius =
          0.5 * a.norm() * b.norm() * (a + b).norm() / std::max(cross(a, b), Tolerance::kFewRoundings);
      if (radius < size_mm_) all.push_back(radius);
    }
    return all;
  }

  /// Moves the hull's lines inward by `rounding_mm` and gives the piece that radius. The radius is then increased by
  /// the distance of the farthest corner of the hull that is outside.
  [[nodiscard]] std::optional<CoverPiece> rounded(double rounding_mm) const {
    std::vector<Line> lines;
    for (Line next : lines_) {
      next.through += rounding_mm * Vec2(-next.along.y(), next.along.x());
      while (lines.size() > 1 && cross(next.along, meeting(lines[lines.size() - 2], lines.back()) - next.through) <= 0)
        lines.pop_back();
      if (!lines.empty() && cross(lines.back().along, next.along) <= 0) return std::nullopt;
      lines.push_back(next);
    }
    thin(lines);
    if (lines.empty() || lines.size() > kMaxLines) return std::nullopt;
    CoverPiece piece;
    const double far = 4 * size_mm_;
    const Vec2 first = lines.size() > 1 ? meeting(lines[0], lines[1]) : lines[0].through;
    piece.chain.push_back(first - far * lines[0].along);
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) piece.chain.push_back(meeting(lines[k], lines[k + 1]));
    const Vec2 last = lines.size() > 1 ? piece.chain.back() : first;
    piece.chain.push_back(last + far * lines.back().along);
    for (std::size_t k = 1; k + 1 < piece.chain.size(); ++k) {
      if (piece.chain[k].x() < -Tolerance::kFewRoundings * size_mm_) return std::nullopt;
    }
    piece.radius_mm = rounding_mm;
    double outside = 0;
    for (const Vec2& p : hull_) outside = std::max(outside, cover_distance(piece, p));
    piece.radius_mm += outside + Tolerance::kRounding_mm;
    return piece;
  }

  void thin(std::vector<Line>& lines) const {
    while (lines.size() > 2) {
      std::size_t least = 0;
      double loss = std::numeric_limits<double>::infinity();
      bool is_short = false;
      for (std::size_t k = 1; k + 1 < lines.size(); ++k) {
        const double now = loss_without(lines, k);
        is_short = is_short || length_between(lines, k) < kShort * size_mm_;
        if (now < loss) {
          loss = now;
          least = k;
        }
      }
      if (least == 0 || (!is_short && lines.size() <= kMaxLines)) return;
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(least));
    }
  }

  /// Returns the maximum distance by which the piece reaches beyond the hull, over directions in which the piece is
  /// bounded.
  [[nodiscard]] double stand_off(const CoverPiece& piece) const {
    double most = 0;
    for (int i = 0; i <= kDirections; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) / kDirections - 0.5);
      const Vec2 n(std::cos(angle), std::sin(angle)), along(-n.y(), n.x());
      if (cross(lines_.front().along, along) < 0 || cross(along, lines_.back().along) < 0) continue;
      double core = -std::numeric_limits<double>::infinity(), hull = core;
      for (std::size_t k = 1; k + 1 < piece.chain.size(); ++k) core = std::max(core, n.dot(piece.chain[k]));
      for (const Vec2& p : hull_) hull = std::max(hull, n.dot(p));
      most = std::max(most, core + piece.radius_mm - hull);
    }
    return most;
  }

  const Points& hull_;
  double size_mm_;
  std::vector<Line> lines_;
};

/// Slices [first, last) that are treated as one.
struct Slab {
  std::size_t first = 0, last = 0;
  Points hull;
  double volume = 0;
};

class CoverMaker {
 public:
  explicit CoverMaker(const IndexedMesh& mesh) : heights_(heights_of(mesh)) {
    for (const Vec3& v : mesh.vertices) cover_.size_mm = std::max(cover_.size_mm, v.norm());
    if (heights_.size() > 1) slices_ = slices(mesh, heights_);
  }

  ConvexCover make(double mesh_volume) {
    if (slices_.empty()) return {};
    std::vector<Slab> slabs{slab(0, slices_.size())};
    while (slabs.size() < kMaxPieces && cut_one(slabs)) {
    }
    double volume = 0;
    for (const Slab& s : slabs) volume += s.volume;
    if (!(volume <= kMaxEmpty * mesh_volume)) return {};
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      auto piece = PieceMaker(slabs[i].hull, cover_.size_mm).make();
      if (!piece) return {};
      piece->z_lo_mm = heights_[slabs[i].first];
      piece->z_hi_mm = heights_[slabs[i].last];
      piece->r_below_mm = i > 0 ? end_radius(slabs[i - 1].hull, piece->z_lo_mm) : 0;
      piece->r_above_mm = i + 1 < slabs.size() ? end_radius(slabs[i + 1].hull, piece->z_hi_mm) : 0;
      set_feet(slabs, i, *piece);
      cover_.pieces.push_back(*piece);
    }
    return std::move(cover_);
  }

 private:
  /// Builds the slab of these slices. The lowest and the highest slab are closed by a flat face on the axis.
  [[nodiscard]] Slab slab(std::size_t first, std::size_t last) const {
    Points all;
    for (std::size_t k = first; k < last; ++k) all.insert(all.end(), slices_[k].begin(), slices_[k].end());
    if (all.empty()) all = {{0, heights_[first]}, {0, heights_[last]}};  // a gap between two pieces of the mesh
    if (first == 0) all.push_back({0, heights_.front()});
    Points hull = outer_hull(std::move(all));
    if (first > 0) {  // a slab above another has no lower face: its hull begins at the outermost point of its lowest
                      // height
      const auto is_above = [&](const Vec2& p) { return p.y() > hull.front().y(); };
      hull.erase(hull.begin(), std::find_if(hull.begin(), hull.end(), is_above) - 1);
    }
    const double volume = turned_volume(hull);
    if (last == slices_.size() && hull.back().x() > 0) hull.push_back({0, heights_.back()});
    return {first, last, std::move(hull), volume};
  }

  bool cut_one(std::vector<Slab>& slabs) const {
    double total = 0, most = 0;
    for (const Slab& s : slabs) total += s.volume;
    std::size_t which = 0;
    std::array<Slab, 2> halves;
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      for (std::size_t k = slabs[i].first + 1; k < slabs[i].last; ++k) {
        Slab below = slab(slabs[i].first, k), above = slab(k, slabs[i].last);
        const double gain = slabs[i].volume - below.volume - above.volume;
        if (gain <= most) continue;
        most = gain;
        which = i;
        halves = {std::move(below), std::move(above)};
      }
    }
    if (!(most > kMinGain * total)) return false;
    slabs[which] = std::move(halves[1]);
    slabs.insert(slabs.begin() + static_cast<std::ptrdiff_t>(which), std::move(halves[0]));
    return true;
  }

  static double end_radius(const Points& hull, double height) {
    double radius = Tolerance::kRounding_mm;
    for (const Vec2& p : hull)
      radius = std::max(radius, std::abs(p.y() - height) > 0 ? 0 : p.x() + Tolerance::kRounding_mm);
    return radius;
  }

  // The piece is continued beyond its slab. Closest points on the continuation are valid up to the first slab that is
  // not within it.
  static void set_feet(const std::vector<Slab>& slabs, std::size_t own, CoverPiece& piece) {
    piece.foot_lo_mm = -std::numeric_limits<double>::infinity();
    piece.foot_hi_mm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < slabs.size(); ++i) {
      double outside = -1;
      for (const Vec2& p : slabs[i].hull) outside = std::max(outside, cover_distance(piece, p));
      if (i == own || outside <= 0) continue;
      if (i < own) piece.foot_lo_mm = std::max(piece.foot_lo_mm, slabs[i].hull.back().y());
      if (i > own) piece.foot_hi_mm = std::min(piece.foot_hi_mm, slabs[i].hull.front().y());
    }
  }

  std::vector<double> heights_;
  std::vector<Points> slices_;
  ConvexCover cover_;
};

}  // namespace

ConvexCover make_revolved_cover(const IndexedMesh& mesh) { return CoverMaker(mesh).make(volume_of(mesh)); }

}  // namespace gouge
