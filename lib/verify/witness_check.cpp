#include "lib/verify/witness_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/number_text.h"
#include "lib/geom/point_triangle.h"
#include "lib/path/run_kind.h"
#include "lib/verify/claimed_pose.h"

namespace gouge {
namespace {

constexpr double kExact_mm = 1e-6;  // promised accuracy of a witness

std::string mm(double value) { return display_text(value, 7) + " mm"; }

bool is_near(double a, double b) { return std::abs(a - b) <= kExact_mm; }

/// Returns the limit of the mesh of the witness; null: it has no limit of its own.
const ClaimedLimit* limit_of(const ClaimedScene& scene, const ClaimedWitness& witness) {
  const auto found = std::ranges::find_if(scene.limits, [&](const ClaimedLimit& limit) {
    return limit.is_fixture == witness.is_fixture && limit.mesh == witness.mesh;
  });
  return found == scene.limits.end() ? nullptr : &*found;
}

/// The contours that a witness refers to.
struct Forms {
  const ToolContour& form;  ///< with the offsets against its obstacle
  const ToolContour& bare;
};

Forms whole_forms(const ClaimedTool& tool, bool is_fixture) {
  return {is_fixture ? tool.fixture : tool.part, tool.bare};
}

class WitnessChecker {
 public:
  WitnessChecker(const ClaimedScene& scene, const ClaimedTool& tool, const Forms& forms, std::size_t move,
                 const MoveClaim& claim)
      : scene_(scene), tool_(tool), forms_(forms), move_(move), claim_(claim), w_(*claim.witness) {}

  std::optional<std::string> fault() const {
    if (!(w_.t >= 0 && w_.t <= 1)) return "its instant is not of the move";
    if (w_.turn && !admits(scene_, move_, w_.t, *w_.turn)) return "the law does not admit its rotary joints";
    if (!w_.point.allFinite() || !is_near(w_.normal.norm(), 1)) return "its point or normal is none";
    if (auto off = find_off_triangle()) return off;
    const double depth = depth_with({0, 0, 0});
    const std::optional<double> within = depth_in_clearance({0, 0, 0});
    if (within && is_near(*within, claim_.depth_mm)) return find_wrong_exit_of_clearance();
    if (!is_near(depth, claim_.depth_mm))
      return "the point is " + mm(depth) + " deep, and said to be " + mm(claim_.depth_mm);
    if (claim_.depth_mm > 0) return find_wrong_exit();
    if (claim_.clearance_mm && !is_near(clearance(), *claim_.clearance_mm))
      return "the point is " + mm(clearance()) + " away, and said to be " + mm(*claim_.clearance_mm);
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<std::string> find_off_triangle() const {
    const std::span<const IndexedMesh> meshes = w_.is_fixture ? scene_.fixtures : scene_.parts;
    if (w_.mesh >= meshes.size()) return "its mesh is not there";
    const IndexedMesh& mesh = meshes[w_.mesh];
    const auto at = std::find(mesh.file_triangle.begin(), mesh.file_triangle.end(), w_.triangle);
    if (at == mesh.file_triangle.end()) return "its triangle is not there";
    const auto t = static_cast<std::size_t>(at - mesh.file_triangle.begin());
    const double off2 =
        closest_on_triangle(w_.point, {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)}).distance2_mm2;
    if (off2 <= kExact_mm * kExact_mm) return std::nullopt;
    return "its point is " + mm(std::sqrt(off2)) + " off its triangle";
  }

  [[nodiscard]] Pose pose() const { return claimed_pose(scene_, move_, w_.t, w_.turn); }

  /// Returns the depth after the tool is moved away by `shift`.
  [[nodiscard]] double depth_with(const Vec3& shift) const {
    if (w_.body == Body::head)
      return depth_in_heads(scene_, head_frame(scene_, move_, w_.t, w_.turn), w_.point - shift);
    const double distance = forms_.form.nearest(in_tool(pose(), w_.point - shift)).signed_distance_mm;
    return std::max(0.0, -distance);
  }

