#include "cli/batch_run.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/parallel.h"

namespace gouge {
namespace {

// Of a job without files; of a byte of an STL or a toolpath with all that is made of it (docs/benchmarks.md).
constexpr std::uint64_t kBytesOfJob = 60'000'000, kPerMeshByte = 5, kPerPathByte = 25;

std::uint64_t bytes_of(const std::string& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  return error ? 0 : bytes;
}

}  // namespace

BatchRun::BatchRun(const std::vector<BatchJob>& jobs, const std::vector<std::string>& texts,
                   const BatchOptions& options, ResultStore& store, Progress& progress)
    : jobs_(jobs), texts_(texts), options_(options), store_(store), progress_(progress) {
  for (const BatchJob& job : jobs) sizes_.push_back(size_of(job.job()));
}

BatchRun::Size BatchRun::size_of(const JobArguments& arguments) {
  Size size{bytes_of(arguments.path), kBytesOfJob};
  size.memory_bytes += kPerPathByte * size.path_bytes;
  for (const auto* files : {&arguments.parts, &arguments.fixtures, &arguments.heads}) {
    for (const std::string& file : *files) size.memory_bytes += kPerMeshByte * bytes_of(file);
  }
  return size;
}

std::vector<std::size_t> BatchRun::in_order(std::vector<std::size_t> numbers) const {
  std::map<std::string, std::uint64_t> work;
  std::vector<std::string> group(jobs_.size());
  for (const std::size_t number : numbers) {
    group[number] = SceneStore::group_of(jobs_[number].job());
    work[group[number]] += sizes_[number].path_bytes;
  }
  std::stable_sort(numbers.begin(), numbers.end(), [&](std::size_t a, std::size_t b) {
    if (group[a] != group[b]) {
      const std::uint64_t of_a = work[group[a]], of_b = work[group[b]];
      return of_a != of_b ? of_a > of_b : group[a] < group[b];
    }
    return sizes_[a].path_bytes > sizes_[b].path_bytes;
  });
  return numbers;
}

Outcome BatchRun::run(const std::vector<std::size_t>& numbers) {
  all_ = numbers.size();
  began_ = std::chrono::steady_clock::now();
  std::uint64_t work = 0;
  for (const std::size_t number : numbers) {
    work += sizes_[number].path_bytes;
    scenes_.expect(jobs_[number].job());
  }
  std::vector<std::size_t> alone, together;
  const std::size_t at_once = std::min(options_.jobs_at_once, std::max<std::size_t>(numbers.size(), 1));
  for (const std::size_t number : in_order(numbers)) {
    const bool is_large = sizes_[number].path_bytes > work / at_once;
    (is_large || options_.jobs_at_once == 1 || numbers.size() == 1 ? alone : together).push_back(number);
  }
  progress_.show("jobs", 0, all_);
  for (const std::size_t number : alone) run_one(number);
  for_each_chunk(together.size(), 1, static_cast<unsigned>(at_once),
                 [&](std::size_t first, std::size_t) { run_one(together[first]); });
  progress_.end();
  if (failure_) return *failure_;
  return Done{};
}

void BatchRun::run_one(std::size_t number) {
  if (is_stopped_) return;
  enter(sizes_[number].memory_bytes);
  if (!is_stopped_) {
    const JobResult result = run_job(jobs_[number], texts_[number], options_.folder, scenes_);
    commit(number, result);
  }
  scenes_.release(jobs_[number].job());
  leave(sizes_[number].memory_bytes);
}

void BatchRun::commit(std::size_t number, const JobResult& result) {
  const std::scoped_lock lock(guard_);
  if (failure_) return;
  if (const Outcome put = store_.put(number, result); !put) {
    failure_ = put.error();
    is_stopped_ = true;
    return;
  }
  const int severity = severity_of(result.status);
  if ((options_.stop_on != StopOn::nothing && severity <= severity_of(kExitInput)) ||
      (options_.stop_on == StopOn::gouge && severity <= severity_of(kExitGouges)))
    is_stopped_ = true;
  ++done_;
  moves_ += result.moves();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const std::string rate =
      seconds > 1 ? fixed_text(static_cast<double>(moves_) / seconds, 0) + " moves/s, jobs" : "jobs";
  progress_.show(rate, done_, all_);
}

// A job that needs more than there is runs alone.
void BatchRun::enter(std::uint64_t bytes) {
  std::unique_lock lock(guard_);
  room_.wait(lock, [&] { return running_ == 0 || in_use_ + bytes <= options_.memory_bytes; });
  ++running_;
  in_use_ += bytes;
}

void BatchRun::leave(std::uint64_t bytes) {
  {
    const std::scoped_lock lock(guard_);
    --running_;
    in_use_ -= bytes;
  }
  room_.notify_all();
}

}  // namespace gouge
