#include "lib/overcut/overcut_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lib/base/best_first_search.h"
#include "lib/base/tolerance.h"
#include "lib/check/overcut_gap.h"
#include "lib/geom/point_triangle.h"
#include "lib/hierarchy/lane_bound.h"
#include "lib/overcut/ceiling.h"
#include "lib/overcut/cell_program.h"

namespace gouge {
namespace {

constexpr double kNotable_mm = 0.1 * kOvercutGap_mm;
constexpr double kNear_mm = 0.02;  // a climb ends when its steps are shorter than this
constexpr int kClimbs = 24;
constexpr int kRounds = 8;  // maximum number of planes and limits that are added to the first ones of a cell
constexpr double kNoLimit_mm = 1e6;
constexpr double kNotLimited = 0.1;  // share of the excess: a limit that reduces the bound by less is useless
constexpr double kCoarse = 0.1;      // share of the excess: how much higher than necessary a ceiling may be
constexpr double kHopeless = 0.5;    // share of a cell's radius: for a larger excess a ceiling does not help
constexpr double kHigher = 0.3;      // share of a cell's radius: a ceiling that is higher by more does not help
constexpr int kNoZone = -1;
constexpr double kWorthAnotherLook = 0.25;  // share of the volume: a cell that shrinks below it is examined again
constexpr double kFar = 0.5;           // share of a ring's radius: if it moves farther, the pieces of the ring overlap
constexpr double kNotCut = 0.05;       // share of the excess: a plane that cuts off less is useless
constexpr double kAlongNormal = 0.25;  // weight along the normal, where first-order bounds are exact; across it
                                       // cells must be small

/// A box of space with axes along the frame of the search, during a time interval.
struct Cell : SearchCandidate {
  Vec3 centre = Vec3::Zero(), half = Vec3::Zero();  ///< part coordinates; half sizes along the axes of the frame
  std::uint32_t interval = 0, segment = 0;          ///< the segment has the interval
  int next = 0;                                     ///< axis to halve; 3: the time is halved
  /// Result of the closest point of the part's surface to the centre.
  double inside_mm = 0;
  Vec3 outward = Vec3::UnitZ();
  std::uint32_t triangle = 0;  ///< the closest triangle
  int zone = kNoZone;          ///< the sharp zone of the solid that the cell contains completely; else kNoZone
  double kept = 1;             ///< share of the volume that remains after the cell was shrunk
};

class OvercutSearch : public BestFirstSearch<OvercutSearch, Cell> {
 public:
  // A deep point is moved on to the deepest point nearby; a descent could not do that better.
  static constexpr bool kDescends = false;

  OvercutSearch(SweptSolid& tool, const Surface& part, const OvercutOptions& options)
      : tool_(tool), part_(part), options_(options) {}

  Overcut find(const Vec3& seed, double seed_t) {
    if (tool_.distance_at(seed, seed_t) <= Tolerance::kWitness_mm) take(seed, seed_t);
    climb();
    const Vec3 displacement = tool_.motion().at(1).tip - tool_.motion().at(0).tip;
    const Vec3 across = displacement - displacement.dot(deeper_) * deeper_;
    frame_.row(0) = deeper_;
    frame_.row(1) = across.norm() > Tolerance::kNoSide ? Vec3(across.normalized()) : deeper_.unitOrthogonal();
    frame_.row(2) = Vec3(frame_.row(0)).cross(Vec3(frame_.row(1)));
    Box3 all;
    for (const Vec3& corner : LaneBound(part_.tree()).hull()) all.extend(Vec3(frame_ * corner));
    add_solid(all);
    best_.depth_upper_mm = std::max(run(), best_.depth_mm);
    return best_;
  }

  [[nodiscard]] double threshold_mm() const { return best_.depth_mm + overcut_gap_mm(best_.depth_mm); }
  [[nodiscard]] bool is_exhausted() const { return looked_ >= options_.max_cells; }

