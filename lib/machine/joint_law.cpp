#include "lib/machine/joint_law.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lib/base/tolerance.h"
#include "lib/machine/kinematics.h"
#include "lib/machine/rotary_law.h"
#include "lib/path/toolpath.h"

namespace gouge {
namespace {

// Joints that move by less stand, mm and rad: the turn that winding leaves of equal angles is rounding.
constexpr double kStands_mm = Tolerance::kRounding_mm, kStands_rad = Tolerance::kExactDirection;

/// The way of one joint: evenly from `from`, by `by`, until it arrives.
struct JointRun {
  double from = 0, by = 0, arrival = 1;

  [[nodiscard]] double at(double t) const { return from + (t < arrival ? t / arrival : 1.0) * by; }
  /// Its speed right after t0.
  [[nodiscard]] double rate(double t0) const { return t0 < arrival ? by / arrival : 0; }
};
using JointRuns = std::vector<JointRun>;

bool moves(const Joint& joint, const JointRun& run) {
  return std::abs(run.by) > (joint.type == JointType::rotary ? kStands_rad : kStands_mm);
}

/// Sets the arrivals of joints that run at their own rates. Returns the joint whose rate is missing; null: none is.
const Joint* arrive_independently(const Machine& machine, JointRuns& runs) {
  std::size_t moving = 0;
  double longest = 0;
  const Joint* unknown = nullptr;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Joint& joint = machine.joints[k];
    if (!moves(joint, runs[k])) continue;
    ++moving;
    if (joint.rate)
      longest = std::max(longest, std::abs(runs[k].by) / *joint.rate);
    else
      unknown = &joint;
  }
  if (moving < 2) return nullptr;  // one joint alone is as fast as it is
  if (unknown != nullptr) return unknown;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (moves(machine.joints[k], runs[k])) runs[k].arrival = std::abs(runs[k].by) / *machine.joints[k].rate / longest;
  }
  return nullptr;
}

bool several_move(const Machine& machine, const JointRuns& runs) {
  std::size_t moving = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) moving += moves(machine.joints[k], runs[k]) ? 1U : 0U;
  return moving > 1;
}

JointRuns runs_between(const Machine& machine, const Vec3& from, const Vec3& to, const AngleRange& angles,
                       double tool_length_mm) {
  const JointValues start = inverse(machine, from, angles.from, tool_length_mm),
                    end = inverse(machine, to, angles.to, tool_length_mm);
  JointRuns runs(start.size());
  for (std::size_t k = 0; k < runs.size(); ++k) runs[k] = {start[k], end[k] - start[k], 1};
  return runs;
}

/// Returns whether the poses at both ends determine the linear joints.
bool are_determined(const Machine& machine, const AngleRange& angles) {
  return linear_spread(machine, angles.from) >= kMinLinearSpread &&
         linear_spread(machine, angles.to) >= kMinLinearSpread;
}

/// All joints run. Bounds: docs/method/machine.md, "The laws joint and independent".
class ChainRun : public AxisPath, public TipPath {
 public:
  ChainRun(std::shared_ptr<const Machine> machine, JointRuns runs, double tool_length_mm)
      : machine_(std::move(machine)), runs_(std::move(runs)), tool_length_mm_(tool_length_mm) {
    bool turns = false;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      turns = turns || (machine_->joints[k].type == JointType::rotary && moves(machine_->joints[k], runs_[k]));
      if (runs_[k].arrival < 1) kinks_.push_back(runs_[k].arrival);
    }
    std::ranges::sort(kinks_);
    kinks_.erase(std::unique(kinks_.begin(), kinks_.end()), kinks_.end());
    is_tip_even_ = !turns && kinks_.empty();
    const Joint &first = machine_->joints[machine_->rotary[0]], &second = machine_->joints[machine_->rotary[1]];
    cosine_ = std::abs(first.direction.dot(second.direction));
    sine_ = first.direction.cross(second.direction).norm();
  }

  [[nodiscard]] Eigen::Matrix3d axes_at(double t) const override {
    return tool_axes(*machine_, {rotary(0).at(t), rotary(1).at(t)});
  }
  [[nodiscard]] double turn_rate_rad(double t0, double /*t1*/) const override {
    const double a = rotary(0).rate(t0), b = rotary(1).rate(t0);
    return std::sqrt(a * a + b * b + 2 * std::abs(a * b) * cosine_);
  }
  [[nodiscard]] double turn_acceleration_rad(double t0, double /*t1*/) const override {
    return std::abs(rotary(0).rate(t0) * rotary(1).rate(t0)) * sine_;
  }
  [[nodiscard]] const TipPath* tip_path() const override { return is_tip_even_ ? nullptr : this; }

  [[nodiscard]] Vec3 tip_at(double t) const override { return carried(t, t).tip; }
  // The velocity is off its mean by no more, in the square mean, than its change allows.
  [[nodiscard]] TipBounds bounds(double t0, double t1) const override {
    const double h = t1 - t0, acceleration = carried(t0, t1).acceleration;
    const double spread = acceleration * h * h;
    return {std::sqrt((tip_at(t1) - tip_at(t0)).squaredNorm() + spread * spread / 12), acceleration};
  }
  [[nodiscard]] std::span<const double> kinks() const override { return kinks_; }

 private:
  /// The tip and its velocity in the middle of an interval, and what its acceleration is nowhere larger than.
  struct CarriedTip {
    Vec3 tip, velocity;
    double acceleration = 0;
  };

  [[nodiscard]] const JointRun& rotary(std::size_t k) const { return runs_[machine_->rotary[k]]; }

  /// From the tool to the part: each joint carries the point r, of velocity v, that the joints before it have made.
  [[nodiscard]] CarriedTip carried(double t0, double t1) const {
    const double middle = 0.5 * (t0 + t1), half = 0.5 * (t1 - t0);
    CarriedTip of{machine_->rest.point(Vec3(0, 0, -tool_length_mm_)), Vec3::Zero(), 0};
    for (std::size_t k = runs_.size(); k-- > 0;) {
      const Joint& joint = machine_->joints[k];
      const Vec3& d = joint.direction;
      const double value = runs_[k].at(middle), rate = runs_[k].rate(t0);
      if (joint.type == JointType::linear) {
        of.tip += value * d;
        of.velocity += rate * d;
        continue;
      }
      const Vec3 r = of.tip - joint.point, around = d.cross(r);
      const double grown = half * of.acceleration, w = std::abs(rate);
      of.acceleration +=
          2 * w * (d.cross(of.velocity).norm() + grown) + w * w * (around.norm() + half * (of.velocity.norm() + grown));
      const Eigen::Matrix3d turned = Eigen::AngleAxisd(value, d).toRotationMatrix();
      of.tip = joint.point + turned * r;
      of.velocity = turned * (of.velocity + rate * around);
    }
    return of;
  }

  std::shared_ptr<const Machine> machine_;
  JointRuns runs_;
  double tool_length_mm_;
  std::vector<double> kinks_;
  bool is_tip_even_ = false;
  double cosine_ = 0, sine_ = 0;  // of the angle between the rotary joints
};

}  // namespace

