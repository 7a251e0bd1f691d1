#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

#include "lib/base/parallel.h"

namespace gouge {

/// One stage of long work that is not a loop over chunks alone. It counts what is done and reports it a thousand times
/// at the most. No cost without a progress callback.
class Stage {
 public:
  /// `items` is the count that the reader sees; all are done when `work` is done. The unit of `work` may be any: where
  /// each item is processed six times, it is six times `items`. Reports that nothing is done. The call must outlive it.
  Stage(const ProgressCall& progress, std::string_view name, std::size_t items, std::size_t work);
  Stage(const ProgressCall& progress, std::string_view name, std::size_t items) : Stage(progress, name, items, items) {}

  /// From any thread.
  void add(std::size_t work) {
    if (progress_) count(work);
  }

  /// For a loop over items: adds `work` for each of the items before `i` now and then.
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
  std::size_t reported_ = 0;  // of kReports
};

}  // namespace gouge
