#include "lib/base/stage.h"

#include <algorithm>

namespace gouge {
namespace {

constexpr std::size_t kReports = 1000;

std::size_t share(std::size_t whole, std::size_t done, std::size_t of) {
  return static_cast<std::size_t>(static_cast<double>(whole) * static_cast<double>(done) / static_cast<double>(of));
}

}  // namespace

Stage::Stage(const ProgressCall& progress, std::string_view name, std::size_t items, std::size_t work)
    : progress_(progress), name_(name), items_(items), work_(std::max<std::size_t>(work, 1)) {
  if (progress_) progress_(name_, 0, items_);
}

void Stage::count(std::size_t work) {
  const std::size_t done = std::min(done_.fetch_add(work, std::memory_order_relaxed) + work, work_);
  const std::size_t step = share(kReports, done, work_);
  const std::scoped_lock lock(guard_);
  if (step <= reported_) return;  // another thread may have reported this step first
  reported_ = step;
  progress_(name_, share(items_, done, work_), items_);
}

}  // namespace gouge
