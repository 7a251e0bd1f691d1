#include "cli/batch/merge_command.h"

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <utility>

#include "cli/batch/batch_job.h"
#include "cli/batch/settled_files.h"
#include "cli/output/overwriting.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

Diagnostic unfit(const std::string& folder, const std::string& message) {
  return make_error("merge-unfit", message, folder);
}

/// The content of a shard's folder.
struct Share {
  std::string folder;
  BatchIdentity identity;
  std::vector<JobResult> results;
};

Result<Share> read_share(const std::string& folder) {
  const std::string file = folder + "/" + kStoreName;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
    return unfit(folder, "holds no " + std::string(kStoreName) + "; expected the folder of a batch");
  Result<ResultStore> store = ResultStore::open(file);
  if (!store) return store.error();
  if (store->is_interrupted())
    return unfit(folder, "its batch was interrupted; expected one that ended: run it again with --resume");
  Result<BatchIdentity> identity = store->identity();
  if (!identity) return identity.error();
  Result<std::vector<JobResult>> results = store->all();
  if (!results) return results.error();
  for (const JobResult& job : *results) {
    if (job.is_altered)
      return unfit(folder, "its result of job " + printable(job.name) +
                               " is not what was stored: its store was changed, or damaged; run that shard again, "
                               "which runs this job anew");
  }
  return Share{folder, std::move(*identity), std::move(*results)};
}

// Makes a second name (hard link) of the file if possible, else a copy, which is put in place when it is complete.
Outcome put_copy(const std::string& from, const std::string& to) {
  if (Outcome made = make_folder(fs::path(to).parent_path().string()); !made) return made;
  std::error_code error;
  if (fs::exists(to, error)) {
    fs::remove(to, error);
    if (error) return make_error("file-unwritable", "cannot be replaced: " + error.message(), to);
  }
  fs::create_hard_link(from, to, error);
  if (!error) return Done{};
  const Result<std::string> bytes = read_file(from);
  return bytes ? write_file(to, *bytes) : bytes.error();
}

class Merge {
 public:
  Merge(const MergeArguments& arguments, std::ostream& out, std::ostream& err)
      : arguments_(arguments), out_(out), err_(err) {}

  int run() {
    if (const auto wrong = find_contradiction(arguments_)) return fail(err_, {*wrong});
    if (const auto wrong = read()) return fail(err_, {*wrong});
    if (const Outcome merged = write(); !merged) {
      const bool is_usage = merged.error().code == "report-foreign" || merged.error().code == "usage";
      return fail(err_, {merged.error()}, is_usage ? kExitUsage : kExitInternal);
    }
    if (arguments_.is_quiet) {
      print_failures(err_, results_);
    } else {
      print_batch(out_, results_);
      out_ << "report: " << printable(arguments_.folder) << "/index.html\n";
    }
    return batch_status(results_);
  }

 private:
  std::optional<Diagnostic> read() {
    for (const std::string& folder : arguments_.shards) {
      if (canonical_place(folder) == canonical_place(arguments_.folder))
        return unfit(folder, "is the folder of -o as well; name another one");
      Result<Share> share = read_share(folder);
      if (!share) return share.error();
      if (const auto wrong = add(std::move(*share))) return wrong;
    }
    if (from_.size() < whole_->jobs) {
      std::size_t missing = 0;
      while (from_.contains(missing)) ++missing;
      return unfit(arguments_.shards.front(), std::to_string(whole_->jobs - from_.size()) + " of " +
                                                  count_text(whole_->jobs, "job") +
                                                  " of the list are in none of the folders, the first is number " +
                                                  std::to_string(missing + 1) + "; expected those of all shards");
    }
    for (const auto& [number, place] : from_) {
      const auto& [share, index] = place;
      whole_->numbers.push_back(number);
      whole_->names.push_back(shares_[share].identity.names[index]);
      results_.push_back(shares_[share].results[index]);
    }
    if (const auto wrong = find_other_content()) return wrong;
    return find_changed_output();
  }

  std::optional<Diagnostic> add(Share&& share) {
    const BatchIdentity& its = share.identity;
    if (!whole_) whole_ = BatchIdentity{its.version, its.build, its.list, its.jobs, {}, {}, its.sign_off};
    if (its.list != whole_->list)
      return unfit(share.folder, "its job list is another one than that of " + arguments_.shards.front() +
                                     ", or of another version of the program; expected shards of one list");
    for (std::size_t k = 0; k < its.numbers.size(); ++k) {
      const auto [other, is_new] = from_.try_emplace(its.numbers[k], shares_.size(), k);
      if (!is_new)
        return unfit(share.folder, "has the job " + printable(its.names[k]) + ", as " +
                                       shares_[other->second.first].folder + "; expected each job once");
    }
    shares_.push_back(std::move(share));
    return std::nullopt;
  }

