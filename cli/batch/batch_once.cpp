#include "cli/batch/batch_once.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <set>
#include <thread>

#include "cli/batch/batch_identity.h"
#include "cli/batch/batch_notes.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/jobs_in_the_way.h"
#include "cli/batch/running_mark.h"
#include "cli/batch/settled_files.h"
#include "cli/batch/toolpath_files.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/end_note.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

bool is_job_list(const BatchArguments& arguments) {
  return arguments.files.size() == 1 && fs::path(arguments.files.front()).extension() == ".json";
}

StopOn stop_on(const BatchArguments& arguments) {
  if (arguments.stop_on.empty()) return StopOn::nothing;
  return arguments.stop_on == "gouge" ? StopOn::gouge : StopOn::error;
}

/// One run of the command, step by step. A step that fails prints the reason and returns the exit status.
class Batch {
 public:
  Batch(const BatchArguments& arguments, WatchRun of_watch, std::ostream& out, std::ostream& err)
      : arguments_(arguments),
        of_watch_(of_watch),
        out_(out),
        err_(err),
        place_{arguments.folder, !arguments.is_without_reports, arguments.has_certificates} {}

  BatchEnd end() {
    const int status = run();
    return {status, is_done_, is_busy_, std::move(results_)};
  }

 private:
  int run() {
    Result<std::unique_ptr<Ranks>> ranks = make_ranks();
    if (!ranks) return fail(err_, {ranks.error()});
    ranks_ = std::move(*ranks);
    // Every process reads the list, but only the first one writes the files that all share.
    int status = prepare().value_or(kExitClean);
    if (ranks_->is_first() && status == kExitClean && !arguments_.is_rehearsal) status = open().value_or(kExitClean);
    if (const int worst = ranks_->largest(status); worst != kExitClean) return worst;
    if (arguments_.is_rehearsal) return ranks_->is_first() ? list() : kExitClean;
    if (!ranks_->is_first()) status = open_own_store().value_or(kExitClean);
    if (const int worst = ranks_->largest(status); worst != kExitClean) return worst;
    MeshCopies copies(arguments_.scratch);
    const BatchOptions options{arguments_.folder,   jobs_at_once(),   memory_bytes(),
                               stop_on(arguments_), arguments_.chunk, &copies};
    Progress progress(err_, ranks_->is_first() ? understand_progress(arguments_.progress) : ProgressMode::never);
    BatchRun batch(jobs_, texts_, options, *store_, progress, *ranks_);
    BatchPlan plan = ranks_->is_first() ? batch.plan(jobs_to_run()) : BatchPlan();
    if (!arguments_.is_quiet) note_running(batch.names_of_last(plan), arguments_.folder, err_);
    for (JobQueue* queue : {&plan.alone, &plan.together}) {
      ranks_->share(queue->numbers);
      ranks_->share(queue->group_ends);
      ran_.insert(queue->numbers.begin(), queue->numbers.end());
    }
    const Outcome ran = run_jobs(batch, plan);
    tell(copies);
    if (!ran) status = fail(err_, {ran.error()}, kExitInternal);
    if (!ranks_->is_first()) store_.reset();
    is_stopped_ = ranks_->largest(batch.is_stopped() || is_stopped_ ? 1 : 0) != 0;
    if (const int worst = ranks_->largest(status); worst != kExitClean) return worst;
    if (ranks_->is_first()) status = finish();
    // mpirun ends all processes as soon as one ends with a status other than 0. So only the first one, which ends last,
    // returns the common status.
    const int worst = ranks_->largest(status);
    return ranks_->is_first() ? worst : kExitClean;
  }

  // Runs the jobs. The next run of a watched folder takes the finished jobs by itself.
  Outcome run_jobs(BatchRun& batch, const BatchPlan& plan) {
    std::optional<EndNote> note;
    const char* const same = of_watch_ == WatchRun::none ? "the same command with --resume" : "the same command";
    if (ranks_->is_first() && !arguments_.is_quiet)
      note.emplace(std::string(is_terminal(err_) ? "\n" : "") +
                   "gougecheck: note: the batch was interrupted; what is done is kept: " + same +
                   " goes on from there [batch-interrupted]\n");
    return batch.run(plan);
  }