  /// Returns how much the distance of the point is below the clearance of its mesh, after the tool is moved away.
  /// Returns nothing if the mesh has no clearance.
  [[nodiscard]] std::optional<double> depth_in_clearance(const Vec3& shift) const {
    const ClaimedLimit* limit = limit_of(scene_, w_);
    if (limit == nullptr || !(limit->clearance_mm > 0)) return std::nullopt;
    const Vec3 point = w_.point - shift;
    const double distance = w_.body == Body::head
                                ? distance_from_heads(scene_, head_frame(scene_, move_, w_.t, w_.turn), point)
                                : forms_.bare.nearest(in_tool(pose(), point)).signed_distance_mm;
    return std::max(0.0, limit->clearance_mm - distance);
  }

  [[nodiscard]] std::optional<std::string> find_wrong_exit_of_clearance() const {
    const double left = *depth_in_clearance(claim_.depth_mm * w_.normal);
    if (left <= kExact_mm || is_way_to_boundary()) return std::nullopt;
    return "the point is still " + mm(left) + " within the clearance after the tool has given way";
  }

  /// Returns whether the normal leads from a point inside of the body to its boundary, or away from the boundary. In a notch
  /// the way out of a clearance comes near another part of the body.
  [[nodiscard]] bool is_way_to_boundary() const {
    constexpr double kStep_mm = 1e-3;
    const double inside_mm = claim_.depth_mm - limit_of(scene_, w_)->clearance_mm;
    const double step_mm = inside_mm > 0 ? inside_mm : std::min(kStep_mm, claim_.depth_mm);
    return *depth_in_clearance(step_mm * w_.normal) <= claim_.depth_mm - step_mm + kExact_mm;
  }

  [[nodiscard]] std::optional<std::string> find_wrong_exit() const {
    const double left = depth_with(claim_.depth_mm * w_.normal);
    if (left > kExact_mm) return "the point is still " + mm(left) + " deep after the tool has given way";
    if (w_.body == Body::head) return std::nullopt;
    const double away = forms_.form.distance_to(w_.body, in_tool(pose(), w_.point));
    const bool is_its_body = is_near(away, claim_.depth_mm) || tool_.clearance.has(in_tool(pose(), w_.point));
    if (!is_its_body) return "the surface of the body it names is " + mm(away) + " away";
    return std::nullopt;
  }

  [[nodiscard]] double clearance() const {
    const bool is_cutting = !runs_rapid(scene_.path.moves[move_]);
    const ToolContour& watched = w_.is_fixture ? tool_.fixture : is_cutting ? tool_.non_cutting : tool_.part;
    return std::max(0.0, watched.nearest(in_tool(pose(), w_.point)).signed_distance_mm);
  }

  const ClaimedScene& scene_;
  const ClaimedTool& tool_;
  Forms forms_;
  std::size_t move_;
  const MoveClaim& claim_;
  const ClaimedWitness& w_;
};

/// Returns why the depth of a claim is no gouge; nothing: it is one.
std::optional<std::string> find_no_gouge(const ClaimedScene& scene, const ClaimedTool& tool, std::size_t move,
                                         const MoveClaim& claim) {
  if (claim.depth_mm > scene.tolerance_mm) return std::nullopt;
  const Vec2 at = in_tool(claimed_pose(scene, move, claim.witness->t, claim.witness->turn), claim.witness->point);
  if (tool.clearance.has(at)) return std::nullopt;
  const ClaimedLimit* limit = limit_of(scene, *claim.witness);
  if (limit != nullptr && claim.depth_mm > limit->tolerance_mm) return std::nullopt;
  return "its depth is no more than the tolerance";
}

}  // namespace

ClaimedTool::ClaimedTool(const ToolVariants& tool)
    : bare(tool.bare),
      part(tool.against_part),
      fixture(tool.against_fixture),
      clearance(tool.with_clearance),
      non_cutting(tool.non_cutting) {
  if (tool.alone == nullptr) return;
  const auto take = [](const BodiesAlone& bodies, std::vector<ToolContour>& contours) {
    for (const std::shared_ptr<const CompiledTool>& body : bodies) contours.emplace_back(*body);
  };
  take(tool.alone->bare, bare_alone);
  take(tool.alone->against_part, part_alone);
  take(tool.alone->against_fixture, fixture_alone);
}

ClaimedTools claimed_tools(const ClaimedScene& scene) {
  ClaimedTools tools;
  for (const ToolVariants* tool : scene.tools)
    tools.push_back(tool == nullptr ? nullptr : std::make_unique<ClaimedTool>(*tool));
  return tools;
}

Vec2 in_tool(const Pose& pose, const Vec3& point) {
  const Vec3 u = point - pose.tip;
  return {u.cross(pose.axis).norm(), u.dot(pose.axis)};
}

double depth_in_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point) {
  const Vec3 q = frame.inverse().point(point);
  double deepest = 0;
  for (const SolidDepth& head : scene.heads) deepest = std::max(deepest, head.at(q));
  return deepest;
}

