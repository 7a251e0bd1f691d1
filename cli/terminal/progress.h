#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "lib/base/parallel.h"

namespace gouge {

enum class ProgressMode { automatic, always, never };

/// Reads the word of --progress: auto, always or never.
[[nodiscard]] ProgressMode understand_progress(std::string_view word);

/// One line on standard error that is redrawn while long work runs, and wiped at its end. It shows the stage, the part
/// done and the approximate remaining time. If the work is not counted, it shows the time so far. In automatic mode it
/// is shown only if standard error is a terminal. Short work shows nothing.
class Progress {
 public:
  Progress(std::ostream& err, ProgressMode mode);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage that is not counted, such as "reading part.stl".
  void begin(std::string_view stage);
  void show(std::string_view stage, std::size_t done, std::size_t total);
  /// Wipes the line. Must be called before any other output.
  void end();

  /// Returns the callback for work in libraries; empty if nothing is shown.
  [[nodiscard]] ProgressCall call();

 private:
  using Clock = std::chrono::steady_clock;

  void enter(std::string_view stage);
  void draw(Clock::time_point now);
  void redraw_while_open(const std::stop_token& stop);

  std::ostream& err_;
  bool is_on_ = false;
  std::mutex guard_;  // guards all members that follow
  bool is_drawn_ = false;
  std::string stage_;  // empty: no stage runs
  std::size_t done_ = 0, total_ = 0;
  Clock::time_point began_, first_counted_, counted_, drawn_;
  std::condition_variable_any closed_;
  std::jthread ticker_;  // redraws the line between two reports
};

/// Returns "7 s", "3 min" or "2.5 h" for a remaining time. Seconds and minutes are rounded up.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace gouge
