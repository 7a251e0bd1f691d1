#include <cmath>

#include "postproc/gcode/iso/block_runner.h"

// Drilling cycles as the motions that the control makes. Pecks are on the line of the hole.

namespace gouge {

void BlockRunner::drill(const GcodeRow& row) {
  const GcodeCycle* const cycle = find_cycle(index_.control(), row.number);
  if (cycle == nullptr) return lose_rest("the cycle has no row", line_);
  const bool is_incremental = modes_.is_absolute == false;
  if (words_.has('R')) cycle_.r_mm = length('R');
  if (words_.is_axis('Z')) cycle_.z_mm = length('Z');
  if (!words_.has_axes() && !words_.has('R')) {
    const bool has_cycle_words = words_.row_of(ModalGroup::motion) != nullptr || words_.has_any("LPQK");
    if (has_cycle_words) lose_rest("words of a cycle without a position", line_);
    return;
  }
  Target at = target();
  if (error_) return;
  at.place.xyz.z() = motion_.place().xyz.z();
  const int times = words_.has('L')   ? words_.integer('L').value_or(0)
                    : words_.has('K') ? words_.integer('K').value_or(0)
                                      : 1;
  if (!modes_.has_feed) at.open = "no feed is stated, so the control refuses the cycle; expected F before it";
  if (times < 1 || (times > 1 && is_incremental)) at.open = "the number of times of the cycle is not understood";
  if (!cycle_.r_mm || !cycle_.z_mm) at.open = "the cycle has no R or no Z";
  if (!modes_.retracts_to_start) at.open = "nothing states G98 or G99 before the cycle; expected --start G98";
  if (!modes_.plane || *modes_.plane != PlaneAxes{0, 1, 2}) at.open = "the cycle is not in the plane of G17";
  if (cycle->form == DrillForm::not_checked) at.open = "the cycle moves across the hole, or by hand";
  drill_at(*cycle, at);
}

void BlockRunner::drill_at(const GcodeCycle& cycle, const Target& at) {
  const bool is_incremental = modes_.is_absolute == false;
  const double level = motion_.place().xyz.z();
  const double r = cycle_.r_mm.value_or(kUnknownValue) + (is_incremental ? level : 0);
  const double z = cycle_.z_mm.value_or(kUnknownValue) + (is_incremental ? r : 0);
  std::string open = at.open;
  if (open.empty() && !(z < r)) open = "the bottom of the hole is not below R";
  if (open.empty() && !(level >= r)) open = "the cycle begins below R, or at a level that is not known";
  AxisPlace over = at.place, above = at.place, bottom = at.place, out = at.place;
  above.xyz.z() = r;
  bottom.xyz.z() = z;
  out.xyz.z() = modes_.retracts_to_start.value_or(true) ? std::max(cycle_.start_mm, r) : r;
  if (!open.empty()) return motion_.go_unchecked(MoveKind::feed, out, open);
  const bool feeds_out = cycle.form == DrillForm::feed_in_feed_out || cycle.form == DrillForm::thread;
  motion_.go(MoveKind::rapid, over);
  motion_.go(MoveKind::rapid, above);
  motion_.go(MoveKind::feed, bottom);
  if (feeds_out) motion_.go(MoveKind::feed, above);
  if (!feeds_out || out.xyz.z() > r) motion_.go(MoveKind::rapid, out);
}

}  // namespace gouge
