#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "postproc/batch/job_result.h"
#include "postproc/store/database.h"

namespace gouge {

/// A batch as its store describes it.
struct BatchIdentity {
  std::string version;               ///< of the program
  std::string build;                 ///< SHA-256 of its executable
  std::string list;                  ///< SHA-256 of the job list as it was understood
  std::size_t jobs = 0;              ///< of the list
  std::vector<std::size_t> numbers;  ///< of those that are run here, ascending
  std::vector<std::string> names;    ///< of these
};

/// Returns the result of a job in the store.
struct StoredJob {
  std::string name, key;  ///< no key: the result may not be used again
  int status = 0;
  std::vector<JobOutput> outputs;
};

/// results.sqlite of a batch (docs/formats/batch_store.md): the results of its jobs, each committed when it is there.
class ResultStore {
 public:
  /// Makes an empty file where there is none. An existing one stays as it is until begin. Errors: store-newer (of a
  /// later version of the program), store-foreign (a database that is not a store of a batch), those of Database.
  [[nodiscard]] static Result<ResultStore> open(const std::string& path);

  /// Returns whether a batch was begun here and not ended, and how many of its jobs are done.
  [[nodiscard]] bool is_interrupted() const { return is_interrupted_; }
  [[nodiscard]] std::size_t jobs_done() const { return done_.size(); }

  /// Begins a run of these jobs: results of jobs of other names are dropped, those of the same name are kept under
  /// their new number.
  [[nodiscard]] Outcome begin(const BatchIdentity& batch);
  /// Jobs with a result.
  [[nodiscard]] const std::vector<StoredJob>& stored() const { return done_; }

  /// The result of a job and its number in the list.
  using Numbered = std::pair<std::size_t, JobResult>;
  /// Puts `results` in place of what the store has of these jobs, all in one transaction.
  [[nodiscard]] Outcome put(const std::vector<Numbered>& results);
  /// Reads anew which jobs are done.
  [[nodiscard]] Outcome refresh();
  /// Returns one result for each job that is run here, in order. Those that have not run have a name alone. Those whose
  /// rows were altered since they were put are marked (is_altered).
  [[nodiscard]] Result<std::vector<JobResult>> all();
  /// Returns the batch that began last; empty names where there is none.
  [[nodiscard]] Result<BatchIdentity> identity();
  /// Marks the batch as whole: every job that was to run has run, and its files stand.
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
