#include "lib/surface/triangle_meetings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "lib/base/parallel.h"

namespace gouge {
namespace {

constexpr double kRoundings = 200;  // rounding in units in the last place of the largest coordinate
constexpr double kThin = 32;        // height in roundings up to which a triangle counts as one without area
constexpr double kSlim = 16;  // height in slacks up to which crossings of a triangle are shorter than a few slacks
constexpr std::size_t kLeavesPerChunk = 64;

/// A triangle with its plane, and the maximum rounding of a height over the plane.
struct Facet {
  std::array<Vec3, 3> corners;
  TriangleCorners indices;
  Vec3 normal = Vec3::Zero();  // unit; zero for a triangle without area
  double slack_mm = 0, height_mm = 0;

  Facet(const IndexedMesh& mesh, std::uint32_t triangle, double rounding_mm)
      : corners{mesh.corner(triangle, 0), mesh.corner(triangle, 1), mesh.corner(triangle, 2)},
        indices(mesh.triangles[triangle]) {
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vec3 across = ab.cross(ac);
    const double area2 = across.norm();
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    if (!(area2 > 0)) return;
    height_mm = area2 / std::sqrt(longest2);
    if (height_mm <= kThin * rounding_mm) return;
    normal = across / area2;
    slack_mm = rounding_mm * (1 + longest2 / area2);  // rounding turns the plane of a sliver more
  }

  [[nodiscard]] bool has_area() const { return normal.squaredNorm() > 0; }
  [[nodiscard]] bool is_slim() const { return height_mm <= kSlim * slack_mm; }
  [[nodiscard]] bool has(Corner corner) const {
    return indices[0] == corner || indices[1] == corner || indices[2] == corner;
  }
};

/// The heights of a triangle's corners over the plane of another; 0 if rounding leaves the side open.
struct Heights {
  std::array<double, 3> at{};
  int above = 0, below = 0;

  Heights(const Facet& of, const Facet& over) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (over.has(of.indices[k])) continue;
      const double height = over.normal.dot(of.corners[k] - over.corners[0]);
      if (std::abs(height) <= over.slack_mm) continue;
      at[k] = height;
      ++(height > 0 ? above : below);
    }
  }
  [[nodiscard]] bool is_in_plane() const { return above + below == 0; }
  /// Returns whether at most one corner of the triangle is in the plane, and the others are on one side.
  [[nodiscard]] bool is_beside() const { return (above == 0 || below == 0) && above + below >= 2; }
};

using Segment = std::array<Vec3, 2>;

/// Returns the intersection of a triangle with the other's plane. Requires neither is_in_plane() nor is_beside().
Segment segment_in_plane(const Facet& of, const Heights& heights) {
  Segment ends{of.corners[0], of.corners[0]};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3 && count < 2; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double here = heights.at[k], there = heights.at[next];
    if (!(std::abs(here) > 0)) {
      ends[count++] = of.corners[k];
    } else if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
      ends[count++] = of.corners[k] + here / (here - there) * (of.corners[next] - of.corners[k]);
    }
  }
  return ends;
}

/// Returns whether, up to rounding, no edge of `a` has all of `b` on its outer side. Requires both in one plane.
bool is_overlapped_at_edges(const Facet& a, const Facet& b, double slack_mm) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 along = a.corners[(k + 1) % 3] - a.corners[k];
    const Vec3 inward = a.normal.cross(along) / along.norm();
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : b.corners) most = std::max(most, inward.dot(corner - a.corners[k]));
    if (most <= slack_mm) return false;
  }
  return true;
}

/// Cuts a segment in the plane of a facet to the part in the facet. Returns nothing if it is no longer than rounding.
std::optional<Segment> part_within(const Segment& segment, const Facet& facet, double slack_mm) {
  double from = 0, to = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 along = facet.corners[(k + 1) % 3] - facet.corners[k];
    const Vec3 inward = facet.normal.cross(along) / along.norm();
    const double first = inward.dot(segment[0] - facet.corners[k]) + slack_mm,
                 last = inward.dot(segment[1] - facet.corners[k]) + slack_mm;
    if (first < 0 && last < 0) return std::nullopt;
    if (first < 0) from = std::max(from, first / (first - last));
    if (last < 0) to = std::min(to, first / (first - last));
  }
  const Vec3 way = segment[1] - segment[0];
  if ((to - from) * way.norm() <= slack_mm) return std::nullopt;
  return Segment{segment[0] + from * way, segment[0] + to * way};
}

