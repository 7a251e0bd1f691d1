#include "lib/correct/motion_checker.h"

#include <cmath>

#include "lib/mesh/winding.h"

namespace gouge {
namespace {

// As for a buried tool (lib/check/buried.cpp).
constexpr double kSurelyOutside = 0.25, kSurelyInside = 0.75;

constexpr double kAnyGap_mm = 1e6;  // how far the depth of a gouge is left open when only the verdict counts
constexpr const char* kInside = "the tool is inside the solid; no surface is inside the tool";
constexpr const char* kThin = "the surface may reach the middle of the cutter, so it may be buried";

}  // namespace

MotionChecker::MotionChecker(const PreparedScene& scene, const CheckOptions& options, const HeadChecker* heads)
    : scene_(scene), options_(options), heads_(heads) {
  for (const std::vector<IndexedMesh>* all : {&scene.scene->parts, &scene.scene->fixtures}) {
    for (const IndexedMesh& mesh : *all) {
      meshes_.push_back(&mesh);
      boxes_.push_back(mesh.box());
    }
  }
}

MoveVerdict MotionChecker::check(const Motion& motion, MoveKind kind, const ToolForms& tool,
                                 const CheckOptions& options, bool is_start_outside) const {
  MoveVerdict verdict = check_move(motion, kind, tool, scene_, options);
  if (verdict.state == MoveState::not_checked) return verdict;
  if (heads_ != nullptr) heads_->check(motion, options, verdict);
  if (verdict.state != MoveState::clean && verdict.state != MoveState::near_miss) return verdict;
  if (verdict.depth_upper_mm >= tool.bare.core_depth_mm) {
    verdict.state = MoveState::not_certified;
    verdict.reason = kThin;
  } else if (!is_start_outside && side_of(motion.start(), tool) == Side::inside) {
    verdict.state = MoveState::buried;
    verdict.reason = kInside;
  }
  return verdict;
}

bool MotionChecker::is_clean(const Motion& motion, MoveKind kind, const ToolForms& tool, const CheckOptions& options,
                             bool is_start_outside) const {
  if (!motion.is_defined()) return false;
  CheckOptions quick = options;
  quick.gouge_gap_mm = kAnyGap_mm;
  return check(motion, kind, tool, quick, is_start_outside).state == MoveState::clean;
}

MoveVerdict MotionChecker::measure(const Pose& pose, MoveKind kind, const ToolForms& tool) const {
  CheckOptions exact = options_;
  exact.tolerance_mm = 0;
  exact.near_miss_mm = 0;
  return check(Motion(pose), kind, tool, exact);
}

Side MotionChecker::side_of(const Pose& pose, const ToolForms& tool) const {
  const Vec3 core = pose.tip + tool.bare.core.y() * pose.axis;
  Side side = Side::outside;
  for (std::size_t m = 0; m < meshes_.size(); ++m) {
    if (!boxes_[m].contains(core)) continue;
    const double winding = std::abs(winding_number(*meshes_[m], core));
    if (winding >= kSurelyInside) return Side::inside;
    if (winding > kSurelyOutside) side = Side::unknown;
  }
  return side;
}

}  // namespace gouge
