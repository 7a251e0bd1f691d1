#pragma once

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "cli/batch/batch_job.h"
#include "cli/batch/batch_list.h"
#include "cli/batch/ranks.h"
#include "cli/terminal/progress.h"
#include "postproc/store/result_store.h"

namespace gouge {

enum class StopOn { nothing, error, gouge };

/// Returns whether a job that ended with this status stops the batch: no other job begins.
[[nodiscard]] bool is_reason_to_stop(StopOn what, std::optional<int> status);

struct BatchOptions {
  std::string folder;
  std::size_t jobs_at_once = 1;
  std::uint64_t memory_bytes = 0;  ///< estimated memory that all running jobs together may need
  StopOn stop_on = StopOn::nothing;
  std::size_t chunk = 0;         ///< number of moves after which a long job stores its state
  MeshCopies* copies = nullptr;  ///< source of meshes; null: they are read from their own places
};

/// Jobs in the order in which they begin. Jobs of one scene are neighbours and form a group.
struct JobQueue {
  std::vector<std::size_t> numbers;
  std::vector<std::size_t> group_ends;  ///< one past the last position of each group
  std::vector<std::uint64_t> work;      ///< of each job, in bytes of its path
};

struct BatchPlan {
  JobQueue alone;     ///< run one after the other, each with all threads of its process
  JobQueue together;  ///< run side by side, each with one thread
};

/// Returns the bytes of memory that the jobs of a batch may take without --memory: three quarters of the machine's.
[[nodiscard]] std::uint64_t usable_memory();

/// Runs jobs side by side and commits each result to the store as soon as it is complete, while others run. Jobs of one
/// scene run next to each other, large jobs first. A job that is larger than a fair share of all work runs alone, with
/// all threads. Jobs that ran when an earlier process ended run last.
class BatchRun {
 public:
  /// All arguments must outlive the object. `texts` has the job_text of each job.
  BatchRun(const std::vector<BatchJob>& jobs, const std::vector<std::string>& texts, const BatchOptions& options,
           ResultStore& store, Progress& progress, Ranks& ranks);

  /// Returns the order and the grouping in which the jobs with these numbers run.
  [[nodiscard]] BatchPlan plan(const std::vector<std::size_t>& numbers) const;
  /// Returns the names of the jobs in a plan that ran when an earlier process ended.
  [[nodiscard]] std::vector<std::string> names_of_last(const BatchPlan& plan) const;
  /// Runs the jobs of the plan that this process receives. Errors: those of the store. After an error, running jobs
  /// end, and no other job begins.
  [[nodiscard]] Outcome run(const BatchPlan& plan);
  /// Returns whether some jobs were not run because of --stop-on.
  [[nodiscard]] bool is_stopped() const { return is_stopped_; }

 private:
  struct Size {
    std::uint64_t path_bytes = 0, memory_bytes = 0;
  };
  /// Positions of the group of a queue in which this process works.
  struct Group {
    std::size_t first = 0, end = 0;
  };

  [[nodiscard]] static Size size_of(const BatchJob& job);
  [[nodiscard]] std::vector<std::size_t> in_order(std::vector<std::size_t> numbers) const;
  [[nodiscard]] JobQueue queue_of(std::vector<std::size_t> numbers) const;
  [[nodiscard]] std::optional<std::size_t> take(int list, const JobQueue& queue, std::size_t workers);
  void leave_group(int list, const JobQueue& queue);
  void run_one(std::size_t number);
  void note(std::size_t number, JobRun&& run);
  void write_queued();
  void write_until_closed();

  /// Writes queued results as long as it exists.
  class Writer {
   public:
    explicit Writer(BatchRun& batch);
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer();

   private:
    BatchRun& batch_;
    std::thread thread_;
  };

  /// Reserves the memory that a job needs while it runs. Its constructor waits until so much is free.
  class Room {
   public:
    Room(BatchRun& batch, std::uint64_t bytes);
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;
    ~Room();

   private:
    BatchRun& batch_;
    std::uint64_t bytes_;
  };

  const std::vector<BatchJob>& jobs_;
  const std::vector<std::string>& texts_;
  const BatchOptions& options_;
  ResultStore& store_;
  Progress& progress_;
  Ranks& ranks_;
  SceneStore scenes_;
  std::mutex taking_;
  std::array<Group, 2> groups_{};  // one for each queue of the plan
  std::vector<bool> is_expected_;  // for each job number, whether this process may still receive the job
  std::vector<Size> sizes_;
  std::vector<bool> is_last_;  // an earlier process ended while it ran the job, so the job may end this one too
  std::mutex writing_;         // guards the store
  std::mutex guard_;           // guards all members that follow
  std::condition_variable room_, news_;
  std::vector<ResultStore::Numbered> queued_;
  std::vector<std::string> work_files_;  // work files of the queued results
  bool is_closed_ = false;
  bool has_writer_ = false;  // set before any job begins
  std::uint64_t in_use_ = 0;
  std::size_t running_ = 0, done_ = 0, all_ = 0, moves_ = 0;
  std::chrono::steady_clock::time_point began_;
  std::optional<Diagnostic> failure_;
  std::atomic<bool> is_stopped_ = false;
};

}  // namespace gouge
