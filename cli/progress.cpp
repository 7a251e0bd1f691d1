#include "cli/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ostream>

namespace gouge {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kQuietStart{400};
constexpr milliseconds kRedraw{100};

/// As fast as until now.
std::string time_left(milliseconds spent, std::size_t done, std::size_t total) {
  if (done == 0) return "";
  const double share = static_cast<double>(total - std::min(done, total)) / static_cast<double>(done);
  const auto seconds = static_cast<std::uint64_t>(std::ceil(static_cast<double>(spent.count()) * share / 1000));
  return seconds < 100 ? ", " + std::to_string(seconds) + " s left"
                       : ", " + std::to_string((seconds + 59) / 60) + " min left";
}

}  // namespace

ProgressMode understand_progress(const std::string& word) {
  return word == "always" ? ProgressMode::always : word == "never" ? ProgressMode::never : ProgressMode::automatic;
}

Progress::Progress(std::ostream& err, ProgressMode mode)
    : err_(err),
      is_on_(mode == ProgressMode::always || (mode == ProgressMode::automatic && ::isatty(STDERR_FILENO) == 1)) {}

Progress::~Progress() { end(); }

void Progress::begin(const std::string& what) {
  end();
  what_ = what;
  began_ = drawn_ = std::chrono::steady_clock::now();
}

void Progress::show(std::size_t done, std::size_t total) {
  if (!is_on_ || total == 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - began_ < kQuietStart || (is_drawn_ && now - drawn_ < kRedraw)) return;
  drawn_ = now;
  is_drawn_ = true;
  err_ << "\r" << what_ << ": " << done << " of " << total << " (" << done * 100 / total << " %)"
       << time_left(std::chrono::duration_cast<milliseconds>(now - began_), done, total) << "\x1b[K" << std::flush;
}

void Progress::end() {
  if (is_drawn_) err_ << "\r\x1b[K" << std::flush;
  is_drawn_ = false;
}

}  // namespace gouge
