#include "lib/overcut/overcut_search.h"

#include <algorithm>
#include <cmath>

#include "lib/base/best_first_search.h"
#include "lib/penetration/closest_point.h"

namespace gouge {
namespace {

constexpr double kInTool_mm = 1e-9;  // a point this little outside the tool counts as in it: rounding of its foot
constexpr double kSeed_mm = 1e-6;    // the witness of a move is that exact
constexpr int kPushes = 40;

/// A box of space.
struct Cell : SearchCandidate {
  Vec3 centre = Vec3::Zero(), half = Vec3::Zero();
};

class Search : public BestFirstSearch<Search, Cell> {
 public:
  // A point that is deep is pushed on to where it is deepest nearby: no descent does that better.
  static constexpr bool kDescends = false;

  Search(const SweptSolid& tool, const DepthBody& part, const OvercutOptions& options)
      : tool_(tool), part_(part), options_(options) {}

  Overcut find(const Vec3& seed, double seed_t) {
    if (tool_.distance_at(seed, seed_t) <= kSeed_mm) take(seed, seed_t);
    push(0.25 * best_.depth_mm + options_.gap_mm);
    const Box3 box = tool_.box().intersection(part_.mesh.box());
    if (box.isEmpty()) return best_;
    add(box.center(), 0.5 * box.sizes());
    best_.depth_upper_mm = std::max(run(), best_.depth_mm);
    return best_;
  }

  [[nodiscard]] double threshold_mm() const {
    return best_.depth_mm + std::max(options_.gap_mm, options_.relative_gap * best_.depth_mm);
  }
  [[nodiscard]] bool is_exhausted() const { return looked_ >= options_.most_cells; }

  void split(const Cell& cell) {
    int axis = 0;
    cell.half.maxCoeff(&axis);
    Vec3 half = cell.half, shift = Vec3::Zero();
    half[axis] *= 0.5;
    shift[axis] = half[axis];
    add(cell.centre - shift, half);
    add(cell.centre + shift, half);
  }

 private:
  void add(const Vec3& centre, const Vec3& half) {
    ++looked_;
    const double radius = half.norm();
    const auto foot = closest_point(part_, centre);
    const double upper = (foot ? -foot->signed_mm() : 0) + radius;
    if (upper <= best_.depth_mm) return;
    const SweptSolid::Nearest near = tool_.nearest(centre, 0.25 * radius, radius);
    if (near.lower_mm > radius) return;
    if (near.distance_mm > 0) {
      // The tool's own point next to the centre: most cells have their middle beside it.
      const Vec3 beside = centre - near.distance_mm * tool_.outward_at(centre, near.t);
      const bool may_be_deeper = upper - radius + near.distance_mm > best_.depth_mm;
      if (may_be_deeper && tool_.distance_at(beside, near.t) <= kInTool_mm && take(beside, near.t)) push(radius);
    } else if (upper - radius > best_.depth_mm && take(centre, near.t)) {
      push(radius);
    }
    Cell cell;
    cell.upper_mm = upper;
    cell.centre = centre;
    cell.half = half;
    offer(cell);
  }

  /// Keeps the point when it is deeper in the part than any so far; it must be in the tool at t.
  bool take(const Vec3& point, double t) {
    const auto foot = closest_point(part_, point);
    if (!foot || !foot->is_inside || foot->distance_mm <= best_.depth_mm) return false;
    best_ = {foot->distance_mm, foot->distance_mm, point, t};
    deeper_ = -foot->normal;
    return true;
  }

  /// From the best point away from the surface: as far as the tool is thick there, then along its boundary.
  void push(double step) {
    for (int i = 0; i < kPushes && best_.depth_mm > 0 && step > kInTool_mm; ++i) {
      const SweptSolid::Nearest near = tool_.nearest(best_.point, 0.02 * step, 0);
      const Vec3 from = best_.point;
      if (near.distance_mm < -1e-7 && take(from - near.distance_mm * deeper_, near.t)) continue;
      const double t = near.distance_mm <= 0 ? near.t : best_.t;
      const Vec3 outward = tool_.outward_at(from, t);
      const Vec3 along = deeper_ - deeper_.dot(outward) * outward;
      if (along.norm() < 1e-9) return;
      Vec3 next = from + step * along.normalized();
      for (int k = 0; k < 3; ++k) {
        const double out = tool_.distance_at(next, t);
        if (out > 0) next -= out * tool_.outward_at(next, t);
      }
      const bool is_better = tool_.distance_at(next, t) <= kInTool_mm && take(next, t);
      if (!is_better) step *= 0.5;
    }
  }

  const SweptSolid& tool_;
  const DepthBody& part_;
  const OvercutOptions& options_;
  Overcut best_;
  Vec3 deeper_ = Vec3::UnitZ();
  std::size_t looked_ = 0;
};

}  // namespace

Overcut find_overcut(const SweptSolid& tool, const DepthBody& part, const Vec3& seed, double seed_t,
                     const OvercutOptions& options) {
  return Search(tool, part, options).find(seed, seed_t);
}

}  // namespace gouge
