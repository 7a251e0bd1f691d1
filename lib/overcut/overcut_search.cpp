#include "lib/overcut/overcut_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/best_first_search.h"
#include "lib/check/overcut_gap.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/overcut/ceiling.h"
#include "lib/overcut/cell_program.h"

namespace gouge {
namespace {

constexpr double kInTool_mm = 1e-9;  // a point this little outside the tool counts as in it: rounding of its foot
constexpr double kSeed_mm = 1e-6;    // the witness of a move is that exact
constexpr double kSearchRounding_mm = 1e-9;
constexpr double kNotable_mm = 0.1 * kOvercutGap_mm;
constexpr double kNear_mm = 0.02;  // a climb ends when it looks no farther than that
constexpr int kClimbs = 24;
constexpr int kRounds = 3;              // planes of the tool that are added to a cell's first
constexpr double kSameNormal = 0.9999;  // cosine: a second limit as steep as the first limits nothing
constexpr double kNotCut = 0.1;         // of what is too much: a plane that cuts less off is of no use
constexpr double kAlongNormal = 0.25;   // first order says all along the normal; cells need to be small across it

/// A box of space with axes along the search's frame, over a time interval.
struct Cell : SearchCandidate {
  Vec3 centre = Vec3::Zero(), half = Vec3::Zero();  ///< part coordinates; along the axes of the frame
  std::uint32_t interval = 0;
  int next = 0;  ///< axis to halve; 3: the time
  /// The part's surface as seen from the centre.
  double inside_mm = 0;
  Vec3 outward = Vec3::UnitZ();
  std::uint32_t triangle = 0;  ///< the closest
};

class Search : public BestFirstSearch<Search, Cell> {
 public:
  // A point that is deep is pushed on to where it is deepest nearby: no descent does that better.
  static constexpr bool kDescends = false;

  Search(SweptSolid& tool, const Surface& part, const OvercutOptions& options)
      : tool_(tool), part_(part), options_(options) {}

  Overcut find(const Vec3& seed, double seed_t) {
    if (tool_.distance_at(seed, seed_t) <= kSeed_mm) take(seed, seed_t);
    climb();
    const Vec3 displacement = tool_.motion().at(1).tip - tool_.motion().at(0).tip;
    const Vec3 across = displacement - displacement.dot(deeper_) * deeper_;
    frame_.row(0) = deeper_;
    frame_.row(1) = across.norm() > 1e-6 ? Vec3(across.normalized()) : deeper_.unitOrthogonal();
    frame_.row(2) = Vec3(frame_.row(0)).cross(Vec3(frame_.row(1)));
    Box3 all;
    for (const Vec3& corner : LaneBound(part_.tree()).hull()) all.extend(Vec3(frame_ * corner));
    const bool is_sharp_only = options_.blunt_upper_mm <= threshold_mm();
    if (is_sharp_only) prune(options_.blunt_upper_mm);
    for (std::uint32_t s = 0; s < tool_.segments(); ++s) {
      for (const Box3& box_of : tool_.extents(frame_, s, is_sharp_only)) {
        const Box3 both = box_of.intersection(all);
        if (both.isEmpty()) continue;
        Cell cell;
        cell.centre = frame_.transpose() * both.center();
        cell.half = 0.5 * both.sizes();
        cell.interval = s;
        look_at_part(cell);
        add(cell);
      }
    }
    best_.depth_upper_mm = std::max(run(), best_.depth_mm);
    return best_;
  }

  [[nodiscard]] double threshold_mm() const { return best_.depth_mm + overcut_gap_mm(best_.depth_mm); }
  [[nodiscard]] bool is_exhausted() const { return looked_ >= options_.most_cells; }

  void split(const Cell& cell) {
    if (cell.next == 3) {
      const std::uint32_t first = tool_.halve(cell.interval);
      for (std::uint32_t k = 0; k < 2; ++k) {
        Cell part = cell;
        part.interval = first + k;
        add(part);
      }
      return;
    }
    for (const double side : {-0.5, 0.5}) {
      Cell part = cell;
      part.centre += side * cell.half[cell.next] * Vec3(frame_.row(cell.next));
      part.half[cell.next] *= 0.5;
      look_at_part(part);
      add(part);
    }
  }