double distance_from_heads(const ClaimedScene& scene, const RigidTransform& frame, const Vec3& point) {
  const Vec3 q = frame.inverse().point(point);
  double nearest = std::numeric_limits<double>::infinity();
  for (const SolidDepth& head : scene.heads) {
    const double depth = head.at(q);
    nearest = std::min(nearest, depth > 0 ? -depth : head.distance_to_surface(q));
  }
  return nearest;
}

std::optional<std::string> find_witness_fault(const ClaimedScene& scene, const ClaimedTools& tools, std::size_t move,
                                              const MoveClaim& claim) {
  const std::size_t tool = scene.path.moves[move].tool;
  const double upper = claim.depth_upper_mm.value_or(1e300);
  if (!(claim.depth_mm <= upper)) return "its depth is more than its bound";
  if (claim.state == ClaimedState::near && claim.depth_upper_mm && upper > scene.largest_clean_mm() + kExact_mm)
    return "it is said to be no gouge, and its bound is more than tolerance + resolution";
  if (claim.state != ClaimedState::gouge && claim.state != ClaimedState::near && !claim.witness) return std::nullopt;
  if (claim.state == ClaimedState::buried) return std::nullopt;  // a result states no depth of its witness
  if (!claim.witness) return "it has no witness";
  if (tool >= tools.size() || !tools[tool]) return "its tool is not defined";
  const Forms forms = whole_forms(*tools[tool], claim.witness->is_fixture);
  if (auto fault = WitnessChecker(scene, *tools[tool], forms, move, claim).fault()) return fault;
  if (claim.state != ClaimedState::gouge) return std::nullopt;
  return find_no_gouge(scene, *tools[tool], move, claim);
}

std::optional<std::string> find_further_fault(const ClaimedScene& scene, const ClaimedTools& tools, std::size_t move,
                                              const FurtherClaim& further) {
  const std::size_t tool = scene.path.moves[move].tool;
  if (further.is_stock) return "stock is no further contact";
  if (!further.witness) return std::nullopt;  // no depth is stated
  if (!(further.depth_mm <= further.depth_upper_mm.value_or(1e300))) return "its depth is more than its bound";
  const ClaimedWitness& w = *further.witness;
  if (w.is_stock || w.body != further.body || w.is_fixture != further.is_fixture)
    return "its body or its obstacle is another one";
  if (tool >= tools.size() || !tools[tool]) return "its tool is not defined";
  const ClaimedTool& of = *tools[tool];
  const auto body = static_cast<std::size_t>(w.body);
  if (w.body != Body::head && (of.bare_alone.size() <= body || of.bare_alone[body].empty()))
    return "its tool has no such body";
  const MoveClaim claim{ClaimedState::gouge, further.depth_mm, further.depth_upper_mm, {}, w, {}};
  const Forms forms = w.body == Body::head
                          ? whole_forms(of, w.is_fixture)
                          : Forms{(w.is_fixture ? of.fixture_alone : of.part_alone)[body], of.bare_alone[body]};
  if (auto fault = WitnessChecker(scene, of, forms, move, claim).fault()) return fault;
  return find_no_gouge(scene, of, move, claim);
}

}  // namespace gouge
