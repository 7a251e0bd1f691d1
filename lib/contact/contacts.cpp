#include "lib/contact/contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "lib/base/tolerance.h"
#include "lib/check/hull_bound.h"
#include "lib/check/support_plane.h"
#include "lib/check/sweep_filter.h"
#include "lib/geom/point_triangle.h"
#include "lib/geom/triangle.h"
#include "lib/motion/motion_law.h"
#include "lib/motion/tool_interval.h"
#include "lib/tool/evaluate.h"

namespace gouge {
namespace {

// Contacts steer a correction but prove nothing; a tenth of their excess is accurate enough.
constexpr double kRelativeAccuracy = 0.1;
constexpr double kSmallestPiece_mm = 0.02;
// Maximum number of pieces of one triangle: in hollow or undercut tools the bounds do not decide over a wide face.
constexpr int kMaxPieces = 1000;
constexpr int kMaxSteps = 16;           // maximum number of steps to the deepest point at an edge of a triangle
constexpr std::size_t kNeighbours = 2;  // neighbours of the nearest element that may be nearest to the deepest point
// Maximum by which a reported excess above 0 may be below the true one.
constexpr double kGap_mm = 0.05;

/// Returns the radial unit vector of a direction or point in tool coordinates; `fallback` if it is along the axis.
Vec3 radial_or(const Vec3& v, const Vec3& fallback) {
  const Vec3 across(v.x(), v.y(), 0);
  return across.norm() > Tolerance::kSameDirection ? across.normalized() : fallback;
}

/// Returns the point of the half plane `out` from which depth in an element is measured: the center of an arc. For
/// other elements it is q itself, turned about the axis.
Vec3 focus_of(const BoundaryElement& element, const Vec3& q, const Vec3& out) {
  if (element.kind == ElementKind::arc) return element.center.x() * out + element.center.y() * Vec3::UnitZ();
  return q.head<2>().norm() * out + q.z() * Vec3::UnitZ();
}

/// A triangle that may have a contact.
struct NearTriangle {
  std::array<Vec3, 3> corners;
  double upper_mm = 0;     ///< upper bound of its excess
  std::size_t number = 0;  ///< in the order of the tree
};

class Collector {
 public:
  Collector(const ToolInterval& interval, const CompiledTool& tool, const BlockTree& tree, double aim,
            double notable_mm)
      : interval_(interval), frame_(interval.f0), tool_(tool), tree_(tree), aim_(aim), notable_mm_(notable_mm) {
    visit(0);
  }

  [[nodiscard]] std::vector<ToolContact> contacts() {
    std::vector<ToolContact> found;
    for (const NearTriangle& triangle : near_) {
      if (is_contact(triangle.corners)) found.push_back(best_);
    }
    return found;
  }

  /// Returns the deepest contact, of equal ones the first.
  [[nodiscard]] std::optional<ToolContact> deepest() {
    std::ranges::stable_sort(near_, std::greater<>(), &NearTriangle::upper_mm);
    std::optional<ToolContact> most;
    std::size_t number = 0;
    for (const NearTriangle& triangle : near_) {
      if (most && triangle.upper_mm + Tolerance::kRounding_mm < most->excess_mm) break;
      if (!is_contact(triangle.corners)) continue;
      const bool is_equal = most && !(best_.excess_mm < most->excess_mm) && !(most->excess_mm < best_.excess_mm);
      if (most && !(most->excess_mm < best_.excess_mm) && !(is_equal && triangle.number < number)) continue;
      most = best_;
      number = triangle.number;
    }
    return most;
  }

 private:
  void visit(std::uint32_t index) {
    const NodeBlock& node = tree_.nodes[index];
    for (std::size_t i = 0; i < node.count; ++i) {
      const Vec3 center = tree_.origin + Vec3(node.center[0][i], node.center[1][i], node.center[2][i]);
      if (excess_at(center) + static_cast<double>(node.radius_mm[i]) <= notable_mm_) continue;
      if (node.has_leaves) {
        visit_leaf(tree_.leaves[node.child[i]]);
      } else {
        visit(node.child[i]);
      }
    }
  }