  void split(const Cell& cell) {
    if (cell.zone >= 0 && split_zone(cell)) return;
    if (cell.next == 3) {
      const std::uint32_t first = tool_.halve(cell.interval);
      for (std::uint32_t k = 0; k < 2; ++k) {
        Cell part = cell;
        part.interval = first + k;
        look_at_part(part);
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
  /// Adds cells for all points of the solid in the box `within`. Where a bound is known outside of the sharp zones, the
  /// rest is not searched, or only where the surface is deep.
  void add_solid(const Box3& within) {
    const bool is_sharp_only = tool_.rounded_bound_mm() <= threshold_mm();
    if (is_sharp_only) prune(tool_.rounded_bound_mm());
    if (!is_sharp_only && std::isfinite(tool_.rounded_bound_mm())) {
      deep_ = tool_.deep_extents(frame_, part_, threshold_mm());
      prune(threshold_mm());
    }
    for (std::uint32_t s = 0; s < tool_.segments(); ++s) {
      Cell cell;
      cell.interval = cell.segment = s;
      const std::vector<Box3> boxes = tool_.extents(frame_, s, is_sharp_only);
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        if (is_sharp_only) cell.zone = static_cast<int>(k);
        add_within(boxes[k].intersection(within), cell);
      }
    }
  }

  /// Reduces a cell outside of the sharp zones to its part near the deep surface. Returns how much of its volume is left.
  double keep_deep(Cell& cell) const {
    if (deep_.empty() || !(cell.half.prod() > 0)) return 1;
    const Vec3 centre = frame_ * cell.centre;
    const Box3 left = deep_[cell.segment].intersection(Box3(centre - cell.half, centre + cell.half));
    if (left.isEmpty()) return 0;
    const double share = (0.5 * left.sizes()).prod() / cell.half.prod();
    if (share < kWorthAnotherLook) {
      cell.centre = frame_.transpose() * left.center();
      cell.half = 0.5 * left.sizes();
    }
    return share;
  }

  /// Splits a cell with a sharp zone: its time while the ring moves far, then the ring. Returns false if it has no
  /// pieces.
  bool split_zone(const Cell& cell) {
    const Vec3 centre = frame_ * cell.centre;
    const Box3 whole(centre - cell.half, centre + cell.half);
    const auto zone = static_cast<std::size_t>(cell.zone);
    Cell part = cell;
    if (cell.next == 3) {
      part.interval = tool_.halve(cell.interval);
      for (int k = 0; k < 2; ++k, ++part.interval)
        add_within(tool_.extents(frame_, part.interval, true)[zone].intersection(whole), part);
      return true;
    }
    part.zone = kNoZone;
    const std::vector<Box3> pieces = tool_.pieces(frame_, cell.interval, zone);
    for (const Box3& piece : pieces) add_within(piece.intersection(whole), part);
    return !pieces.empty();
  }

  /// Adds a cell for the box, along the axes of the frame. Its interval and all other data are those of `like`.
  void add_within(const Box3& box, Cell like) {
    if (box.isEmpty()) return;
    like.centre = frame_.transpose() * box.center();
    like.half = 0.5 * box.sizes();
    look_at_part(like);
    add(like);
  }

  /// Finds the closest point of the part. `cell.triangle` is a triangle near it: that of the cell from which it was
  /// halved.
  void look_at_part(Cell& cell) const {
    const ClosestPoint foot = part_.closest_point_from(cell.centre, cell.triangle);
    cell.inside_mm = -foot.signed_mm();
    cell.outward = foot.normal;
    cell.triangle = foot.triangle;
  }

  void add(Cell cell) {
    ++looked_;
    cell.kept = 1;
    const double radius = cell.half.norm();
    cell.upper_mm = cell.inside_mm + radius + Tolerance::kRounding_mm;
    if (cell.upper_mm <= threshold_mm()) return prune(cell.upper_mm);
    const SweptBound swept = tool_.bound(cell.centre, radius, cell.interval);
    if (!swept.is_reached) return;
    if (swept.is_rounded) {
      cell.upper_mm = std::min(cell.upper_mm, tool_.rounded_bound_mm());
      const double share = keep_deep(cell);
      if (!(share > 0)) return;
      if (share < kWorthAnotherLook) {
        look_at_part(cell);
        return add(cell);
      }
    }
    if (cell.upper_mm <= threshold_mm()) return prune(cell.upper_mm);
    offer_point(cell, swept);
    if (cell.zone >= 0) {  // a whole ring is too large for planes
      cell.next = swept.can_halve && swept.path_length_mm > kFar * radius ? 3 : 0;
      return offer(cell);
    }
    if (is_decided_by_planes(cell, swept)) return;
    if (cell.kept < kWorthAnotherLook) {
      look_at_part(cell);
      return add(cell);
    }
    choose_next(cell, swept, -(frame_ * cell.outward));
    offer(cell);
  }

  /// Returns a half-space in the cell's own coordinates: the axes of the frame, and the time.
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

  struct Limit {
    Vec3 outward;
    double height_mm;  ///< height over the cell's centre of the closest surface point to some point of the cell
  };
  using Limits = std::array<Limit, CellProgram::kMaxLimits>;

  /// Bounds a cell to first order: the tool is behind planes that touch it, the part below planes square to its closest
  /// points. If that does not decide the cell, the cell is shrunk to the part that remains. Returns whether it is
  /// decided.
  bool is_decided_by_planes(Cell& cell, const SweptBound& swept) {
    const double radius = cell.half.norm();
    Vec4 half_sizes;
    half_sizes << cell.half, 0.5;
    CellProgram program(half_sizes);
    Limits limits;
    std::size_t count = 0;
    const auto limit = [&](double height, const Vec3& outward) {
      limits[count++] = {outward, height};
      program.limit(below(height, outward));
    };
    limit(cell.inside_mm, cell.outward);
    if (swept.half) program.keep_behind(in_cell(*swept.half));
    CellProgram::Bound bound = program.bound();
    for (int k = 0; k < kRounds && bound.upper > threshold_mm() && !program.is_full(); ++k) {
      const double too_much = bound.upper - threshold_mm();
      const Vec3 point = cell.centre + frame_.transpose() * bound.at.head<3>();
      const auto half = tool_.half_space(point, bound.at[3], cell.centre, radius, cell.interval);
      const bool cuts = half && in_cell(*half).at(bound.at) < -kNotCut * too_much;
      if (cuts) program.keep_behind(in_cell(*half));
      bool limits_more = false;
      if (!cuts) {
        const ClosestPoint foot = part_.closest_point_from(point, cell.triangle);
        const double height = foot.normal.dot(foot.point - cell.centre);
        limits_more = below(height, foot.normal).at(bound.at) < bound.upper - kNotLimited * too_much;
        if (limits_more) limit(height, foot.normal);
      }
      if (!cuts && !limits_more) break;
      bound = program.bound();
    }
    if (std::isinf(bound.upper) && bound.upper < 0) return true;
    raise_to_ceilings(cell, limits, count, bound, program);
    bound = program.bound();
    cell.upper_mm = std::min(cell.upper_mm, bound.upper);
    if (bound.upper <= threshold_mm()) {
      prune(bound.upper);
      return true;
    }
    prune(threshold_mm());  // for all points that are cut off
    return !shrink(cell, program.where_at_least(threshold_mm(), bound));
  }

  /// Raises each limit to the height that is proved for it. A limit without a proof, or one that would not help, is
  /// removed.
  void raise_to_ceilings(const Cell& cell, const Limits& limits, std::size_t count, const CellProgram::Bound& bound,
                         CellProgram& program) const {
    const double radius = cell.half.norm();
    const double too_much = bound.upper - threshold_mm();
    for (std::size_t k = 0; k < count; ++k) {
      std::optional<double> height;
      const double enough = limits[k].height_mm + std::max(-too_much, kCoarse * too_much);
      if (bound.share[k] > 0 && too_much <= kHopeless * radius)
        height = ceiling_of(cell, limits[k].outward, enough, enough + kHigher * radius);
      program.raise(k, height ? std::max(0.0, *height - limits[k].height_mm) : kNoLimit_mm);
    }
  }

  /// Shrinks the cell. Returns false if nothing remains.
  bool shrink(Cell& cell, const CellProgram::Range& range) {
    const Vec4 size = range.high - range.low;
    if ((size.array() < 0).any()) return false;
    cell.centre += frame_.transpose() * Vec3(0.5 * (range.high + range.low).head<3>());
    const double before = cell.half.prod();
    cell.half = 0.5 * size.head<3>();
    cell.kept = cell.half.prod() / before;
    return true;
  }

  /// Returns the height of the part in the cell, along `outward` from its centre.
  [[nodiscard]] std::optional<double> ceiling_of(const Cell& cell, const Vec3& outward, double enough,
                                                 double most) const {
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
    column.radius_mm = std::sqrt(beside2) + Tolerance::kRounding_mm;
    const double reach = cell.half.dot(up.cwiseAbs()) + Tolerance::kRounding_mm;
    return ceiling(part_, column, reach, enough, most, cell.inside_mm < 0, cell.triangle);
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

  /// Tries a point of the tool in or near the cell: its centre, or the tool's closest point to the centre.
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
    if (tool_.distance_at(beside, swept.t) <= Tolerance::kRounding_mm && take(beside, swept.t)) climb();
  }

  /// Keeps the point if it is deeper in the part than any point so far. The point must be in the tool at t.
  bool take(const Vec3& point, double t) {
    const double nearest2 = closest_on_triangle(point, part_.tree().corners(near_)).distance2_mm2;
    if (nearest2 <= best_.depth_mm * best_.depth_mm) return false;
    const ClosestPoint foot = part_.closest_point_from(point, near_);
    if (foot.distance_mm <= best_.depth_mm || !foot.is_inside) return false;
    near_ = foot.triangle;
    best_.depth_mm = foot.distance_mm;
    best_.point = point;
    best_.t = t;
    deeper_ = -foot.normal;
    return true;
  }

  /// Tries the tool's closest point to a point that is farther below the best one. Returns whether it is deeper.
  bool reach_on(double step, double t) {
    Vec3 next = best_.point + step * deeper_;
    double out = tool_.distance_at(next, t);
    for (int k = 0; k < 2 && out > 0; ++k) {
      next -= out * tool_.outward_at(next, t);
      out = tool_.distance_at(next, t);
    }
    return out <= Tolerance::kRounding_mm && take(next, t);
  }

  void climb() {
    const Motion& motion = tool_.motion();
    // The approximate length that the tool moves past the point.
    const double travel = (motion.at(1).tip - motion.at(0).tip).norm() +
                          motion.turn_rad() * (best_.point - motion.at(best_.t).tip).norm();
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
      if (options_.ends_early && tool_.rounded_bound_mm() <= threshold_mm()) break;
      if (best_.depth_mm - before < kNotable_mm && step < kNear_mm && !is_moving) break;
    }
  }

  SweptSolid& tool_;
  std::vector<Box3> deep_;  // by segment: where points outside of the sharp zones may be too deep; empty: anywhere
  const Surface& part_;
  const OvercutOptions& options_;
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  Overcut best_;
  Vec3 deeper_ = -Vec3::UnitZ();
  std::uint32_t near_ = 0;  // the triangle closest to the best point
  std::size_t looked_ = 0;

  friend class BestFirstSearch<OvercutSearch, Cell>;
};

}  // namespace

Overcut find_overcut(SweptSolid& tool, const Surface& part, const Vec3& seed, double seed_t,
                     const OvercutOptions& options) {
  return OvercutSearch(tool, part, options).find(seed, seed_t);
}

}  // namespace gouge
