#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postproc/batch/job_result.h"
#include "postproc/store/database.h"

namespace gouge {

/// The identity of a batch in its store.
struct BatchIdentity {
  std::string version;               ///< of the program
  std::string build;                 ///< SHA-256 of the program's executable
  std::string list;                  ///< SHA-256 of the job list after it was understood
  std::size_t jobs = 0;              ///< number of jobs in the list
  std::vector<std::size_t> numbers;  ///< numbers of the jobs that are run here, ascending
  std::vector<std::string> names;    ///< names of these jobs
  SignOff sign_off = {};             ///< the head of the page of the batch
};

/// A job with a result in the store.
struct StoredJob {
  std::string name, key;  ///< empty key: the result must not be used again
  int status = 0;
  std::vector<JobOutput> outputs;
  SearchLog searches;
};

/// The file results.sqlite of a batch (docs/formats/batch_store.md). It has the results of its jobs, each committed as
/// soon as it is complete.
class ResultStore {
 public:
  /// Opens the file, or makes an empty one. An existing one stays unchanged until begin. Errors: store-newer (from a
  /// later version of the program), store-foreign (a database that is not a store of a batch), and those of Database.
  [[nodiscard]] static Result<ResultStore> open(const std::string& path);

  /// Returns whether a batch was begun here but not ended; jobs_done() is the number of its completed jobs.
  [[nodiscard]] bool is_interrupted() const { return is_interrupted_; }
  [[nodiscard]] std::size_t jobs_done() const { return done_.size(); }

  /// Begins a run of these jobs. Results of jobs with other names are dropped. Those with the same name are kept under
  /// their new number.
  [[nodiscard]] Outcome begin(const BatchIdentity& batch);
  /// Returns the jobs that have a result.
  [[nodiscard]] const std::vector<StoredJob>& stored() const { return done_; }

  /// The number of a job in the list, and its result.
  using Numbered = std::pair<std::size_t, JobResult>;
  /// Replaces the stored results of these jobs by `results`, all in one transaction.
  [[nodiscard]] Outcome put(const std::vector<Numbered>& results);
  /// Reads from the file again which jobs have a result.
  [[nodiscard]] Outcome refresh();
  /// Returns one result for each job that is run here, in order. Jobs that have not run have only a name. Results whose
  /// rows were altered after they were stored are marked (is_altered).
  [[nodiscard]] Result<std::vector<JobResult>> all();
  /// Returns the batch that began last; its names are empty if there is none.
  [[nodiscard]] Result<BatchIdentity> identity();
  /// Marks the batch as complete: every job has run, and its files are written.
  [[nodiscard]] Outcome end();

 private:
  explicit ResultStore(Database database) : database_(std::move(database)) {}
  [[nodiscard]] Outcome prepare(const std::string& path);
  void make_tables();
  void read_done();
  void remove(std::int64_t job);
  void renumber(const BatchIdentity& batch);

  Database database_;
  bool has_tables_ = false;
  bool is_interrupted_ = false;
  std::vector<StoredJob> done_;
};

}  // namespace gouge
