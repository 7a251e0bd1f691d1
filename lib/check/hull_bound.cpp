#include "lib/check/hull_bound.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr std::size_t kCorners = 6;
using Hull = std::array<Vec3, kCorners>;          // three corners at the start, then the same three at the end
using HullDepths = std::array<double, kCorners>;  // depths of the corners behind a plane

// Returns the bound that the planes of the tool's two ends give. They bound every point at no cost; a flat bottom that
// slides on its floor needs no other bound.
double end_limit(const CompiledTool& tool, double z_lo, double z_hi, double reach) {
  return std::max(0.0, reach + std::min(z_hi - tool.z_min_mm, tool.z_max_mm - z_lo));
}

// Returns a lower bound of the hull's distance from the axis. Consider the line through the closest corner, square to
// the direction from the axis to that corner. If all corners lie on its far side, so does the hull. Otherwise the hull
// may reach the axis.
double smallest_r(const Hull& hull) {
  std::size_t closest = 0;
  for (std::size_t i = 1; i < kCorners; ++i) {
    if (hull[i].head<2>().squaredNorm() < hull[closest].head<2>().squaredNorm()) closest = i;
  }
  const double r = hull[closest].head<2>().norm();
  if (!(r > 0)) return 0;
  const Eigen::Vector2d out = hull[closest].head<2>() / r;
  double least = r;
  for (const Vec3& q : hull) least = std::min(least, out.dot(q.head<2>()));
  return std::max(0.0, least);
}

/// An upper bound of the depth that is convex over the hull, given by its values at the corners.
struct HullLimit {
  HullDepths depths{};
  double largest_mm = 0;  ///< largest value, including the bulge
  std::size_t deepest = 0;
};

