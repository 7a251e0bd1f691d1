#include "lib/path/axis_quality.h"

#include <algorithm>

#include "lib/path/bending_sum.h"
#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr double kSecondsOfMinute = 60;

bool is_feed_move(const Move& move) { return move.has_start && !runs_rapid(move); }

class QualityPass {
 public:
  QualityPass(const Toolpath& path, const std::optional<double>& max_rotary_rad_per_s)
      : path_(path), max_rotary_rad_per_s_(max_rotary_rad_per_s) {
    if (max_rotary_rad_per_s_) quality_.limited_feed_seconds = 0;
  }

  AxisQuality run() {
    for (std::size_t i = 0; i < path_.moves.size(); ++i) {
      if (is_feed_move(path_.moves[i]))
        add(i);
      else
        bending_.interrupt();
    }
    quality_.bending = bending_.value();
    return quality_;
  }

 private:
  void add(std::size_t i) {
    const Vec3 &from = path_.start_of(i).axis, &to = path_.moves[i].end.axis;
    const double turn_rad = angle_between_rad(from, to);
    const double length_mm = move_length_mm(path_, i);
    quality_.turn_rad.take(turn_rad, i);
    add_time(path_.moves[i], length_mm, turn_rad);
    if (length_mm > AxisQuality::kSpot_mm) {
      quality_.turn_rad_per_mm.take(turn_rad / length_mm, i);
      bending_.add((to - from) / length_mm, length_mm);
    } else if (turn_rad > AxisQuality::kSameAxis_rad) {
      ++quality_.turns_on_the_spot;
      quality_.turn_on_the_spot_rad.take(turn_rad, i);
      bending_.interrupt();
    }
  }

  void add_time(const Move& move, double length_mm, double turn_rad) {
    if (move.feed_unit != FeedUnit::per_minute || !(move.feed_mm > 0)) {
      ++quality_.moves_without_feed;
      return;
    }
    const double seconds = length_mm / move.feed_mm * kSecondsOfMinute;
    quality_.feed_seconds += seconds;
    if (max_rotary_rad_per_s_) *quality_.limited_feed_seconds += std::max(seconds, turn_rad / *max_rotary_rad_per_s_);
  }

  const Toolpath& path_;
  const std::optional<double>& max_rotary_rad_per_s_;
  AxisQuality quality_;
  BendingSum<3> bending_;
};

}  // namespace

void LargestOfMoves::take(double of_move, std::size_t index) {
  if (!(of_move > value)) return;
  value = of_move;
  move = index;
}

AxisQuality measure_axis_quality(const Toolpath& path, std::optional<double> max_rotary_rad_per_s) {
  return QualityPass(path, max_rotary_rad_per_s).run();
}

}  // namespace gouge