  std::optional<int> prepare() {
    if (const auto wrong = find_contradiction(arguments_)) return refuse(*wrong);
    if (arguments_.is_resumed && arguments_.is_fresh)
      return refuse(make_error("usage", "--resume keeps results that --fresh makes again; expected one of both"));
    const Result<Shard> shard = understand_shard(arguments_.shard);
    if (!shard) return refuse(shard.error());
    shard_ = *shard;
    if (!std::isfinite(arguments_.memory_gb))
      return refuse(make_error("usage", "--memory: expected a number of GB above 0"));
    if (const auto status = read_jobs()) return status;
    identity_ = identify_batch(arguments_, jobs_, shard_, texts_);
    return std::nullopt;
  }

  // Reports the error. All processes find the same one, so only the first process prints it.
  int refuse(const Diagnostic& error) {
    if (ranks_->is_first()) return fail(err_, {error});
    return error.code == "usage" ? kExitUsage : kExitInput;
  }

  std::optional<int> read_jobs() {
    if (is_job_list(arguments_) && !arguments_.words.empty()) {
      const std::string option = arguments_.words.front().substr(0, arguments_.words.front().find('='));
      return refuse(make_error("usage", option + " is an option of a job; expected it in the job list, as \"" +
                                            option.substr(2) + "\" in \"defaults\" or in a job"));
    }
    Result<std::vector<BatchJob>> jobs = is_job_list(arguments_)
                                             ? read_job_list(arguments_.files.front(), place_)
                                             : list_jobs(arguments_.files, arguments_.words, place_);
    if (!jobs) return refuse(jobs.error());
    jobs_ = std::move(*jobs);
    if (!arguments_.is_quiet && ranks_->is_first()) note_left_baseline(jobs_, arguments_.files.front(), err_);
    for (BatchJob& job : jobs_) {
      if (arguments_.is_forced) job.job().is_forced = true;
    }
    if (const auto wrong =
            find_jobs_in_the_way(jobs_, place_, is_job_list(arguments_) ? arguments_.files.front() : std::string()))
      return refuse(*wrong);
    return std::nullopt;
  }

  int list() const {
    std::vector<const BatchJob*> own;
    for (std::size_t number = 0; number < jobs_.size(); ++number) {
      if (shard_.has(number)) own.push_back(&jobs_[number]);
    }
    return list_jobs_and_missing(own, out_, err_) ? kExitInput : kExitClean;
  }

  std::optional<int> open() {
    if (const Outcome made = make_folder(arguments_.folder); !made) return fail(err_, {made.error()}, kExitInternal);
    folder_.emplace(arguments_.folder, arguments_.is_forced, names_of_batch());
    if (of_watch_ != WatchRun::none) folder_->set_locked();
    if (const Outcome opened = folder_->open(); !opened) return fail_to_open(opened.error());
    Result<ResultStore> store = ResultStore::open(arguments_.folder + "/" + kStoreName);
    if (!store) return fail_to_open(store.error());
    store_.emplace(std::move(*store));
    if (store_->is_interrupted() && !arguments_.is_resumed && !arguments_.is_fresh) {
      return fail(err_,
                  {make_error("usage",
                              "a batch in this folder was interrupted, with " + count_text(store_->jobs_done(), "job") +
                                  " done; expected --resume, which goes on from there, or --fresh, which begins "
                                  "anew",
                              arguments_.folder)});
    }
    if (const auto wrong = find_other_shard()) return fail_to_open(*wrong);
    if (const auto wrong = find_foreign()) return fail(err_, {*wrong}, kExitUsage);
    // The jobs of a watched folder come and go.
    if (of_watch_ != WatchRun::later && !arguments_.is_fresh && !arguments_.is_quiet)
      note_replaced(*store_, identity_, arguments_.folder, err_);
    if (const Outcome begun = store_->begin(identity_); !begun) return fail_to_open(begun.error());
    if (arguments_.is_fresh) {
      remove_running_marks(arguments_.folder);
      remove_work(arguments_.folder);
    }
    if (const Outcome taken = take_in_ranks(); !taken) return fail(err_, {taken.error()}, kExitInternal);
    return std::nullopt;
  }

  int fail_to_open(const Diagnostic& error) {
    is_busy_ = error.code == "store-busy" || error.code == "report-busy";
    const bool is_usage = error.code == "report-foreign" || error.code == "usage";
    return fail(err_, {error}, is_usage ? kExitUsage : kExitInternal);
  }

  // Finds whether the store has the results of another shard, which this run would drop.
  std::optional<Diagnostic> find_other_shard() {
    const Result<BatchIdentity> its = store_->identity();
    if (!its) return its.error();
    if (its->list != identity_.list || its->numbers == identity_.numbers || arguments_.is_fresh) return std::nullopt;
    return make_error(
        "usage",
        "the folder has another share of these jobs; expected a folder for each --shard, or --fresh, which "
        "drops what is there",
        arguments_.folder);
  }