/// Returns the meeting of a triangle with a slim one. Rounding turns the plane of the slim one too far, so only that of the
/// other is used.
std::optional<TriangleMeeting> meeting_with_slim(const Facet& plane, const Facet& slim, double rounding_mm) {
  const Heights heights(slim, plane);
  const double slack_mm = std::max(plane.slack_mm, rounding_mm);
  if (heights.is_beside() || heights.is_in_plane()) return std::nullopt;
  const auto part = part_within(segment_in_plane(slim, heights), plane, slack_mm);
  if (!part) return std::nullopt;
  TriangleMeeting meeting;
  meeting.from = (*part)[0];
  meeting.to = (*part)[1];
  return meeting;
}

std::optional<TriangleMeeting> meeting_of(const Facet& a, const Facet& b, double rounding_mm) {
  const auto shared = std::count_if(b.indices.begin(), b.indices.end(), [&](Corner c) { return a.has(c); });
  if (shared < 2 && a.is_slim() != b.is_slim()) {
    const Facet &plane = a.is_slim() ? b : a, &slim = a.is_slim() ? a : b;
    if (!Heights(slim, plane).is_in_plane()) return meeting_with_slim(plane, slim, rounding_mm);
  }
  const Heights of_b(b, a);
  if (of_b.is_beside() || (shared == 2 && !of_b.is_in_plane())) return std::nullopt;
  const Heights of_a(a, b);
  if (of_a.is_beside()) return std::nullopt;
  TriangleMeeting meeting;
  const double slack = std::max({a.slack_mm, b.slack_mm, rounding_mm});
  if (of_a.is_in_plane() || of_b.is_in_plane()) {
    if (!is_overlapped_at_edges(a, b, slack) || !is_overlapped_at_edges(b, a, slack)) return std::nullopt;
    meeting.is_coplanar = true;
    return meeting;
  }
  const Segment in_b = segment_in_plane(b, of_b), in_a = segment_in_plane(a, of_a);
  const bool is_b_longer = (in_b[1] - in_b[0]).squaredNorm() > (in_a[1] - in_a[0]).squaredNorm();
  const Segment &line = is_b_longer ? in_b : in_a, &other = is_b_longer ? in_a : in_b;
  const double length = (line[1] - line[0]).norm();
  if (length <= slack) return std::nullopt;
  const Vec3 along = (line[1] - line[0]) / length;
  const auto [low, high] = std::minmax({along.dot(other[0] - line[0]), along.dot(other[1] - line[0])});
  const double from = std::max(0.0, low), to = std::min(length, high);
  if (to - from <= slack) return std::nullopt;
  meeting.from = line[0] + from * along;
  meeting.to = line[0] + to * along;
  return meeting;
}

struct FloatBox {
  std::array<float, 3> low, high;

  FloatBox() {
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
  }
  void add(const Vec3& point, double around_mm) {
    constexpr float kUp = std::numeric_limits<float>::max();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      low[k] = std::min(low[k], std::nextafter(static_cast<float>(point[axis] - around_mm), -kUp));
      high[k] = std::max(high[k], std::nextafter(static_cast<float>(point[axis] + around_mm), kUp));
    }
  }
  void add(const FloatBox& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
  [[nodiscard]] bool meets(const FloatBox& other) const {
    return low[0] <= other.high[0] && other.low[0] <= high[0] && low[1] <= other.high[1] && other.low[1] <= high[1] &&
           low[2] <= other.high[2] && other.low[2] <= high[2];
  }
};