  void visit_leaf(const TriangleBlock& leaf) {
    for (std::size_t i = 0; i < leaf.count; ++i) {
      NearTriangle triangle;
      triangle.corners = tree_.corners(leaf.triangle[i]);
      const Vec3 centre = middle_of(triangle.corners);
      triangle.upper_mm = excess_at(centre) + radius_about(centre, triangle.corners);
      triangle.number = near_.size();
      if (triangle.upper_mm > notable_mm_ - Tolerance::kRounding_mm) near_.push_back(triangle);
    }
  }

  /// Returns the excess of a point of the part.
  [[nodiscard]] double excess_at(const Vec3& point) const {
    const Vec3 q = frame_.to_tool(point);
    return -signed_distance_mm(tool_, q.head<2>().norm(), q.z()) - aim_;
  }
  [[nodiscard]] double excess(const ToolSample& sample) const { return -sample.nearest.signed_distance_mm - aim_; }

  [[nodiscard]] static Vec3 middle_of(const std::array<Vec3, 3>& t) { return (t[0] + t[1] + t[2]) / 3.0; }
  [[nodiscard]] static double radius_about(const Vec3& centre, const std::array<Vec3, 3>& t) {
    double radius = 0;
    for (const Vec3& corner : t) radius = std::max(radius, (corner - centre).norm());
    return radius;
  }

  /// Finds the deepest point of a triangle, best_. Returns whether it is a contact.
  [[nodiscard]] bool is_contact(const std::array<Vec3, 3>& corners) {
    best_ = ToolContact{};
    pieces_ = 0;
    refine(corners);
    if (!(best_.excess_mm > notable_mm_)) return false;
    const Vec3 across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Vec3 face = across.norm() > 0 ? Vec3(across.normalized()) : Vec3::Zero();
    if (face.squaredNorm() > 0) turn_to_face(corners, face);
    follow_round(corners);
    best_.face = face;
    return true;
  }

  /// Tries the points at which the tool's normal is that of the face. Within the accuracy of the search a ball is
  /// almost as deep several degrees beside them.
  void turn_to_face(const std::array<Vec3, 3>& t, const Vec3& face) {
    const ToolSample found = sample_tool(tool_, frame_.to_tool(best_.point));
    const Vec3 into_face = frame_.rows * (face.dot(best_.normal) < 0 ? face : Vec3(-face));
    const Vec3 out = radial_or(into_face, radial_or(found.q, Vec3::UnitX()));
    const std::size_t nearest = found.nearest.element, last = tool_.elements.size() - 1;
    const std::size_t first = nearest - std::min(nearest, kNeighbours);
    for (std::size_t k = first; k <= std::min(nearest + kNeighbours, last); ++k)
      try_nearest(t, focus_of(tool_.elements[k], found.q, out));
  }

  /// Approaches the deepest point at an edge or corner of the triangle, which is nearest to the center of the tool's
  /// rounding there.
  void follow_round(const std::array<Vec3, 3>& t) {
    for (int step = 0; step < kMaxSteps; ++step) {
      const ToolSample found = sample_tool(tool_, frame_.to_tool(best_.point));
      const BoundaryElement& element = tool_.elements[found.nearest.element];
      const double before = best_.excess_mm;
      if (element.kind != ElementKind::arc || element.is_reflex) return;
      try_nearest(t, focus_of(element, found.q, radial_or(found.q, Vec3::UnitX())));
      if (best_.excess_mm - before <= Tolerance::kRounding_mm) return;
    }
  }

  void try_nearest(const std::array<Vec3, 3>& t, const Vec3& q_tool) {
    try_point(closest_on_triangle(frame_.rows.transpose() * q_tool + frame_.tip, t).point);
  }

  ToolSample try_point(const Vec3& p) {
    const ToolSample sample = sample_tool(tool_, frame_.to_tool(p));
    const double found = excess(sample);
    if (found > best_.excess_mm)
      best_ = {p, -(frame_.rows.transpose() * support_plane(tool_, sample).normal), found, Vec3::Zero()};
    return sample;
  }