  // Finds a corrected toolpath or certificate that a job would replace, but that no batch wrote. For a report, the command of the job
  // tests this.
  [[nodiscard]] std::optional<Diagnostic> find_foreign() const {
    if (arguments_.is_forced) return std::nullopt;
    std::vector<std::string> files;
    for (const std::size_t number : identity_.numbers) {
      const std::vector<std::string> own = place_.own_outputs(jobs_[number]);
      files.insert(files.end(), own.begin(), own.end());
    }
    return find_foreign_output(files, arguments_.folder, *store_);
  }

  [[nodiscard]] std::map<std::string, const StoredJob*> stored_jobs() const {
    std::map<std::string, const StoredJob*> stored;
    for (const StoredJob& job : store_->stored()) stored[job.name] = &job;
    return stored;
  }

  // Opens the store of a process other than the first. The first one collects the results at the end.
  std::optional<int> open_own_store() {
    Result<ResultStore> store = ResultStore::open(store_of_rank(ranks_->rank()));
    if (!store) return fail(err_, {store.error()}, kExitInternal);
    store_.emplace(std::move(*store));
    if (const Outcome begun = store_->begin(identity_); !begun) return fail(err_, {begun.error()}, kExitInternal);
    return std::nullopt;
  }

  [[nodiscard]] std::string store_of_rank(int rank) const {
    return arguments_.folder + "/results-rank-" + std::to_string(rank) + ".sqlite";
  }

  // Moves the results of other processes, of this run or of an interrupted one, into the store, and removes their
  // stores.
  Outcome take_in_ranks() {
    constexpr int kMaxRanks = 100'000;
    std::error_code ignored;
    for (int rank = 1; rank < kMaxRanks && (rank < ranks_->count() || fs::exists(store_of_rank(rank), ignored));
         ++rank) {
      const std::string file = store_of_rank(rank);
      if (!fs::exists(file, ignored)) continue;
      if (Outcome taken = take_in(file); !taken) return taken;
      fs::remove(file, ignored);
    }
    return Done{};
  }

  Outcome take_in(const std::string& file) {
    Result<ResultStore> store = ResultStore::open(file);
    if (!store) return store.error();
    const Result<BatchIdentity> its = store->identity();
    if (!its) return its.error();
    if (its->list != identity_.list) return Done{};
    Result<std::vector<JobResult>> results = store->all();
    if (!results) return results.error();
    std::vector<ResultStore::Numbered> done;
    for (std::size_t k = 0; k < results->size(); ++k) {
      if ((*results)[k].status) done.emplace_back(its->numbers[k], std::move((*results)[k]));
    }
    if (Outcome put = store_->put(done); !put) return put;
    return store_->refresh();
  }

  std::vector<std::size_t> jobs_to_run() {
    const std::map<std::string, const StoredJob*> stored = stored_jobs();
    FileHashes hashes;
    std::vector<std::size_t> numbers;
    for (const std::size_t number : identity_.numbers) {
      const auto known = stored.find(jobs_[number].name);
      const bool is_done =
          !arguments_.is_fresh && known != stored.end() && !known->second->key.empty() &&
          known->second->status != kExitInternal &&
          known->second->key == job_key(jobs_[number], texts_[number], known->second->searches, hashes) &&
          are_as_written(known->second->outputs, arguments_.folder);
      if (is_done) {
        ++taken_;
        is_stopped_ = is_stopped_ || is_reason_to_stop(stop_on(arguments_), known->second->status);
        continue;
      }
      numbers.push_back(number);
      if (known != stored.end()) remove_own_outputs(*known->second);
    }
    if (is_stopped_) numbers.clear();
    return numbers;
  }

  // Removes the corrected path and the certificate that a job wrote in an earlier run. Otherwise they would stay if the job
  // fails now.
  void remove_own_outputs(const StoredJob& job) const {
    std::error_code ignored;
    for (const JobOutput& output : job.outputs) {
      const bool is_own = output.file.starts_with(std::string(kCorrectedFolder) + "/") ||
                          output.file.starts_with(std::string(kCertificatesFolder) + "/");
      if (is_own && is_below(output.file) && are_as_written({output}, arguments_.folder))
        fs::remove(arguments_.folder + "/" + output.file, ignored);
    }
  }