class PieceBounder {
 public:
  PieceBounder(const CompiledTool& tool, const std::array<Vec3, 3>& piece, const ToolInterval& interval,
               double reach_mm)
      : tool_(tool), reach_mm_(reach_mm) {
    double far = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      hull_[k] = interval.f0.to_tool(piece[k]);
      hull_[k + 3] = interval.f1.to_tool(piece[k]);
      far = std::max(far, (piece[k] - interval.tip_middle).norm());
    }
    bulge_ = interval.rates.bulge_mm(far);
    center_ = (hull_[0] + hull_[1] + hull_[2] + hull_[3] + hull_[4] + hull_[5]) / 6.0;
    z_lo_ = z_hi_ = hull_[0].z();
    for (const Vec3& q : hull_) {
      radius_ = std::max(radius_, (q - center_).norm());
      z_lo_ = std::min(z_lo_, q.z());
      z_hi_ = std::max(z_hi_, q.z());
    }
  }

  PieceBound run(double cutoff_mm) {
    PieceBound bound;
    const ToolSample middle = sample_tool(tool_, center_);
    bound.upper_mm = std::min(reach_mm_ - middle.nearest.signed_distance_mm + radius_ + bulge_,
                              end_limit(tool_, z_lo_ - bulge_, z_hi_ + bulge_, reach_mm_));
    if (bound.upper_mm <= cutoff_mm) return bound;
    HullLimit limits[2 + kRounds];
    const SupportPlane first = support_plane(tool_, middle);
    limits[0] = behind(first);
    improve(bound, limits[0].largest_mm);
    std::size_t count = 1;
    if (is_about_axis() && bound.upper_mm > cutoff_mm) {
      limits[count++] = behind(mirrored(first));
      blend_last(bound, limits, count, cutoff_mm);
    }
    for (std::size_t round = 0; round < kRounds && bound.upper_mm > cutoff_mm; ++round) {
      const Meeting top = round == 0 ? closest_to_axis() : highest(limits, count);
      const ToolSample sample = sample_tool(tool_, (1 - top.share) * hull_[top.i] + top.share * hull_[top.j]);
      if (top.i == top.j) measure(bound, top.i, sample);
      limits[count++] = behind(support_plane(tool_, sample));
      improve(bound, limits[count - 1].largest_mm);
      blend_last(bound, limits, count, cutoff_mm);
    }
    bound.is_time_next = is_time_worse(limits[0]);
    return bound;
  }

 private:
  void improve(PieceBound& bound, double depth_mm) const {
    bound.upper_mm = std::min(bound.upper_mm, std::max(0.0, reach_mm_ + depth_mm));
  }

  // If a hull contains the tool axis, a plane bounds its depth on one side of the axis only. The plane and its mirror
  // image in the axis bound both sides.
  [[nodiscard]] bool is_about_axis() const {
    return center_.head<2>().squaredNorm() <= (radius_ + bulge_) * (radius_ + bulge_);
  }

  void blend_last(PieceBound& bound, const HullLimit* limits, std::size_t count, double cutoff_mm) const {
    const HullLimit& last = limits[count - 1];
    for (std::size_t j = 0; j + 1 < count && bound.upper_mm > cutoff_mm; ++j) {
      improve(bound, blended(limits[j].depths, last.depths) + bulge_);
    }
  }

  [[nodiscard]] HullLimit behind(const SupportPlane& plane) const {
    HullLimit result;
    result.largest_mm = -1e300;
    for (std::size_t i = 0; i < kCorners; ++i) {
      result.depths[i] = plane.depth_mm(hull_[i]);
      if (result.depths[i] > result.largest_mm) {
        result.largest_mm = result.depths[i];
        result.deepest = i;
      }
    }
    result.largest_mm += bulge_;
    if (smallest_r_ < 0) smallest_r_ = smallest_r(hull_);
    const double r = std::max(0.0, smallest_r_ - bulge_);
    const bool is_valid = supports(tool_, plane, {z_lo_ - bulge_, z_hi_ + bulge_, result.largest_mm, r}, reach_mm_);
    return is_valid ? result : around(plane.foot);
  }

  // At reflex corners no plane supports the tool. There the depth of a point is at most its distance from the boundary
  // point. A distance is convex, so its largest value over the hull is at a corner.
  [[nodiscard]] HullLimit around(const Vec3& foot) const {
    HullLimit result;
    result.largest_mm = -1e300;
    for (std::size_t i = 0; i < kCorners; ++i) {
      result.depths[i] = (hull_[i] - foot).norm();
      if (result.depths[i] > result.largest_mm) {
        result.largest_mm = result.depths[i];
        result.deepest = i;
      }
    }
    result.largest_mm += bulge_;
    return result;
  }

  // Returns the smallest maximum over all blends of two planes. A point behind both planes is no deeper than behind any
  // blend of them. The best blend has equal depths at two corners.
  static double blended(const HullDepths& a, const HullDepths& b) {
    double best = 1e300;
    const auto try_blend = [&](double share) {
      double largest = -1e300;
      for (std::size_t i = 0; i < kCorners; ++i) largest = std::max(largest, share * a[i] + (1 - share) * b[i]);
      best = std::min(best, largest);
    };
    for (std::size_t i = 0; i < kCorners; ++i) {
      for (std::size_t j = i + 1; j < kCorners; ++j) {
        const double slope = (a[i] - b[i]) - (a[j] - b[j]);
        if (std::abs(slope) < Tolerance::kFewRoundings) continue;
        const double share = (b[j] - b[i]) / slope;
        if (share > 0 && share < 1) try_blend(share);
      }
    }
    return best;
  }

  /// A point on the edge of the hull from corner i to corner j, at `share` of the edge.
  struct Meeting {
    std::size_t i = 0, j = 0;
    double share = 0;
    double height_mm = -1e300;
  };

  // Returns the point of the edges that is closest to the axis. It is the best first guess at the deepest point; for a
  // flank it is the deepest point.
  [[nodiscard]] Meeting closest_to_axis() const {
    Meeting best;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const Eigen::Vector2d a = hull_[i].head<2>();
      for (std::size_t j = i; j < kCorners; ++j) {
        const Eigen::Vector2d side = hull_[j].head<2>() - a;
        const double length2 = side.squaredNorm();
        const double share = length2 > 0 ? std::clamp(-a.dot(side) / length2, 0.0, 1.0) : 0.0;
        const double height = -(a + share * side).squaredNorm();
        if (height > best.height_mm && share < 1) best = {i, share > 0 ? j : i, share, height};
      }
    }
    return best;
  }

  // Returns the point of an edge at which the smallest of all limits is largest: a corner, or a crossing of two limits.
  // The tool's distance there gives the next limit. This is the cutting-plane method of convex programming, restricted
  // to the edges.
  static Meeting highest(const HullLimit* limits, std::size_t count) {
    Meeting top;
    const auto look = [&](std::size_t i, std::size_t j, double share) {
      double least = 1e300;
      for (std::size_t k = 0; k < count; ++k) {
        least = std::min(least, (1 - share) * limits[k].depths[i] + share * limits[k].depths[j]);
      }
      if (least > top.height_mm) top = {i, j, share, least};
    };
    for (std::size_t i = 0; i < kCorners; ++i) look(i, i, 0);
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t l = k + 1; l < count; ++l) {
        for (std::size_t i = 0; i < kCorners; ++i) {
          const double at_i = limits[k].depths[i] - limits[l].depths[i];
          for (std::size_t j = i + 1; j < kCorners; ++j) {
            const double at_j = limits[k].depths[j] - limits[l].depths[j];
            if ((at_i > 0) != (at_j > 0)) look(i, j, at_i / (at_i - at_j));
          }
        }
      }
    }
    return top;
  }

  void measure(PieceBound& bound, std::size_t corner, const ToolSample& sample) const {
    const double value = reach_mm_ - sample.nearest.signed_distance_mm;
    if (value <= bound.value_mm) return;
    bound.value_mm = value;
    bound.corner = corner % 3;
    bound.is_at_end = corner >= 3;
  }

  // Returns whether the plane bound is slack rather because of time than because of the piece's size. Compares the
  // variation of the plane along the chords with that across the piece. Plain lengths have a small weight, for tools
  // that curve away. The bulge counts for time only.
  bool is_time_worse(const HullLimit& plane) const {
    double along = 0, across = 0, chord = 0, edge = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      along = std::max(along, std::abs(plane.depths[k] - plane.depths[k + 3]));
      chord = std::max(chord, (hull_[k] - hull_[k + 3]).norm());
      for (const std::size_t end : {std::size_t{0}, std::size_t{3}}) {
        across = std::max(across, std::abs(plane.depths[k + end] - plane.depths[next + end]));
      }
      edge = std::max(edge, (hull_[k] - hull_[next]).norm());
    }
    return along + kPlainShare * chord + 4 * bulge_ > across + kPlainShare * edge;
  }

  static constexpr double kPlainShare = 0.2;
  static constexpr std::size_t kRounds = 4;

  const CompiledTool& tool_;
  double reach_mm_;
  Hull hull_;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 0, bulge_ = 0, z_lo_ = 0, z_hi_ = 0;
  mutable double smallest_r_ = -1;  // of the hull; negative: not computed yet
};

}  // namespace

PieceBound bound_piece(const CompiledTool& tool, const std::array<Vec3, 3>& piece, const ToolInterval& interval,
                       double reach_mm, double cutoff_mm) {
  return PieceBounder(tool, piece, interval, reach_mm).run(cutoff_mm);
}

}  // namespace gouge