 private:
  /// `cell.triangle` is one near it, of the cell it is a half of.
  void look_at_part(Cell& cell) const {
    const ClosestPoint foot = part_.closest_point_from(cell.centre, cell.triangle);
    cell.inside_mm = -foot.signed_mm();
    cell.outward = foot.normal;
    cell.triangle = foot.triangle;
  }

  void add(Cell cell) {
    ++looked_;
    const double radius = cell.half.norm();
    cell.upper_mm = cell.inside_mm + radius + kSearchRounding_mm;
    if (cell.upper_mm <= threshold_mm()) return prune(cell.upper_mm);
    const SweptBound swept = tool_.bound(cell.centre, radius, cell.interval);
    if (!swept.is_reached) return;
    if (swept.is_blunt) cell.upper_mm = std::min(cell.upper_mm, options_.blunt_upper_mm);
    if (cell.upper_mm <= threshold_mm()) return prune(cell.upper_mm);
    offer_point(cell, swept);
    if (is_decided_by_planes(cell, swept)) return;
    choose_next(cell, swept, -(frame_ * cell.outward));
    offer(cell);
  }

  /// In the cell's own coordinates: along the axes of the frame, and the time.
  [[nodiscard]] Affine in_cell(const DriftingHalfSpace& half) const {
    Affine plane{half.offset_mm, Vec4::Zero()};
    plane.gradient << -(frame_ * half.normal), half.drift_mm;
    return plane;
  }
  [[nodiscard]] Affine below(double height, const Vec3& outward) const {
    Affine limit{height, Vec4::Zero()};
    limit.gradient << -(frame_ * outward), 0;
    return limit;
  }

  /// To first order: the tool behind planes that touch it, the part below planes square to its closest points.
  bool is_decided_by_planes(const Cell& cell, const SweptBound& swept) {
    const double radius = cell.half.norm();
    Vec4 half_sizes;
    half_sizes << cell.half, 0.5;
    CellProgram program(half_sizes);
    program.limit(below(cell.inside_mm, cell.outward));
    if (swept.half) program.keep_behind(in_cell(*swept.half));
    CellProgram::Bound bound = program.bound();
    for (int k = 0; k < kRounds && bound.upper > threshold_mm(); ++k) {
      const Vec3 point = cell.centre + frame_.transpose() * bound.at.head<3>();
      const auto half = tool_.half_space(point, bound.at[3], cell.centre, radius, cell.interval);
      if (!half || in_cell(*half).at(bound.at) > -kNotCut * (bound.upper - threshold_mm())) break;
      program.keep_behind(in_cell(*half));
      bound = program.bound();
    }
    if (program.is_empty()) return true;
    Vec3 second = cell.outward;
    double second_mm = 0;
    if (bound.upper > threshold_mm() + radius) return false;
    if (bound.upper > threshold_mm()) {
      const ClosestPoint foot =
          part_.closest_point_from(cell.centre + frame_.transpose() * bound.at.head<3>(), cell.triangle);
      if (foot.normal.dot(cell.outward) > kSameNormal) return false;
      second = foot.normal;
      second_mm = second.dot(foot.point - cell.centre);
      program.limit(below(second_mm, second));
      bound = program.bound();
      if (bound.upper > threshold_mm()) return false;
    }
    const double spare = threshold_mm() - bound.upper;
    double higher = 0;
    if (bound.share > 0) {
      const auto height = ceiling_of(cell, cell.outward, cell.inside_mm + spare);
      if (!height) return false;
      higher = *height - cell.inside_mm;
    }
    if (bound.share < 1) {
      const auto height = ceiling_of(cell, second, second_mm + spare);
      if (!height) return false;
      higher = std::max(higher, *height - second_mm);
    }
    prune(bound.upper + higher);
    return true;
  }