  void tell(const MeshCopies& copies) const {
    Diagnostics notes;
    if (const auto trouble = copies.trouble()) notes.push_back(*trouble);
    if (copies.files() > 0)
      notes.push_back(make_note("scratch-copied",
                                "holds " + count_text(copies.files(), "mesh", "meshes") + " more, of " +
                                    byte_size_text(copies.bytes()) + ", until the last process here ends",
                                arguments_.scratch));
    print_notes(err_, notes, arguments_);
  }

  [[nodiscard]] std::size_t jobs_at_once() const {
    if (arguments_.jobs > 0) return std::min<std::size_t>(arguments_.jobs, kMaxThreads);
    const std::uint32_t threads = arguments_.check.job.threads;
    return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
  }

  [[nodiscard]] std::uint64_t memory_bytes() const {
    return arguments_.memory_gb > 0 ? static_cast<std::uint64_t>(arguments_.memory_gb * 1e9) : usable_memory();
  }

  int finish() {
    if (const Outcome taken = take_in_ranks(); !taken) return fail(err_, {taken.error()}, kExitInternal);
    Result<std::vector<JobResult>> read = store_->all();
    if (!read) return fail(err_, {read.error()}, kExitInternal);
    results_ = std::move(*read);
    const std::vector<JobResult>& results = results_;
    const bool is_whole = std::ranges::all_of(results, [](const JobResult& job) { return job.status.has_value(); });
    warn_of_two_contents(results);
    Outcome written = write_batch_files(*folder_, results, identity_.sign_off);
    if (written && is_whole) written = store_->end();
    const bool is_any_to_run_again =
        std::ranges::any_of(results, [](const JobResult& job) { return job.status == kExitInternal; });
    if (written && is_whole) {
      remove_running_marks(arguments_.folder);
      if (!is_any_to_run_again) remove_work(arguments_.folder);
    }
    if (!written) return fail(err_, {written.error()}, kExitInternal);
    is_done_ = true;
    const std::vector<JobResult>& shown = of_watch_ == WatchRun::none ? results : results_of(ran_, results);
    if (arguments_.is_quiet) print_failures(err_, shown);
    if (!arguments_.is_quiet) print_results(shown, is_whole);
    return batch_status(results);
  }

  // Prints nothing for a run of a watch without a job, after a file was removed.
  void print_results(const std::vector<JobResult>& shown, bool is_whole) const {
    if (of_watch_ == WatchRun::later && shown.empty()) return;
    if (!shown.empty() || taken_ == 0) print_batch(out_, shown);
    print_job_notes(out_, err_, shown, arguments_.is_verbose);
    if (taken_ > 0) out_ << count_text(taken_, "job") << " taken from the store, " << ran_.size() << " run\n";
    if (is_stopped_ && !is_whole)
      out_ << "stopped by --stop-on " << arguments_.stop_on
           << "; the same command without it, and with --resume, runs the rest\n";
    out_ << "report: " << printable(arguments_.folder) << "/index.html\n";
  }

  // Warns of a file that changed while the batch ran. Each verdict holds for the content that its job read.
  void warn_of_two_contents(const std::vector<JobResult>& results) const {
    const std::optional<TwoContents> two = find_two_contents(results);
    if (!two) return;
    const std::string found = two->is_search ? "was put there or removed" : "changed";
    print(err_, {make_warning("jobs-input-changed",
                              found + " while the batch ran, so jobs were checked against different contents of it; "
                                      "run the batch again, which runs those that are of the old one",
                              two->name)});
  }

  // Returns the results of the jobs with these numbers, in the order of `all`.
  [[nodiscard]] std::vector<JobResult> results_of(const std::set<std::size_t>& numbers,
                                                  const std::vector<JobResult>& all) const {
    std::vector<JobResult> some;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (numbers.contains(identity_.numbers[k])) some.push_back(all[k]);
    }
    return some;
  }

  const BatchArguments& arguments_;
  WatchRun of_watch_;
  std::ostream& out_;
  std::ostream& err_;
  BatchFolder place_;
  std::unique_ptr<Ranks> ranks_;
  std::vector<JobResult> results_;
  Shard shard_;
  std::vector<BatchJob> jobs_;
  std::vector<std::string> texts_;
  BatchIdentity identity_;
  std::optional<ReportFolder> folder_;
  std::optional<ResultStore> store_;
  std::size_t taken_ = 0;
  std::set<std::size_t> ran_;
  bool is_done_ = false, is_stopped_ = false, is_busy_ = false;
};

}  // namespace

BatchEnd run_batch_once(const BatchArguments& arguments, WatchRun of_watch, std::ostream& out, std::ostream& err) {
  return Batch(arguments, of_watch, out, err).end();
}

}  // namespace gouge
