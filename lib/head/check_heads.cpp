#include "lib/head/check_heads.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/parallel.h"
#include "lib/head/head_search.h"
#include "lib/mesh/winding.h"

namespace gouge {
namespace {

constexpr std::size_t kMovesPerChunk = 8;
constexpr std::uint64_t kMostBounds = 100'000;
// As for a buried tool (lib/check/buried.cpp): what an open mesh leaves undecided.
constexpr double kSurelyOutside = 0.25, kSurelyInside = 0.75;

constexpr const char* kOpen = "the mesh is open here: it cannot tell whether the head is buried";
constexpr const char* kThin =
    "the tolerance is as large as the head is thick: it may be buried; give a smaller tolerance";
constexpr const char* kBudget =
    "the head comes too close to the surface for too long: the budget of bounds ran out";

void decide(MoveState state, const char* reason, MoveVerdict& verdict) {
  verdict.state = state;
  verdict.reason = reason;
  verdict.clearance_mm.reset();
}

}  // namespace

HeadChecker::HeadChecker(const std::vector<HeadBody>& heads, const Scene& scene)
    : heads_(heads), parts_(scene.parts.size()) {
  DepthBodyOptions lean;
  lean.directions = *make_directions(DirectionFamily::cube, 6);
  lean.is_lean = true;
  for (const std::vector<IndexedMesh>* meshes : {&scene.parts, &scene.fixtures}) {
    for (const IndexedMesh& mesh : *meshes) bodies_.push_back(build_depth_body(mesh, lean));
  }
  for (const DepthBody& body : bodies_) surfaces_.push_back(&body);
}

std::uint64_t HeadChecker::check(const Motion& motion, const CheckOptions& options,
                                 MoveVerdict& verdict) const {
  const HeadMotion head_motion(motion);
  std::uint64_t bounds = 0;
  for (const HeadBody& head : heads_) {
    const HeadAnswer found =
        search_head(head_motion, head, surfaces_,
                    {options.tolerance_mm, options.resolution_mm,
                     std::min(kMostBounds, options.budget_per_move), options.gouge_gap_mm});
    bounds += found.bounds;
    join(found, options, verdict);
    if (verdict.state == MoveState::clean || verdict.state == MoveState::near_miss)
      look_inside(motion, head, verdict);
  }
  return bounds;
}

double HeadChecker::excess_at(const Pose& pose, double allowed_mm, double accuracy_mm) const {
  CheckOptions options;
  options.tolerance_mm = allowed_mm;
  options.resolution_mm = accuracy_mm;
  MoveVerdict verdict;
  check(Motion(pose), options, verdict);
  if (verdict.state == MoveState::gouge) return verdict.depth_mm - allowed_mm;
  return verdict.state == MoveState::clean ? 0 : std::numeric_limits<double>::infinity();
}

void HeadChecker::join(const HeadAnswer& found, const CheckOptions& options, MoveVerdict& verdict) const {
  verdict.depth_upper_mm = std::max(verdict.depth_upper_mm, found.depth_upper_mm);
  const bool is_gouge = found.depth_mm > options.tolerance_mm;
  const bool is_open = found.depth_upper_mm > options.tolerance_mm + options.resolution_mm;
  const bool is_worse = found.has_witness && found.depth_mm > verdict.depth_mm;
  if (is_gouge ? is_worse || verdict.state != MoveState::gouge : is_worse) take(found, verdict);
  if (is_gouge) {
    verdict.state = MoveState::gouge;
    verdict.clearance_mm.reset();
    verdict.reason.clear();
  } else if (is_open && verdict.state != MoveState::gouge && verdict.state != MoveState::buried) {
    verdict.state = MoveState::not_certified;
    verdict.reason = kBudget;
  }
}

void HeadChecker::take(const HeadAnswer& found, MoveVerdict& verdict) const {
  const bool is_part = found.surface < parts_;
  const std::size_t mesh = is_part ? found.surface : found.surface - parts_;
  verdict.depth_mm = found.depth_mm;
  Witness w;
  w.t = found.t;
  w.point = found.point;
  w.normal = found.normal;
  w.body = Body::head;
  w.against = is_part ? Against::part : Against::fixture;
  w.mesh = static_cast<std::uint32_t>(mesh);
  w.triangle = surfaces_[found.surface]->mesh.file_triangle[found.triangle];
  verdict.witness = w;
}

/// No surface comes as deep into the head as its cores lie, so each core stays on one side during the whole
/// move.
void HeadChecker::look_inside(const Motion& motion, const HeadBody& head, MoveVerdict& verdict) const {
  const RigidTransform pose = HeadMotion(motion).at(0);
  for (std::size_t k = 0; k < head.cores.size(); ++k) {
    if (head.core_depths_mm[k] <= verdict.depth_upper_mm)
      return decide(MoveState::not_certified, kThin, verdict);
    const Vec3 core = pose.point(head.cores[k]);
    for (const DepthBody* body : surfaces_) {
      if (!body->mesh.box().contains(core)) continue;
      const double winding = std::abs(winding_number(body->mesh, core));
      if (winding >= kSurelyInside) return decide(MoveState::buried, kHeadIsBuried, verdict);
      if (winding > kSurelyOutside) decide(MoveState::not_certified, kOpen, verdict);
    }
  }
}

void check_heads(const Toolpath& toolpath, const std::vector<HeadBody>& heads, const Scene& scene,
                 const CheckOptions& options, CheckResult& result) {
  if (heads.empty()) return;
  const HeadChecker checker(heads, scene);
  std::vector<std::uint64_t> bounds(result.verdicts.size(), 0);
  for_each_chunk(result.verdicts.size(), kMovesPerChunk, options.threads,
                 [&](std::size_t first, std::size_t last) {
                   for (std::size_t i = first; i < last; ++i) {
                     if (result.verdicts[i].state == MoveState::not_checked) continue;
                     const Motion motion = motion_of(toolpath, i, options.rapid);
                     bounds[i] = checker.check(motion, options, result.verdicts[i]);
                   }
                 });
  for (const std::uint64_t b : bounds) result.evaluations += b;
  result.events = gather_events(toolpath, result.verdicts);
  for (Event& event : result.events) {
    if (event.state == MoveState::buried && result.verdicts[event.first_move].reason == kHeadIsBuried)
      event.body = Body::head;
  }
  count_states(result);
}

}  // namespace gouge
