#include "cli/batch/batch_run.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <system_error>
#include <thread>
#include <utility>

#include "cli/batch/running_mark.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "postproc/store/work_store.h"

namespace gouge {
namespace {

// Memory of a job without its files, and for each byte of an STL or a toolpath with its data structures
// (docs/develop/benchmarks.md).
constexpr std::uint64_t kBytesOfJob = 60'000'000, kPerMeshByte = 5, kPerPathByte = 25;
// Maximum memory of a long path during its check; the rest of the path is in files (docs/method/scaling.md).
constexpr std::uint64_t kMaxOfCheckedPath = 1'500'000'000;

std::uint64_t bytes_of(const std::string& file) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  return error ? 0 : bytes;
}

}  // namespace

std::uint64_t usable_memory() {
  const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGE_SIZE);
  constexpr std::uint64_t kIfUnknown = 4'000'000'000;
  if (pages <= 0 || size <= 0) return kIfUnknown;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size) / 4 * 3;
}

bool is_reason_to_stop(StopOn what, std::optional<int> status) {
  const int severity = severity_of(status);
  return (what != StopOn::nothing && severity <= severity_of(kExitInput)) ||
         (what == StopOn::gouge && severity <= severity_of(kExitGouges));
}

BatchRun::BatchRun(const std::vector<BatchJob>& jobs, const std::vector<std::string>& texts,
                   const BatchOptions& options, ResultStore& store, Progress& progress, Ranks& ranks)
    : jobs_(jobs),
      texts_(texts),
      options_(options),
      store_(store),
      progress_(progress),
      ranks_(ranks),
      scenes_(options.copies) {
  for (const BatchJob& job : jobs) {
    sizes_.push_back(size_of(job));
    is_last_.push_back(has_running_mark(options.folder, job.name));
  }
}

BatchRun::Size BatchRun::size_of(const BatchJob& job) {
  const JobArguments& arguments = job.job();
  Size size{bytes_of(arguments.path), kBytesOfJob};
  const std::uint64_t of_path = kPerPathByte * size.path_bytes;
  size.memory_bytes +=
      std::holds_alternative<CheckArguments>(job.arguments) ? std::min(of_path, kMaxOfCheckedPath) : of_path;
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
    if (is_last_[a] != is_last_[b]) return static_cast<bool>(is_last_[b]);
    if (group[a] != group[b]) {
      const std::uint64_t of_a = work[group[a]], of_b = work[group[b]];
      return of_a != of_b ? of_a > of_b : group[a] < group[b];
    }
    return sizes_[a].path_bytes > sizes_[b].path_bytes;
  });
  return numbers;
}

BatchPlan BatchRun::plan(const std::vector<std::size_t>& numbers) const {
  std::uint64_t work = 0;
  for (const std::size_t number : numbers) work += sizes_[number].path_bytes;
  const std::size_t at_once = std::min(options_.jobs_at_once * static_cast<std::size_t>(ranks_.count()),
                                       std::max<std::size_t>(numbers.size(), 1));
  std::vector<std::size_t> alone, together;
  for (const std::size_t number : in_order(numbers)) {
    const bool is_large = sizes_[number].path_bytes > work / at_once && !is_last_[number];
    (is_large || options_.jobs_at_once == 1 || numbers.size() == 1 ? alone : together).push_back(number);
  }
  return {queue_of(std::move(alone)), queue_of(std::move(together))};
}

std::vector<std::string> BatchRun::names_of_last(const BatchPlan& plan) const {
  std::vector<std::string> names;
  for (const JobQueue* queue : {&plan.alone, &plan.together}) {
    for (const std::size_t number : queue->numbers)
      if (is_last_[number]) names.push_back(jobs_[number].name);
  }
  return names;
}

JobQueue BatchRun::queue_of(std::vector<std::size_t> numbers) const {
  JobQueue queue;
  std::string group;
  for (std::size_t position = 0; position < numbers.size(); ++position) {
    std::string its = SceneStore::group_of(jobs_[numbers[position]].job());
    if (position > 0 && its != group) queue.group_ends.push_back(position);
    queue.work.push_back(std::max<std::uint64_t>(sizes_[numbers[position]].path_bytes, 1));
    group = std::move(its);
  }
  if (!numbers.empty()) queue.group_ends.push_back(numbers.size());
  queue.numbers = std::move(numbers);
  return queue;
}

Outcome BatchRun::run(const BatchPlan& plan) {
  all_ = plan.alone.numbers.size() + plan.together.numbers.size();
  began_ = std::chrono::steady_clock::now();
  is_expected_.assign(jobs_.size(), false);
  for (const JobQueue* queue : {&plan.alone, &plan.together}) {
    for (const std::size_t number : queue->numbers) {
      scenes_.expect(jobs_[number].job());
      is_expected_[number] = true;
    }
  }
  ranks_.deal(0, plan.alone.group_ends, plan.alone.work);
  ranks_.deal(1, plan.together.group_ends, plan.together.work);
  progress_.show("jobs", 0, all_);
  {
    const Writer writer(*this);
    while (const auto number = take(0, plan.alone, 1)) run_one(*number);
    const std::size_t workers = std::min(options_.jobs_at_once, plan.together.numbers.size());
    for_each_chunk(workers, 1, static_cast<unsigned>(workers), [&](std::size_t, std::size_t) {
      while (const auto number = take(1, plan.together, workers)) run_one(*number);
    });
  }
  progress_.end();
  write_queued();
  if (failure_) return *failure_;
  return Done{};
}