  /// Returns the excess up to which a point is ignored.
  [[nodiscard]] double lower_cutoff_mm() const {
    return std::max(0.0, aim_) + std::max(best_.excess_mm * (1 + kRelativeAccuracy), notable_mm_);
  }

  void refine(const std::array<Vec3, 3>& t) {
    if (++pieces_ > kMaxPieces) return;
    const Vec3 centre = middle_of(t);
    const double radius = radius_about(centre, t);
    const ToolSample middle = try_point(centre);
    const double above = std::min(0.0, aim_);  // offset of the depth and of the bound, which ends at the reach
    if (radius - middle.nearest.signed_distance_mm - above <= lower_cutoff_mm()) return;
    if (is_as_deep_as_plane(t, middle, radius, above)) return;
    for (const Vec3& corner : t) try_point(corner);
    const double enough = lower_cutoff_mm();
    // The bound by planes shows at once that a face lying in a face is equally deep everywhere.
    if (bound_piece(tool_, t, interval_, -above, enough).upper_mm <= enough) return;
    const std::size_t longest = longest_edge(t);
    if ((t[(longest + 1) % 3] - t[longest]).norm() <= kSmallestPiece_mm) return;
    for (const std::array<Vec3, 3>& half : halves(t, longest)) refine(half);
  }

  // Returns whether the piece is no deeper than allowed. Over most small pieces the plane that touches the tool next to
  // the middle replaces the tool. Behind it, a corner is deepest.
  bool is_as_deep_as_plane(const std::array<Vec3, 3>& t, const ToolSample& middle, double radius, double above) {
    const SupportPlane plane = support_plane(tool_, middle);
    std::array<double, 3> depth{};
    SupportedSet piece{middle.q.z(), middle.q.z(), 0, std::max(0.0, middle.q.head<2>().norm() - radius)};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 corner = frame_.to_tool(t[k]);
      depth[k] = plane.depth_mm(corner);
      piece.z_lo_mm = std::min(piece.z_lo_mm, corner.z());
      piece.z_hi_mm = std::max(piece.z_hi_mm, corner.z());
    }
    const auto deepest = std::max_element(depth.begin(), depth.end());
    try_point(t[static_cast<std::size_t>(deepest - depth.begin())]);
    piece.largest_depth_mm = *deepest;
    // Without this test, the plane of a wide holder would hide a cutter that reaches beyond it.
    return *deepest - above <= lower_cutoff_mm() && supports(tool_, plane, piece, 0);
  }

  const ToolInterval& interval_;
  const ToolFrame& frame_;
  const CompiledTool& tool_;
  const BlockTree& tree_;
  double aim_;
  double notable_mm_;
  std::vector<NearTriangle> near_;
  ToolContact best_;
  int pieces_ = 0;
};

struct AimedTarget {
  SearchTarget target;
  double aim_mm = 0;
};

/// Returns the target of one mesh with its aim: half of the tolerance for a workpiece, which cutters touch; outside of
/// the clearance for any other mesh.
AimedTarget aimed_at(const ToolVariants& tool, const LimitedMesh& mesh, const CorrectionAim& aim) {
  const MeshLimit& limit = mesh.limit;
  SearchTarget target = target_on(limit.clearance_mm > 0 ? tool.bare : tool.*mesh.obstacle->rule.form, mesh);
  target.reach_mm = 0;  // an aim below 0 makes this necessary
  if (mesh.obstacle->rule.is_workpiece) return {target, std::min(aim.workpiece_mm, 0.5 * limit.tolerance_mm)};
  return {target, aim.clearance_mm - limit.clearance_mm};
}

std::vector<AimedTarget> aimed_targets(const ToolVariants& tool, const PreparedScene& scene, const CorrectionAim& aim) {
  std::vector<AimedTarget> all;
  for (const PreparedObstacle& obstacle : scene.obstacles()) {
    const double aim_mm = obstacle.rule.is_workpiece ? aim.workpiece_mm : aim.others_mm;
    all.push_back({target_on(tool.*obstacle.rule.form, obstacle), aim_mm});
  }
  if (!tool.with_clearance.elements.empty()) {
    for (const PreparedObstacle& obstacle : scene.obstacles())
      all.push_back({target_on(tool.with_clearance, obstacle), aim.clearance_mm});
  }
  for (const LimitedMesh& mesh : scene.limited_meshes()) all.push_back(aimed_at(tool, mesh, aim));
  return all;
}

std::optional<ToolContact> deepest_contact(const Pose& pose, const CompiledTool& tool, const BlockTree& tree,
                                           double aim_mm, double notable_mm) {
  if (tree.nodes.empty() || tool.elements.empty()) return std::nullopt;
  const Motion alone = MotionLaw::tool_at(pose);
  const ToolInterval interval(alone, whole_segment(alone, 0));
  return Collector(interval, tool, tree, aim_mm, notable_mm).deepest();
}

double excess_of(const Motion& alone, const AimedTarget& aimed, double accuracy_mm, std::uint64_t& bounds) {
  constexpr std::uint64_t kBudget = 1'000'000;
  const double reach = std::max(0.0, -aimed.aim_mm);
  const double allowed = std::max(0.0, aimed.aim_mm);
  const SearchResult result =
      sweep_and_search(alone, {aimed.target}, {{allowed, accuracy_mm, kGap_mm, kBudget}, reach});
  bounds += result.bounds;
  const double excess = std::max(0.0, result.value_mm - allowed);
  return result.is_decided ? excess : std::max(excess, accuracy_mm);
}

}  // namespace