  /// Over the part in the cell, along `outward` from its centre.
  [[nodiscard]] std::optional<double> ceiling_of(const Cell& cell, const Vec3& outward, double enough) const {
    const Vec3 up = frame_ * outward;
    double beside2 = 0;
    for (int k = 0; k < 4; ++k) {
      const Vec3 corner(cell.half[0], (k & 1) != 0 ? cell.half[1] : -cell.half[1],
                        (k & 2) != 0 ? cell.half[2] : -cell.half[2]);
      const double along = corner.dot(up);
      beside2 = std::max(beside2, corner.squaredNorm() - along * along);
    }
    Column column;
    column.through = cell.centre;
    column.direction = outward;
    column.radius_mm = std::sqrt(beside2) + kSearchRounding_mm;
    const double reach = cell.half.dot(up.cwiseAbs()) + kSearchRounding_mm;
    return ceiling(part_, column, reach, enough, cell.inside_mm < 0);
  }

  void choose_next(Cell& cell, const SweptBound& swept, const Vec3& deeper) const {
    double size = -1;
    for (int i = 0; i < 3; ++i) {
      const double along = std::abs(deeper[i]);
      const double weight = swept.half ? std::sqrt(std::max(0.0, 1 - along * along)) + kAlongNormal * along : 1;
      if (weight * cell.half[i] > size) {
        size = weight * cell.half[i];
        cell.next = i;
      }
    }
    if (swept.can_halve && 0.5 * swept.path_length_mm > size) cell.next = 3;
  }

  /// A point of the tool in or next to the cell: its centre, or the tool's nearest to that.
  void offer_point(const Cell& cell, const SweptBound& swept) {
    const double off = std::max(0.0, swept.distance_mm);
    if (cell.inside_mm + off <= best_.depth_mm + kNotable_mm) return;
    const double distance = tool_.distance_at(cell.centre, swept.t);
    if (distance <= 0) {
      if (take(cell.centre, swept.t)) climb();
      return;
    }
    if (cell.inside_mm + distance <= best_.depth_mm) return;
    const Vec3 beside = cell.centre - distance * tool_.outward_at(cell.centre, swept.t);
    if (tool_.distance_at(beside, swept.t) <= kInTool_mm && take(beside, swept.t)) climb();
  }

  /// Keeps the point when it is deeper in the part than any so far; it must be in the tool at t.
  bool take(const Vec3& point, double t) {
    const auto foot = part_.closest_point(point);
    if (!foot || !foot->is_inside || foot->distance_mm <= best_.depth_mm) return false;
    best_.depth_mm = foot->distance_mm;
    best_.point = point;
    best_.t = t;
    deeper_ = -foot->normal;
    return true;
  }

  /// The tool's point nearest to one that is far below the best.
  bool reach_on(double step, double t) {
    Vec3 next = best_.point + step * deeper_;
    double out = tool_.distance_at(next, t);
    for (int k = 0; k < 2 && out > 0; ++k) {
      next -= out * tool_.outward_at(next, t);
      out = tool_.distance_at(next, t);
    }
    return out <= kInTool_mm && take(next, t);
  }

  void climb() {
    const Motion& motion = tool_.motion();
    // About how far the tool runs past the point.
    const double travel = (motion.at(1).tip - motion.at(0).tip).norm() +
                          motion.angle_rad() * (best_.point - motion.at(best_.t).tip).norm();
    double step = 1 + 4 * best_.depth_mm;
    double dt = 0.5;
    for (int i = 0; i < kClimbs && best_.depth_mm > 0; ++i) {
      const double before = best_.depth_mm;
      if (!reach_on(step, best_.t)) step *= 0.25;
      const bool is_moving = dt * travel > kNear_mm;
      if (is_moving) {
        const double t = best_.t;
        const bool is_later = reach_on(step, std::min(1.0, t + dt));
        if (!is_later && !reach_on(step, std::max(0.0, t - dt))) dt *= 0.4;
      }
      if (best_.depth_mm - before < kNotable_mm && step < kNear_mm && !is_moving) break;
    }
  }

  SweptSolid& tool_;
  const Surface& part_;
  const OvercutOptions& options_;
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  Overcut best_;
  Vec3 deeper_ = -Vec3::UnitZ();
  std::size_t looked_ = 0;

  friend class BestFirstSearch<Search, Cell>;
};

}  // namespace

Overcut find_overcut(SweptSolid& tool, const Surface& part, const Vec3& seed, double seed_t,
                     const OvercutOptions& options) {
  return Search(tool, part, options).find(seed, seed_t);
}

}  // namespace gouge
