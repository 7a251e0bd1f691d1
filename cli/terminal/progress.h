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

/// One line on standard error that is drawn over and over while long work runs, and wiped at its end. It shows the
/// stage, how much of it is done and about how long the rest of it takes. Where nothing counts it, the line shows for
/// how long it runs. Automatic: only where standard error is a terminal. Silent for work shorter than a moment.
class Progress {
 public:
  Progress(std::ostream& err, ProgressMode mode);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage, as in "reading part.stl", with nothing that counts it.
  void begin(std::string_view stage);
  void show(std::string_view stage, std::size_t done, std::size_t total);
  /// Wipes the line. To be called before anything else is printed.
  void end();

  /// Returns the callback for work in libraries; empty where nothing is to be shown.
  [[nodiscard]] ProgressCall call();

 private:
  using Clock = std::chrono::steady_clock;

  void enter(std::string_view stage);
  void draw(Clock::time_point now);
  void redraw_while_open(const std::stop_token& stop);

  std::ostream& err_;
  bool is_on_ = false;
  std::mutex guard_;  // of all that follows
  bool is_drawn_ = false;
  std::string stage_;  // empty: nothing is being done
  std::size_t done_ = 0, total_ = 0;
  Clock::time_point began_, first_counted_, counted_, drawn_;
  std::condition_variable_any closed_;
  std::jthread ticker_;  // draws while nothing reports
};

/// Returns "7 s", "3 min", "2.5 h": of a time left, never less than it seems.
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace gouge
