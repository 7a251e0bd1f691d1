#include "cli/batch/watch_command.h"

#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/batch/batch_once.h"
#include "cli/batch/batch_watch.h"
#include "cli/batch/ranks.h"
#include "cli/batch/toolpath_files.h"
#include "cli/output/overwriting.h"
#include "cli/output/report_lock.h"
#include "cli/terminal/end_note.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

// Returns why these options cannot go with --watch.
std::optional<Diagnostic> find_unfit_option(const BatchArguments& arguments) {
  if (!arguments.stop_on.empty())
    return make_error("usage", "--stop-on ends a batch, but --watch goes on until ctrl-C; expected one of both");
  if (arguments.is_fresh)
    return make_error("usage",
                      "--fresh runs every job again, but --watch checks only what is new or changed; expected one of "
                      "both, such as gougecheck batch FOLDER --fresh before the watch");
  if (processes_of_mpirun() > 1)
    return make_error("usage", "--watch is the work of one process; expected it without mpirun");
  return std::nullopt;
}

/// A hot folder, whose toolpaths are checked as they come.
class HotFolder {
 public:
  HotFolder(const BatchArguments& arguments, std::ostream& out, std::ostream& err)
      : arguments_(arguments), out_(out), err_(err) {}

  int run() {
    if (const auto unfit = find_unfit_option(arguments_)) return fail(err_, {*unfit});
    if (const auto wrong = find_wrong_place(arguments_.watch)) return fail(err_, {*wrong});
    if (!arguments_.is_rehearsal) {
      if (const Outcome locked = lock(); !locked) return fail(err_, {locked.error()}, kExitInternal);
    }
    watch_toolpaths(
        {arguments_.watch, arguments_.folder, are_of_programs(arguments_.words), [this] { return inputs(); }},
        [this](const std::vector<std::string>& files) { return check(files); },
        [this](const Diagnostic& warning) {
          if (!arguments_.is_quiet) print(err_, {warning});
        });
    return status_;
  }

 private:
  // Locks the folder of the results as long as the watch lives: a second watch or batch would drop its results.
  Outcome lock() {
    if (Outcome made = make_folder(arguments_.folder); !made) return made;
    Result<ReportLock> lock = ReportLock::take(arguments_.folder, true);
    if (!lock) return lock.error();
    lock_.emplace(std::move(*lock));
    return Done{};
  }

  /// Returns the files other than toolpaths that the jobs read. Files that they look for count as soon as they exist.
  [[nodiscard]] std::vector<std::string> inputs() const {
    std::vector<std::string> files;
    for (const InputOption& input : inputs_of(arguments_.check.job)) {
      if (!input.file.empty()) files.push_back(input.file);
    }
    for (const FileSearch& search : searches_) {
      const std::vector<std::string> found = repeat_search(search);
      files.insert(files.end(), found.begin(), found.end());
    }
    return files;
  }

  // Checks the new and changed toolpaths: each run takes the results of the others from the store.
  AfterRun check(const std::vector<std::string>& files) {
    note_.reset();
    BatchArguments now = arguments_;
    now.files = files;
    now.is_resumed = true;
    const BatchEnd end = run_batch_once(now, is_first_ ? WatchRun::first : WatchRun::later, out_, err_);
    status_ = end.status;
    out_.flush();
    // A query that has the store open for a moment must not end the watch.
    if (end.is_busy) return AfterRun::again;
    is_first_ = false;
    take_searches(end.results);
    if (!end.is_done || !out_.good()) return AfterRun::end;
    if (!arguments_.is_quiet) tell_at_end(end.results);
    return AfterRun::go_on;
  }

  void take_searches(const std::vector<JobResult>& results) {
    searches_.clear();
    for (const JobResult& job : results) {
      for (const DoneSearch& done : job.searches) searches_.insert(done.search);
    }
  }

  // Prepares the line that ctrl-C prints.
  void tell_at_end(const std::vector<JobResult>& results) {
    note_.emplace(std::string(is_terminal(err_) ? "\n" : "") + "gougecheck: note: the watch ended with " +
                  count_text(results.size(), "job") + ": " + verdict_counts(results) + "; see " +
                  printable(arguments_.folder) + "/index.html [watch-ended]\n");
  }

  const BatchArguments& arguments_;
  std::ostream& out_;
  std::ostream& err_;
  std::optional<ReportLock> lock_;
  std::optional<EndNote> note_;
  std::set<FileSearch> searches_;  // those of the jobs in the last run
  bool is_first_ = true;
  int status_ = kExitClean;
};

}  // namespace

int run_watch(const BatchArguments& arguments, std::ostream& out, std::ostream& err) {
  return HotFolder(arguments, out, err).run();
}

}  // namespace gouge
