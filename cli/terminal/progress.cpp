#include "cli/terminal/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <system_error>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

using std::chrono::milliseconds;
constexpr milliseconds kQuietStart{400};
constexpr milliseconds kRedraw{100};
constexpr double kMinElapsed_s = 1;  // earlier, a remaining time would be a guess

}  // namespace

ProgressMode understand_progress(std::string_view word) {
  return word == "always" ? ProgressMode::always : word == "never" ? ProgressMode::never : ProgressMode::automatic;
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fixed_text(std::ceil(seconds), 0) + " s";
  if (seconds < 90 * 60) return fixed_text(std::ceil(seconds / 60), 0) + " min";
  return fixed_text(seconds / 3600, 1) + " h";
}

Progress::Progress(std::ostream& err, ProgressMode mode)
    : err_(err),
      is_on_(mode == ProgressMode::always || (mode == ProgressMode::automatic && ::isatty(STDERR_FILENO) == 1)) {
  if (!is_on_) return;
  try {
    ticker_ = std::jthread([this](const std::stop_token& stop) { redraw_while_open(stop); });
  } catch (const std::system_error&) {
    // If the system starts no thread, the line is drawn when the work reports.
  }
}

Progress::~Progress() { end(); }

void Progress::begin(std::string_view stage) {
  const std::scoped_lock lock(guard_);
  enter(stage);
}

void Progress::show(std::string_view stage, std::size_t done, std::size_t total) {
  if (!is_on_) return;
  const std::scoped_lock lock(guard_);
  if (stage != stage_) enter(stage);
  counted_ = Clock::now();
  if (total_ == 0) first_counted_ = counted_;
  done_ = done;
  total_ = total;
  draw(counted_);
}

void Progress::end() {
  const std::scoped_lock lock(guard_);
  if (is_drawn_) err_ << "\r\x1b[K" << std::flush;
  is_drawn_ = false;
  stage_.clear();
}

ProgressCall Progress::call() {
  if (!is_on_) return {};
  return [this](std::string_view stage, std::size_t done, std::size_t total) { show(stage, done, total); };
}

void Progress::enter(std::string_view stage) {
  stage_ = stage;
  done_ = total_ = 0;
  began_ = Clock::now();
}

void Progress::draw(Clock::time_point now) {
  if (stage_.empty() || now - began_ < kQuietStart || (is_drawn_ && now - drawn_ < kRedraw)) return;
  drawn_ = now;
  is_drawn_ = true;
  const auto seconds = [](Clock::duration lasting) { return std::chrono::duration<double>(lasting).count(); };
  err_ << '\r' << printable(stage_) << ": ";
  if (total_ == 0) {
    err_ << duration_text(seconds(now - began_));
  } else {
    const double elapsed_s = seconds(now - first_counted_);
    err_ << done_ << " of " << total_ << " (" << done_ * 100 / total_ << " %)";
    if (done_ > 0 && done_ < total_ && elapsed_s > kMinElapsed_s) {
      // Assumes that the rest is as fast as the part that was done at the last count.
      const double all_s =
          seconds(counted_ - first_counted_) * static_cast<double>(total_) / static_cast<double>(done_);
      err_ << ", about " << duration_text(std::max(1.0, all_s - elapsed_s)) << " left";
    }
  }
  err_ << "\x1b[K" << std::flush;
}

void Progress::redraw_while_open(const std::stop_token& stop) {
  std::unique_lock lock(guard_);
  while (!closed_.wait_for(lock, stop, kRedraw, [] { return false; }) && !stop.stop_requested()) draw(Clock::now());
}

}  // namespace gouge
