#include <algorithm>
#include <cmath>

#include "lib/base/number_text.h"
#include "postproc/gcode/iso/block_runner.h"

// Drilling cycles as the motions that the control makes. Pecks are on the line of the hole.

namespace gouge {

void BlockRunner::drill(const GcodeRow& row) {
  const GcodeCycle* const cycle = find_cycle(index_.control(), row.number);
  if (cycle == nullptr) return lose_rest("the cycle has no row", line_);
  const bool is_incremental = modes_.is_absolute == false;
  if (words_.has('R')) {
    cycle_.r_mm = length('R');
    cycle_.is_r_step = is_incremental;
  }
  if (words_.is_axis('Z')) {
    cycle_.z_mm = length('Z');
    cycle_.is_z_step = is_incremental;
  }
  // LinuxCNC reads them by the mode of the block that drills.
  if (index_.control().cycles_follow_mode) cycle_.is_r_step = cycle_.is_z_step = is_incremental;
  if (!words_.has_axes() && !words_.has('R')) {
    const auto takes_them = [](const GcodeRow* one) {
      return one->words.find_first_of("LPQK") != std::string_view::npos;
    };
    const bool is_of_others = std::ranges::any_of(words_.rows(), takes_them);
    const bool has_cycle_words =
        words_.row_of(ModalGroup::motion) != nullptr || (words_.has_any("LPQK") && !is_of_others);
    if (has_cycle_words) lose_rest("words of a cycle without a position", line_);
    return;
  }
  Target at = target();
  if (error_) return;
  at.place.xyz.z() = motion_.place().xyz.z();
  const int times = times_of_cycle().value_or(0);
  cycle_.times = is_incremental ? times : std::min(times, 1);  // the same hole again is the same motion
  if (at.open.empty() && cycle->form == DrillForm::not_checked) at.open = "the cycle moves across the hole, or by hand";
  if (cycle_.times > 1 && words_.has_any("ABC")) {
    // The control may turn the joint before each repeat, so its place afterwards is not known either.
    if (at.open.empty())
      at.open = "a repeated cycle has a step of a rotary joint; expected a block for each position of the joint";
    at.place.angles.fill(AxisPlace::kUnknownCoordinate);
  }
  const Vec3 step = is_incremental ? Vec3(at.place.xyz - motion_.place().xyz) : Vec3(Vec3::Zero());
  drill_at(*cycle, at, step);
}

// Times that the block drills. None: L0 or K0, or no whole number.
std::optional<int> BlockRunner::times_of_cycle() const {
  constexpr int kMaxTimes = 10'000;
  for (const char letter : {'L', 'K'}) {
    if (!words_.has(letter)) continue;
    const auto times = words_.integer(letter);
    return times && *times >= 1 && *times <= kMaxTimes ? times : std::nullopt;
  }
  return 1;
}

std::string BlockRunner::why_end_unknown(const DrillLevels& levels) {
  if (!modes_.plane || *modes_.plane != PlaneAxes{0, 1, 2}) return "the cycle is not in the plane of G17";
  if (!modes_.retracts_to_start) return "nothing states G98 or G99 before the cycle; expected --start G98";
  if (!cycle_.open.empty()) return cycle_.open;
  if (!cycle_.r_mm || !cycle_.z_mm) return "the cycle has no R or no Z";
  if (!modes_.has_feed) return "no feed is stated, so the control refuses the cycle; expected F before it";
  const char letter = words_.has('L') ? 'L' : 'K';
  if (cycle_.times < 1)
    return std::string(1, letter) + " of the cycle is " +
           (is_known(words_.value(letter)) ? exact_text(words_.value(letter)) : "not known") +
           ", which is not read; expected a whole number from 1";
  if (cycle_.is_r_step != cycle_.is_z_step || (cycle_.is_r_step && modes_.is_absolute == true))
    return "R or Z of the cycle is a step of G91, and the other one or this block is not";
  const bool counts_from_elsewhere = std::abs(motion_.place().xyz.z() - cycle_.start_mm) > 0;
  if (cycle_.is_r_step && index_.control().cycles_count_from_start && counts_from_elsewhere)
    return "R of the cycle counts from the level at which it began, which is not the present one; expected G98 or G90";
  if (!(levels.bottom_mm < levels.r_mm)) return "the bottom of the hole is not below R";
  if (!(levels.start_mm >= levels.r_mm)) return "the cycle begins below R, or at a level that is not known";
  return {};
}

// Goes to the end of a cycle that is not checked. Where its motion is not understood, the end is not known either.
void BlockRunner::leave_hole_open(const Target& at, const Vec3& end, const std::string& why_unknown) {
  AxisPlace to = at.place;
  to.xyz = end;
  if (!why_unknown.empty()) {
    to.xyz.setConstant(AxisPlace::kUnknownCoordinate);
    for (const char letter : {'A', 'B', 'C'})
      if (const auto rotary = motion_.mapper().rotary_of(letter); rotary && words_.is_axis(letter))
        to.angles.at(*rotary) = AxisPlace::kUnknownCoordinate;
  }
  motion_.go_unchecked(MoveKind::feed, to, at.open.empty() ? why_unknown : at.open);
}

void BlockRunner::drill_at(const GcodeCycle& cycle, const Target& at, const Vec3& step_mm) {
  const double level = motion_.place().xyz.z();
  const double r = cycle_.r_mm.value_or(kUnknownValue) + (cycle_.is_r_step ? level : 0);
  const double z = cycle_.z_mm.value_or(kUnknownValue) + (cycle_.is_z_step ? r : 0);
  const double out_mm = modes_.retracts_to_start.value_or(true) ? std::max(cycle_.start_mm, r) : r;
  const std::string why_unknown = why_end_unknown({level, r, z});
  AxisPlace over = at.place;
  if (!at.open.empty() || !why_unknown.empty()) {
    Vec3 end = over.xyz + step_mm * std::max(cycle_.times - 1, 0);
    end.z() = out_mm;
    return leave_hole_open(at, end, why_unknown);
  }
  const bool feeds_out = cycle.form == DrillForm::feed_in_feed_out || cycle.form == DrillForm::thread;
  if (cycle.form == DrillForm::thread) motion_.stop_spindle(false);  // rigid tapping turns it
  for (int i = 0; i < cycle_.times; ++i) {
    over.xyz.z() = motion_.place().xyz.z();
    AxisPlace above = over, bottom = over, out = over;
    above.xyz.z() = r;
    bottom.xyz.z() = z;
    out.xyz.z() = out_mm;
    motion_.go(MoveKind::rapid, over);
    motion_.go(MoveKind::rapid, above);
    motion_.go(MoveKind::feed, bottom);
    if (feeds_out) motion_.go(MoveKind::feed, above);
    if (!feeds_out || out_mm > r) motion_.go(MoveKind::rapid, out);
    over.xyz += step_mm;
  }
}

}  // namespace gouge
