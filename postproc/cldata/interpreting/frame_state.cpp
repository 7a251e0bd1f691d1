#include "postproc/cldata/interpreting/frame_state.h"

#include <cmath>
#include <string>
#include <utility>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

constexpr double kFarthest_mm = 1e7;  // ten kilometres: no machine is that large

}  // namespace

bool FrameState::state_unit(double mm_per_unit) {
  mm_per_unit_ = mm_per_unit;
  is_recorded_ = false;
  return !std::exchange(is_unit_stated_, true);
}

bool FrameState::set(const RigidTransform& to_part) {
  const double change = (to_part.rotation - to_part_.rotation).cwiseAbs().maxCoeff() +
                        (to_part.shift - to_part_.shift).cwiseAbs().maxCoeff();
  to_part_ = to_part;
  is_recorded_ = false;
  const bool is_turned = !to_part.rotation.isIdentity(kIdentityError);
  has_turned_ = has_turned_ || is_turned;
  if (is_turned || to_part.shift.norm() > kIdentityError) line_ = in_.line();
  return change > kIdentityError;
}

void FrameState::begin_block() {
  to_part_ = {};
  is_recorded_ = false;
}

std::optional<Vec3> FrameState::read_tip(std::size_t first) {
  const Vec3 tip = in_.vector(first) * mm_per_unit_;
  if (tip.cwiseAbs().maxCoeff() <= kFarthest_mm) return tip;
  in_.fail("path-range", in_.major() + ": a coordinate is beyond " + fixed_text(kFarthest_mm, 0) +
                             " mm; expected a position within a machine");
  return std::nullopt;
}

// Each component of a unit vector is off by `rounding`: its length by sqrt(3) of it, the product of two by twice that,
// and what the cross product of both differs from a third by no more than six times `rounding`.
std::optional<RigidTransform> FrameState::make(const Vec3& origin, const Vec3& x, const Vec3& y,
                                               const std::optional<Vec3>& z, double rounding, const char* what) {
  constexpr double kOfLength = 1.74, kOfProduct = 3.48, kOfThird = 6;
  const bool is_frame = std::abs(x.norm() - 1) <= kFrameError && std::abs(y.norm() - 1) <= kFrameError &&
                        std::abs(x.dot(y)) <= kFrameError;
  if (!is_frame) {
    in_.fail("path-frame",
             std::string(what) + ": the axes are not two unit vectors at right angles; expected X and Y axis");
    return std::nullopt;
  }
  RigidTransform frame;
  const Vec3 unit_x = x.normalized();
  const Vec3 unit_z = unit_x.cross(y).normalized();
  frame.rotation.col(0) = unit_x;
  frame.rotation.col(1) = unit_z.cross(unit_x);
  frame.rotation.col(2) = unit_z;
  frame.shift = origin * mm_per_unit_;
  is_skewed_ = std::abs(x.norm() - 1) > kOfLength * rounding + kIdentityError ||
               std::abs(y.norm() - 1) > kOfLength * rounding + kIdentityError ||
               std::abs(x.dot(y)) > kOfProduct * rounding + kIdentityError ||
               (z && (*z - unit_z).norm() > kOfThird * rounding + kIdentityError);
  return frame;
}

void FrameState::write_note() const {
  in_.report(Severity::note, "path-csys", csys_, "CSYS statement",
             " not applied: Creo writes positions in the machine coordinate system");
}

const MotionFrame* FrameState::record(std::deque<MotionFrame>& frames) {
  if (!std::exchange(is_recorded_, true)) frames.push_back({mm_per_unit_, to_part_});
  return &frames.back();
}

}  // namespace gouge
