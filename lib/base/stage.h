#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"

namespace gouge {

/// One stage of long work that is not just one loop over chunks. It counts the work done and reports it at most a
/// thousand times. It costs nothing without a progress callback.
class Stage {
 public:
  /// Begins the stage with a report that nothing is done. `items` is the count that the reader sees; all items are done
  /// once `work` is done. The unit of `work` is free: if each item is processed six times, it is six times `items`.
  /// `progress` must outlive the stage.
  Stage(const ProgressCall& progress, std::string_view name, std::size_t items, std::size_t work);
  Stage(const ProgressCall& progress, std::string_view name, std::size_t items) : Stage(progress, name, items, items) {}

  /// Adds work that was done. It may be called from any thread.
  void add(std::size_t work) {
    if (progress_) count(work);
  }

  /// Adds `work` for each item before `i`, from time to time; for a loop over items.
  void pass(std::size_t i, std::size_t work = 1) {
    if (i % kStride == kStride - 1) add(work * kStride);
  }

 private:
  static constexpr std::size_t kStride = 4096;

  void count(std::size_t work);

  const ProgressCall& progress_;
  std::string name_;
  std::size_t items_, work_;
  std::atomic<std::size_t> done_{0};
  std::mutex guard_;
  std::size_t reported_ = 0;  // number of steps reported so far, of kReports
};

}  // namespace gouge
