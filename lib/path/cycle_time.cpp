#include "lib/path/cycle_time.h"

#include <algorithm>

#include "lib/path/path_info.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr double kSecondsPerMinute = 60;

CycleTime time_of(const Toolpath& path, std::size_t index) {
  const Move& move = path.moves[index];
  CycleTime time;
  if (!move.has_start || index == 0) {
    time.moves_without_start = 1;
    return time;
  }
  const double length_mm = move_length_mm(path, index);
  if (runs_rapid(move)) {
    time.rapids = 1;
    time.rapid_mm = length_mm;
  } else if (move.feed_unit == FeedUnit::per_minute && move.feed_mm > 0 && !move.runs_joints) {
    time.feed_mm = length_mm;
    time.feed_seconds = length_mm / move.feed_mm * kSecondsPerMinute;
  } else {
    time.open_mm = length_mm;
    (move.feed_unit == FeedUnit::per_revolution ? time.moves_per_turn : time.moves_without_feed) = 1;
  }
  return time;
}

}  // namespace

void CycleTime::add(const CycleTime& other) {
  feed_seconds += other.feed_seconds;
  feed_mm += other.feed_mm;
  rapid_mm += other.rapid_mm;
  open_mm += other.open_mm;
  rapids += other.rapids;
  moves_per_turn += other.moves_per_turn;
  moves_without_feed += other.moves_without_feed;
  moves_without_start += other.moves_without_start;
}

std::vector<CycleTime> measure_cycle_times(const Toolpath& path) {
  std::vector<CycleTime> times(path.operations.size() + 1);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const std::size_t operation = path.moves[i].operation;
    times[std::min(operation, path.operations.size())].add(time_of(path, i));
  }
  return times;
}

}  // namespace gouge
