#include "cli/progress.h"

#include <unistd.h>

#include <ostream>

namespace gouge {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kQuietStart{400};
constexpr milliseconds kRedraw{100};

}  // namespace

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
  err_ << "\r" << what_ << ": " << done << " of " << total << " (" << done * 100 / total << " %)\x1b[K" << std::flush;
}

void Progress::end() {
  if (is_drawn_) err_ << "\r\x1b[K" << std::flush;
  is_drawn_ = false;
}

}  // namespace gouge