std::optional<std::size_t> BatchRun::take(int list, const JobQueue& queue, std::size_t workers) {
  const std::scoped_lock lock(taking_);
  const std::optional<std::size_t> position = ranks_.take(list, workers);
  Group& group = groups_.at(static_cast<std::size_t>(list));
  if (!position) {
    leave_group(list, queue);
    return std::nullopt;
  }
  if (*position < group.first || *position >= group.end) {
    leave_group(list, queue);
    const auto end = std::ranges::upper_bound(queue.group_ends, *position);
    group = {end == queue.group_ends.begin() ? 0 : *std::prev(end), *end};
  }
  const std::size_t number = queue.numbers[*position];
  if (!is_expected_[number]) scenes_.expect(jobs_[number].job());
  is_expected_[number] = false;
  return number;
}

// Releases the scene of a group whose remaining jobs other processes run. If a job of the group comes back, the scene
// is expected again.
void BatchRun::leave_group(int list, const JobQueue& queue) {
  Group& group = groups_.at(static_cast<std::size_t>(list));
  for (std::size_t position = group.first; position < group.end; ++position) {
    const std::size_t number = queue.numbers[position];
    if (is_expected_[number]) scenes_.release(jobs_[number].job());
    is_expected_[number] = false;
  }
  group = {};
}

void BatchRun::run_one(std::size_t number) {
  const JobArguments& arguments = jobs_[number].job();
  const Room room(*this, sizes_[number].memory_bytes);
  if (!is_stopped_) {
    const RunningMark mark(options_.folder, jobs_[number].name);
    JobRun run = run_job(jobs_[number], texts_[number], options_.folder, options_.chunk, scenes_);
    run.result.rank = ranks_.rank();
    note(number, std::move(run));
    if (!has_writer_) write_queued();
  }
  scenes_.release(arguments);
}

void BatchRun::note(std::size_t number, JobRun&& run) {
  const std::scoped_lock lock(guard_);
  if (is_reason_to_stop(options_.stop_on, run.result.status)) is_stopped_ = true;
  ++done_;
  moves_ += run.result.moves();
  queued_.emplace_back(number, std::move(run.result));
  if (!run.work_file.empty()) work_files_.push_back(std::move(run.work_file));
  news_.notify_one();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  const std::string rate =
      seconds > 1 ? fixed_text(static_cast<double>(moves_) / seconds, 0) + " moves/s, jobs" : "jobs";
  progress_.show(rate, done_, all_);
}

// Writes results in a thread of its own. A disk takes milliseconds to store a result safely. Other jobs run meanwhile,
// and their results are written together.
void BatchRun::write_until_closed() {
  std::unique_lock lock(guard_);
  while (!is_closed_) {
    news_.wait(lock, [&] { return is_closed_ || !queued_.empty(); });
    lock.unlock();
    write_queued();
    lock.lock();
  }
}

void BatchRun::write_queued() {
  const std::scoped_lock writing(writing_);
  std::vector<ResultStore::Numbered> results;
  std::vector<std::string> work_files;
  {
    const std::scoped_lock lock(guard_);
    if (failure_ || queued_.empty()) return;
    results.swap(queued_);
    work_files.swap(work_files_);
  }
  const Outcome put = store_.put(results);
  if (put) {
    for (const std::string& file : work_files) remove_work_store(file);
    return;
  }
  const std::scoped_lock lock(guard_);
  failure_ = put.error();
  is_stopped_ = true;
}

// Starts the thread that writes results. If the system starts no thread, each job writes its own result.
BatchRun::Writer::Writer(BatchRun& batch) : batch_(batch) {
  try {
    thread_ = std::thread([this] { batch_.write_until_closed(); });
    batch_.has_writer_ = true;
  } catch (const std::system_error&) {
  }
}

BatchRun::Writer::~Writer() {
  {
    const std::scoped_lock lock(batch_.guard_);
    batch_.is_closed_ = true;
  }
  batch_.news_.notify_one();
  if (thread_.joinable()) thread_.join();
}

// Waits for memory. A job that needs more than the total runs alone.
BatchRun::Room::Room(BatchRun& batch, std::uint64_t bytes) : batch_(batch), bytes_(bytes) {
  std::unique_lock lock(batch_.guard_);
  batch_.room_.wait(lock,
                    [&] { return batch_.running_ == 0 || batch_.in_use_ + bytes_ <= batch_.options_.memory_bytes; });
  ++batch_.running_;
  batch_.in_use_ += bytes_;
}

BatchRun::Room::~Room() {
  {
    const std::scoped_lock lock(batch_.guard_);
    --batch_.running_;
    batch_.in_use_ -= bytes_;
  }
  batch_.room_.notify_all();
}

}  // namespace gouge