  // Finds a file of which the shards read different contents, or which only one of them found, as no single run does.
  // Then some verdicts hold for another part than others.
  [[nodiscard]] std::optional<Diagnostic> find_other_content() const {
    const std::optional<TwoContents> two = find_two_contents(results_);
    if (!two) return std::nullopt;
    const std::string& first = folder_of(two->first);
    const std::string expected = "; expected the same files for all shards: run the shard again whose file was ";
    const std::string its = "its " + two->role + " " + printable(two->name);
    if (two->is_search)
      return unfit(folder_of(two->second), its + " is another file than in " + first +
                                               ", or only one of them has such a file" + expected +
                                               "missing or the wrong one");
    return unfit(folder_of(two->second), its + " had another content than in " + first + expected + "the wrong one");
  }

  [[nodiscard]] const std::string& folder_of(std::size_t result) const {
    return shares_[from_.at(whole_->numbers[result]).first].folder;
  }

  [[nodiscard]] std::optional<Diagnostic> find_changed_output() const {
    for (const Share& share : shares_) {
      for (const JobResult& job : share.results) {
        for (const JobOutput& output : job.outputs) {
          if (output.file.starts_with('/') || (is_below(output.file) && are_as_written({output}, share.folder)))
            continue;
          return unfit(share.folder, "the file " + printable(output.file) + " of job " + printable(job.name) +
                                         " is gone or was changed; run that shard again");
        }
      }
    }
    return std::nullopt;
  }

  Outcome write() {
    if (Outcome made = make_folder(arguments_.folder); !made) return made;
    ReportFolder folder(arguments_.folder, arguments_.is_forced, names_of_batch());
    if (Outcome opened = folder.open(); !opened) return opened;
    Result<ResultStore> store = ResultStore::open(arguments_.folder + "/" + kStoreName);
    if (!store) return store.error();
    const Result<BatchIdentity> before = store->identity();
    if (!before) return before.error();
    if (!before->list.empty() && before->list != whole_->list && !arguments_.is_forced)
      return make_error("usage", "holds another batch; name another folder, or let --force replace it",
                        arguments_.folder);
    std::vector<std::string> files;
    for (const JobResult& job : results_) {
      for (const JobOutput& output : job.outputs) {
        if (!output.file.starts_with('/')) files.push_back(output.file);
      }
    }
    const auto foreign = find_foreign_output(files, arguments_.folder, *store);
    if (foreign && !arguments_.is_forced) return *foreign;
    if (Outcome begun = store->begin(*whole_); !begun) return begun;
    std::vector<ResultStore::Numbered> done;
    for (std::size_t k = 0; k < results_.size(); ++k) {
      if (!results_[k].status) continue;
      if (Outcome copied = copy_outputs(k); !copied) return copied;
      done.emplace_back(whole_->numbers[k], results_[k]);
    }
    if (Outcome put = store->put(done); !put) return put;
    if (Outcome written = write_batch_files(folder, results_, whole_->sign_off); !written) return written;
    return store->end();
  }

  Outcome copy_outputs(std::size_t k) {
    const std::string& from = folder_of(k);
    for (const JobOutput& output : results_[k].outputs) {
      if (output.file.starts_with('/')) continue;
      if (Outcome put = put_copy(from + "/" + output.file, arguments_.folder + "/" + output.file); !put) return put;
    }
    return Done{};
  }

  const MergeArguments& arguments_;
  std::ostream& out_;
  std::ostream& err_;
  std::vector<Share> shares_;
  // for each job number: its share and its index there
  std::map<std::size_t, std::pair<std::size_t, std::size_t>> from_;
  std::optional<BatchIdentity> whole_;
  std::vector<JobResult> results_;
};

}  // namespace

void add_merge_options(CLI::App& command, MergeArguments& a) {
  command.add_option("DIR", a.shards, "Folders written by 'gougecheck batch --shard', one for each share")
      ->type_name("FOLDER")
      ->required();
  command.add_option("-o,--output", a.folder, "Folder for the joined results")->type_name("FOLDER")->required();
  command.add_flag("--force", a.is_forced,
                   "Replace the results of another batch, and files that were not written by a batch");
  add_verbosity(command, a, "No effect in this command",
                "Print no results, only errors, those of jobs that failed included");
  command.footer(
      "Example:\n"
      "  gougecheck batch jobs.json --shard 1/2 -o s1\n"
      "  gougecheck batch jobs.json --shard 2/2 -o s2\n"
      "  gougecheck merge s1 s2 -o night\n\n"
      "The result equals that of a single run of the whole list. The exit status is that of the worst job.");
}

int run_merge(const MergeArguments& arguments, std::ostream& out, std::ostream& err) {
  return Merge(arguments, out, err).run();
}

}  // namespace gouge