std::string JointLaw::name() const {
  constexpr std::array<const char*, 3> kWords = {"joint of ", "independent of ", "not stated of "};
  return kWords[static_cast<std::size_t>(timing_)] + machine_->name;
}

std::shared_ptr<const AxisPath> JointLaw::between(const Pose& from, const Pose& to) const {
  return of_move(nullptr, 0, from, to);
}

std::optional<double> JointLaw::length_of(const Toolpath* path, std::size_t move) const {
  if (!depends_on_tool_length(*machine_)) return 0;
  return path == nullptr ? tool_length_mm_ : gauge_length_of_move(*path, move, tool_length_mm_);
}

bool JointLaw::lacks_part_zero() const { return !machine_->is_placed && depends_on_part_zero(*machine_); }

std::shared_ptr<const AxisPath> JointLaw::of_move(const Toolpath* path, std::size_t move, const Pose& from,
                                                  const Pose& to) const {
  const JointPath* const joints = path == nullptr ? nullptr : path->joints.get();
  const auto angles = angles_of_move(*machine_, joints, move, from.axis, to.axis);
  const std::optional<double> length_mm = length_of(path, move);
  if (!angles || !length_mm || lacks_part_zero()) {
    // Any standing angles give a straight line, if all joints run together.
    const bool is_line = timing_ == JointTiming::together || from.tip == to.tip;
    return from.axis == to.axis && is_line ? standing_at(from.axis) : nullptr;
  }
  if (!are_determined(*machine_, *angles)) {
    // A tool that stands needs no values of linear joints.
    const bool stands = from.tip == to.tip && from.axis == to.axis && angles->from == angles->to;
    return stands ? standing_with(tool_axes(*machine_, angles->to)) : nullptr;
  }
  JointRuns runs = runs_between(*machine_, from.tip, to.tip, *angles, *length_mm);
  if (timing_ == JointTiming::independent && arrive_independently(*machine_, runs) != nullptr) return nullptr;
  if (timing_ == JointTiming::unknown && several_move(*machine_, runs)) return nullptr;
  return std::make_shared<ChainRun>(machine_, std::move(runs), *length_mm);
}

std::string JointLaw::why_open(const Toolpath& path, std::size_t index) const {
  const Move& move = path.moves[index];
  const Pose& from = path.start_of(index);
  const auto angles = angles_of_move(*machine_, path.joints.get(), index, from.axis, move.end.axis);
  if (!angles) return {};
  const std::optional<double> length_mm = length_of(&path, index);
  if (!length_mm && tool_length_mm_)
    return "the length of one tool is stated, and the path has " + std::to_string(path.tools.size());
  if (!length_mm) return "the length from the gauge point to the tip is not stated";
  if (lacks_part_zero())
    return "the motion depends on the place of the part on machine " + machine_->name + "; expected --zero";
  if (!are_determined(*machine_, *angles))
    return "the linear joints lie nearly in one plane at an end of the move, so that their values are not determined";
  JointRuns runs = runs_between(*machine_, from.tip, move.end.tip, *angles, *length_mm);
  if (move.curve_kind != CurveKind::none) {
    if (timing_ != JointTiming::together) return "no manual states how joints run along a curve at their own rates";
    const bool turns =
        std::ranges::any_of(machine_->rotary, [&](std::size_t k) { return moves(machine_->joints[k], runs[k]); });
    return turns ? "no manual states how joints run along a curve while rotary joints turn" : std::string();
  }
  if (timing_ == JointTiming::together) return {};
  if (timing_ == JointTiming::unknown)
    return several_move(*machine_, runs)
               ? "nothing states how joints run in a rapid without tool centre point control; expected "
                 "--joint-rapid-law joint or independent"
               : std::string();
  const Joint* const unknown = arrive_independently(*machine_, runs);
  return unknown == nullptr ? std::string() : "the rate of joint " + unknown->name + " is not in the machine file";
}

}  // namespace gouge