/// A binary tree of boxes over the leaves. Each leaf is tested against those later leaves whose boxes it meets.
class MeetingFinder {
 public:
  explicit MeetingFinder(const BlockTree& tree)
      : tree_(tree),
        mesh_(*tree.meshes.front()),
        rounding_mm_(rounding_of(mesh_)),
        first_leaf_(std::bit_ceil(tree.leaves.size())),
        boxes_(2 * first_leaf_) {
    for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
      const TriangleBlock& leaf = tree.leaves[i];
      for (std::size_t k = 0; k < leaf.count; ++k) boxes_[first_leaf_ + i].add(box_of(leaf.triangle[k]));
    }
    for (std::size_t i = first_leaf_ - 1; i > 0; --i) {
      boxes_[i] = boxes_[2 * i];
      boxes_[i].add(boxes_[2 * i + 1]);
    }
  }

  std::vector<TriangleMeeting> run(unsigned threads) {
    const std::size_t leaves = tree_.leaves.size();
    std::vector<std::vector<TriangleMeeting>> found((leaves + kLeavesPerChunk - 1) / kLeavesPerChunk);
    for_each_chunk(leaves, kLeavesPerChunk, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) look_from(i, found[first / kLeavesPerChunk]);
    });
    std::vector<TriangleMeeting> all;
    for (const std::vector<TriangleMeeting>& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }

 private:
  [[nodiscard]] FloatBox box_of(std::uint32_t triangle) const {
    FloatBox box;
    for (std::size_t k = 0; k < 3; ++k) box.add(mesh_.corner(triangle, k), rounding_mm_);
    return box;
  }

  void look_from(std::size_t leaf, std::vector<TriangleMeeting>& found) const {
    const TriangleBlock& own = tree_.leaves[leaf];
    std::array<FloatBox, kBlockLanes> own_boxes;
    for (std::size_t k = 0; k < own.count; ++k) own_boxes[k] = box_of(own.triangle[k]);
    std::array<std::size_t, 2 * 64> open{};
    std::size_t count = 0;
    open[count++] = 1;
    while (count > 0) {
      const std::size_t node = open[--count];
      if (last_below(node) < first_leaf_ + leaf || !boxes_[node].meets(boxes_[first_leaf_ + leaf])) continue;
      if (node < first_leaf_) {
        open[count++] = 2 * node + 1;
        open[count++] = 2 * node;
      } else if (node - first_leaf_ < tree_.leaves.size()) {
        compare(own, own_boxes, tree_.leaves[node - first_leaf_], node - first_leaf_ == leaf, found);
      }
    }
  }

  [[nodiscard]] std::size_t last_below(std::size_t node) const {
    while (node < first_leaf_) node = 2 * node + 1;
    return node;
  }

  void compare(const TriangleBlock& own, const std::array<FloatBox, kBlockLanes>& own_boxes, const TriangleBlock& other,
               bool is_same, std::vector<TriangleMeeting>& found) const {
    for (std::size_t j = is_same ? 1 : 0; j < other.count; ++j) {
      const FloatBox box = box_of(other.triangle[j]);
      std::optional<Facet> facet;
      for (std::size_t i = 0; i < (is_same ? j : own.count); ++i) {
        if (!own_boxes[i].meets(box)) continue;
        if (!facet) facet.emplace(mesh_, other.triangle[j], rounding_mm_);
        if (!facet->has_area()) break;
        std::uint32_t a = own.triangle[i], b = other.triangle[j];
        const Facet of_a(mesh_, a, rounding_mm_);
        if (!of_a.has_area()) continue;
        std::optional<TriangleMeeting> meeting = meeting_of(of_a, *facet, rounding_mm_);
        if (!meeting) continue;
        if (b < a) std::swap(a, b);
        meeting->a = a;
        meeting->b = b;
        found.push_back(*meeting);
      }
    }
  }

  const BlockTree& tree_;
  const IndexedMesh& mesh_;
  double rounding_mm_;
  std::size_t first_leaf_;
  std::vector<FloatBox> boxes_;  // the children of node i are 2 i and 2 i + 1
};

}  // namespace

TriangleWidth width_of(const IndexedMesh& mesh, std::uint32_t triangle, double rounding_mm) {
  const Facet facet(mesh, triangle, rounding_mm);
  return !facet.has_area() ? TriangleWidth::none : facet.is_slim() ? TriangleWidth::slim : TriangleWidth::wide;
}

double rounding_of(const IndexedMesh& mesh) {
  double largest = 1e-3;
  for (const Vec3& vertex : mesh.vertices) largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
  return kRoundings * std::numeric_limits<double>::epsilon() * largest;
}

std::vector<TriangleMeeting> find_triangle_meetings(const BlockTree& tree, unsigned threads) {
  if (tree.leaves.empty()) return {};
  return MeetingFinder(tree).run(threads);
}

}  // namespace gouge
