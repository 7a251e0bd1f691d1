#include "tests/bench/penetration/cell_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

#include "lib/surface/surface.h"

namespace gouge {
namespace {

constexpr std::size_t kBits = 64, kBlock = 32;
constexpr std::size_t kAhead = 4;  // points whose facets are being fetched from memory

constexpr double kRoundUp = 1 + 1e-9, kRoundDown = 1 - 1e-9;

std::array<double, 4> ball_about(std::span<const Vec3> points) {
  Box3 box;
  for (const Vec3& p : points) box.extend(p);
  const Vec3 centre = box.center();
  double radius2 = 0;
  for (const Vec3& p : points) radius2 = std::max(radius2, (p - centre).squaredNorm());
  return {centre.x(), centre.y(), centre.z(), std::sqrt(radius2)};
}

/// The cells of `count` points moved by `pose`, coordinates apart; several at once where the processor can.
void cells_of(const DepthGrid& grid, const RigidTransform& pose, const double* x, const double* y, const double* z,
              std::size_t count, std::int32_t* cells) {
  const double per_mm = 1 / grid.cell_mm();
  const Eigen::Matrix3d turn = per_mm * pose.rotation;
  const Vec3 shift = per_mm * (pose.shift - grid.corner({0, 0, 0}));
  const double xx = turn(0, 0), xy = turn(0, 1), xz = turn(0, 2), x0 = shift.x();
  const double yx = turn(1, 0), yy = turn(1, 1), yz = turn(1, 2), y0 = shift.y();
  const double zx = turn(2, 0), zy = turn(2, 1), zz = turn(2, 2), z0 = shift.z();
  const double nx = grid.counts()[0], ny = grid.counts()[1], nz = grid.counts()[2],
               none = static_cast<double>(grid.cell_count());
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

}  // namespace

CellSearch::CellSearch(const CellBody& cells, const PointBody& points, const PenetrationOptions& options)
    : cells_(cells),
      body_(cells.body),
      points_(points),
      options_(options),
      rim_mm_(1e-3 * static_cast<double>(cells.body.slack_mm)),
      asked_of_(points.points.size()),
      is_asked_((points.points.size() + kBits - 1) / kBits, 0) {
  std::vector<Vec3> in_order;
  for (const std::uint32_t i : points.tree.order) in_order.push_back(points.points[i]);
  for (const KdopNode& node : points.tree.nodes)
    balls_.push_back(ball_about(std::span(in_order).subspan(node.item_first, node.item_count)));
  for (const Vec3& point : in_order) {
    xs_.push_back(point.x());
    ys_.push_back(point.y());
    zs_.push_back(point.z());
  }
}

const PenetrationResult& CellSearch::find(const RigidTransform& pose) {
  result_.contacts.clear();
  result_.counters = {};
  asked_.clear();
  if (points_.tree.nodes.empty()) return result_;
  descend(pose);
  measure();
  return result_;
}

void CellSearch::measure() {
  // Measured in the order of the moving tree, where neighbours follow each other; reported in the order of the
  // points, without a sort.
  feet_.clear();
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    if (i + 2 * kAhead < asked_.size()) cells_.near.prefetch_list(asked_[i + 2 * kAhead].cell);
    if (i + kAhead < asked_.size()) cells_.near.prefetch_facet(asked_[i + kAhead].cell);
    feet_.push_back(nearest(asked_[i]));
    const std::uint32_t point = asked_[i].point;
    asked_of_[point] = static_cast<std::uint32_t>(i);
    is_asked_[point / kBits] |= std::uint64_t{1} << (point % kBits);
  }
  for (std::size_t word = 0; word < is_asked_.size(); ++word) {
    for (std::uint64_t bits = is_asked_[word]; bits != 0; bits &= bits - 1) {
      const std::uint32_t i = asked_of_[word * kBits + static_cast<std::size_t>(std::countr_zero(bits))];
      report(asked_[i], feet_[i]);
    }
    is_asked_[word] = 0;
  }
}

void CellSearch::descend(const RigidTransform& pose) {
  PenetrationCounters& counters = result_.counters;
  stack_.assign(1, 0);
  while (!stack_.empty()) {
    const std::uint32_t index = stack_.back();
    stack_.pop_back();
    const KdopNode& node = points_.tree.nodes[index];
    const std::array<double, 4>& ball = balls_[index];
    ++counters.volume_pairs;
    counters.moving_level = std::max<std::uint32_t>(counters.moving_level, node.level);
    if (cells_.clearance.at(pose.point(Vec3(ball[0], ball[1], ball[2]))) > ball[3] * kRoundUp) continue;
    if (node.children == 0) {
      counters.points_transformed += node.item_count;
      look_up(node, pose);
      continue;
    }
    for (std::uint32_t child = node.first; child < node.first + node.children; ++child) stack_.push_back(child);
  }
}

void CellSearch::look_up(const KdopNode& leaf, const RigidTransform& pose) {
  std::array<std::int32_t, kBlock> cells;
  const std::size_t end = leaf.item_first + leaf.item_count;
  for (std::size_t first = leaf.item_first; first < end; first += kBlock) {
    const std::size_t count = std::min(kBlock, end - first);
    const double *const x = xs_.data() + first, *const y = ys_.data() + first, *const z = zs_.data() + first;
    cells_of(body_.depths, pose, x, y, z, count, cells.data());
    for (std::size_t k = 0; k < count; ++k) {
      const auto cell = static_cast<std::uint32_t>(cells[k]);
      if (body_.depths.result(cell) == DepthGrid::Cover::outside) continue;
      cells_.near.prefetch(cell);
      asked_.push_back({pose.point(Vec3(x[k], y[k], z[k])), points_.tree.order[first + k], cell});
    }
  }
}

/// Over the facet the height is the distance, and its sign the side; only what is not over the facet it is
/// nearest to needs more.
ClosestPoint CellSearch::nearest(const Asked& asked) {
  PenetrationCounters& counters = result_.counters;
  const NearFacets& near = cells_.near;
  const NearFacets::Known known = near.at(asked.cell);
  if (known.facets.empty()) {
    ++counters.inside_tests;
    return *body_.surface.closest_point(asked.place);
  }
  counters.primitive_pairs += known.facets.size();
  double best2 = std::numeric_limits<double>::infinity(), over_mm = 0;
  std::uint32_t best = 0;
  TrianglePoint foot;
  bool is_over = false;
  for (const std::uint32_t facet : known.facets) {
    const FacetPlanes::Heights height = near.planes(facet).at(asked.place);
    const bool is_beyond = !(height.beyond_mm < -rim_mm_);
    const double least2 =
        height.over_mm * height.over_mm + (height.beyond_mm > 0 ? height.beyond_mm * height.beyond_mm : 0);
    if (least2 * kRoundDown >= best2) continue;
    if (!is_beyond) {
      if (!(least2 < best2)) continue;
      best2 = least2;
      over_mm = height.over_mm;
    } else {
      ++counters.exact_pairs;
      const TrianglePoint other = closest_on_triangle(asked.place, body_.corners[near.slot(facet)]);
      if (!(other.distance2_mm2 < best2)) continue;
      best2 = other.distance2_mm2;
      foot = other;
    }
    is_over = !is_beyond;
    best = facet;
  }
  if (!known.is_complete) {
    ++counters.inside_tests;
    return *body_.surface.closest_point(asked.place, std::sqrt(best2) * kRoundUp + rim_mm_);
  }
  const std::uint32_t slot = near.slot(best);
  if (!is_over) return body_.surface.signed_closest_point(asked.place, body_.tree.order[slot], foot);
  const Vec3 normal = near.planes(best).normal();
  return {asked.place - over_mm * normal, normal, std::abs(over_mm), over_mm < 0, body_.tree.order[slot]};
}

void CellSearch::report(const Asked& asked, const ClosestPoint& foot) {
  const double depth = foot.distance_mm;
  if (!foot.is_inside || !(depth > 0)) {
    ++result_.counters.false_positives;
    return;
  }
  const bool is_deeper = depth > body_.options.depth_mm;
  if (is_deeper && !options_.is_deeper_reported) return;
  result_.contacts.push_back(
      {{asked.place, foot.normal, depth, options_.body, body_.mesh().file_triangle[foot.triangle]},
       asked.point,
       is_deeper});
}

}  // namespace gouge