std::vector<ToolContact> find_contacts(const Pose& pose, const CompiledTool& tool, const BlockTree& tree, double aim_mm,
                                       double notable_mm) {
  if (tree.nodes.empty() || tool.elements.empty()) return {};
  const Motion alone = MotionLaw::tool_at(pose);
  const ToolInterval interval(alone, whole_segment(alone, 0));
  return Collector(interval, tool, tree, aim_mm, notable_mm).contacts();
}

std::vector<ToolContact> find_contacts(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene,
                                       const CorrectionAim& aim, double notable_mm) {
  std::vector<ToolContact> contacts;
  for (const AimedTarget& aimed : aimed_targets(tool, scene, aim)) {
    const auto found = find_contacts(pose, *aimed.target.tool, *aimed.target.tree, aimed.aim_mm, notable_mm);
    contacts.insert(contacts.end(), found.begin(), found.end());
  }
  return contacts;
}

std::optional<ToolContact> find_deepest_contact(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene,
                                                const CorrectionAim& aim, double notable_mm) {
  std::optional<ToolContact> most;
  for (const AimedTarget& aimed : aimed_targets(tool, scene, aim)) {
    const auto found = deepest_contact(pose, *aimed.target.tool, *aimed.target.tree, aimed.aim_mm, notable_mm);
    if (found && (!most || most->excess_mm < found->excess_mm)) most = found;
  }
  return most;
}

std::optional<ToolContact> find_deepest_contact(const Pose& pose, const CompiledTool& tool, const BlockTree& tree,
                                                double aim_mm) {
  return deepest_contact(pose, tool, tree, aim_mm, 0);
}

double largest_excess(const Pose& pose, const ToolVariants& tool, const PreparedScene& scene, const CorrectionAim& aim,
                      double accuracy_mm, std::uint64_t* bounds) {
  double most = 0;
  std::uint64_t spent = 0;
  const Motion alone = MotionLaw::tool_at(pose);
  for (const AimedTarget& aimed : aimed_targets(tool, scene, aim))
    most = std::max(most, excess_of(alone, aimed, accuracy_mm, spent));
  if (bounds != nullptr) *bounds += spent;
  return most;
}

double largest_excess(const Pose& pose, const CompiledTool& tool, const PreparedScene& scene, double aim_mm,
                      double accuracy_mm) {
  std::uint64_t spent = 0;
  return excess_of(MotionLaw::tool_at(pose), {target_on(tool, scene.workpiece()), aim_mm}, accuracy_mm, spent);
}

}  // namespace gouge
