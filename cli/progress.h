#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace gouge {

enum class ProgressMode { automatic, always, never };

/// What --progress says: auto, always or never.
[[nodiscard]] ProgressMode understand_progress(const std::string& word);

/// One line on standard error that is drawn over and over while long work runs, and wiped at its end.
/// Automatic: only where standard error is a terminal. Silent for work shorter than a moment.
class Progress {
 public:
  Progress(std::ostream& err, ProgressMode mode);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What is being done from now on: "checking moves".
  void begin(const std::string& what);
  /// With the time left, once there is something to tell it by.
  void show(std::size_t done, std::size_t total);
  void end();

 private:
  std::ostream& err_;
  bool is_on_ = false;
  bool is_drawn_ = false;
  std::string what_;
  std::chrono::steady_clock::time_point began_, drawn_;
};

}  // namespace gouge
