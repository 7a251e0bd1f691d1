#include "cli/commands/verify_batch.h"

#include <array>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <utility>
#include <vector>

#include "cli/commands/batch_results.h"
#include "cli/commands/verification_text.h"
#include "cli/commands/verify_result.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/progress.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/batch/job_result.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// Number of lines below the line of a job. `verify` of its report prints all of them.
constexpr std::size_t kMaxDetails = 9;

enum class JobOutcome : std::uint8_t { refuted, unreadable, without_result, uncovered, sampled, verified };

constexpr std::array kOutcomeWords = {"refuted",     "cannot be verified", "no result",
                                      "not covered", "not refuted",        "verified"};

/// Words for the number of such jobs.
constexpr std::array kCountWords = {"refuted",     "cannot be verified", "without a result",
                                    "not covered", "not refuted",        "verified"};

const char* word_for(JobOutcome outcome) { return kOutcomeWords.at(static_cast<std::size_t>(outcome)); }

int status_of(JobOutcome outcome) {
  if (outcome == JobOutcome::refuted) return kExitGouges;
  if (outcome == JobOutcome::unreadable) return kExitInput;
  return outcome == JobOutcome::sampled || outcome == JobOutcome::verified ? kExitClean : kExitNotChecked;
}

struct JobVerification {
  JobOutcome outcome = JobOutcome::without_result;
  std::vector<std::string> reasons = {};  ///< the first belongs to the line of the job
  std::string text = {};                  ///< of its verification, if it has one
  Diagnostics notes = {};
  std::size_t sampled_clean = 0;  ///< number of moves said to be clean without a proof
  bool has_certificate = false;
};

/// Returns why a job of the batch ended without a result; none if it has one.
std::optional<std::string> why_without_result(const ListedJob& job) {
  if (!job.status) return "the job has not run";
  const bool is_checked = *job.status == kExitClean || *job.status == kExitGouges || *job.status == kExitNotChecked;
  if (!is_checked || job.verdict == "failed") {
    const std::string why = "the job failed in the batch (status " + std::to_string(*job.status) + ")";
    return job.messages.empty() ? why : why + ": " + job.messages.front();
  }
  if (job.result_file.empty()) return "the batch wrote no report of it";
  return std::nullopt;
}

JobVerification unreadable(const Diagnostics& errors) {
  JobVerification job{.outcome = JobOutcome::unreadable};
  for (const Diagnostic& error : errors) job.reasons.push_back(to_text(error));
  return job;
}

/// Returns the outcome of a job with a result.
JobVerification judge(const VerifiedResult& one) {
  if (!one.verification) return unreadable(one.errors);
  const Verification& v = *one.verification;
  JobVerification job{.text = verification_text(v, one.result), .notes = one.notes};
  job.has_certificate = v.has_certificate;
  const int status = exit_status(v);
  if (status == kExitGouges) {
    job.outcome = JobOutcome::refuted;
    job.reasons = refutation_lines(v, one.result);
    return job;
  }
  job.sampled_clean = v.sampled_clean;
  job.outcome = status != kExitClean ? JobOutcome::uncovered
                : is_all_proved(v)   ? JobOutcome::verified
                                     : JobOutcome::sampled;
  if (job.outcome == JobOutcome::uncovered)
    job.reasons = uncovered_parts(v);
  else if (job.outcome == JobOutcome::sampled)
    job.reasons = {"only sampled: " + listed(sampled_parts(v), " and ")};
  else
    job.reasons = {"every bound is proved"};
  return job;
}

/// Verifies the jobs of a batch one after the other.
class BatchVerifier {
 public:
  BatchVerifier(const VerifyArguments& arguments, double seconds, std::ostream& out, std::ostream& err)
      : arguments_(arguments),
        seconds_(seconds),
        out_(out),
        err_(err),
        progress_(err, understand_progress(arguments.progress)) {}

  int run(const std::vector<ListedJob>& jobs) {
    for (const ListedJob& job : jobs) {
      const JobVerification verified = verify(job);
      progress_.end();
      take(job, verified);
      print_job(job, verified);
    }
    const bool has_manifest = fs::exists(fs::path(arguments_.result_file) / kManifestName);
    if (jobs.empty() || !has_manifest) take_status(kExitNotChecked);
    if (!arguments_.is_quiet) out_ << summary(jobs.size(), has_manifest);
    if (arguments_.is_verbose) print_peak_memory(err_);
    return status_;
  }

 private:
  JobVerification verify(const ListedJob& job) {
    if (auto why = why_without_result(job)) return {.reasons = {std::move(*why)}};
    if (job.command != "check")
      return {.outcome = JobOutcome::uncovered,
              .reasons = {"it is a correction; check the corrected toolpath in a job of its own to verify that"}};
    progress_.begin("reading " + job.result_file);
    const Result<FileView> bytes = view_job_result(job, arguments_.input);
    if (!bytes) return unreadable({bytes.error()});
    if (const auto foreign = find_foreign_result(job, bytes->bytes)) {
      const Result<ClaimedResult> other = read_claimed_result(job.result_file, bytes->bytes);
      if (!other && other.error().code == "result-syntax") return unreadable({other.error()});
      return {.outcome = JobOutcome::refuted, .reasons = {foreign->file + ": refuted: " + foreign->message}};
    }
    const Result<CertificateFile> certificate = read_certificate_of(job, arguments_.input);
    if (!certificate) return unreadable({certificate.error()});
    VerifiedResult one = verify_result(job.result_file, bytes->bytes, {certificate->name, certificate->view.bytes},
                                       arguments_, seconds_, progress_);
    if (one.verification && one.result.exit_status != *job.status)
      one.verification->refuted.push_back({.what = "its exit status is " + std::to_string(one.result.exit_status) +
                                                   ", that of the job in " + kBatchSummaryName + " " +
                                                   std::to_string(*job.status)});
    JobVerification verified = judge(one);
    if (job.result_sha256.empty() && status_of(verified.outcome) == kExitClean) {
      verified.outcome = JobOutcome::uncovered;
      verified.reasons = {std::string("whether it is the result of this job: ") + kBatchSummaryName +
                          " has no SHA-256 of it"};
    }
    return verified;
  }

  void take_status(int status) {
    if (severity_of(status) < severity_of(status_)) status_ = status;
  }

  void take(const ListedJob& job, const JobVerification& verified) {
    take_status(status_of(verified.outcome));
    ++counts_.at(static_cast<std::size_t>(verified.outcome));
    if (verified.sampled_clean > 0) {
      sampled_moves_ += verified.sampled_clean;
      ++sampled_jobs_;
      if (!verified.has_certificate) ++without_certificate_;
    }
    if (arguments_.is_quiet && verified.outcome == JobOutcome::unreadable)
      err_ << printable("job " + job.name + ": " + verified.reasons.front()) << "\n";
    if (arguments_.is_verbose) print_notes(err_, verified.notes, arguments_);
  }

  void print_job(const ListedJob& job, const JobVerification& verified) {
    if (arguments_.is_quiet) return;
    const bool is_refuted = verified.outcome == JobOutcome::refuted;  // its lines have the word
    const std::string word = is_refuted ? std::string() : std::string(word_for(verified.outcome)) + ": ";
    out_ << printable("job " + job.name + ": " + word + verified.reasons.front()) << "\n";
    if (arguments_.is_verbose && !verified.text.empty()) {
      std::istringstream lines(verified.text);
      for (std::string line; std::getline(lines, line);) out_ << "  " << line << "\n";
      return;
    }
    const std::vector<std::string>& all = verified.reasons;
    for (std::size_t k = 1; k < all.size() && k <= kMaxDetails; ++k) out_ << printable("  " + word + all[k]) << "\n";
    if (all.size() > kMaxDetails + 1)
      out_ << printable("  and " + std::to_string(all.size() - kMaxDetails - 1) + " more; gougecheck verify " +
                        fs::path(job.result_file).parent_path().string() + " lists them")
           << "\n";
  }

  [[nodiscard]] std::size_t count(JobOutcome outcome) const { return counts_.at(static_cast<std::size_t>(outcome)); }

  [[nodiscard]] std::string summary(std::size_t jobs, bool has_manifest) const {
    std::vector<std::string> numbers;
    for (std::size_t k = 0; k < counts_.size(); ++k)
      if (counts_.at(k) > 0) numbers.push_back(std::to_string(counts_.at(k)) + " " + kCountWords.at(k));
    std::string text = printable(arguments_.result_file) + "\n" + count_text(jobs, "job");
    if (!numbers.empty()) text += ": " + listed(numbers);
    text += "\n";
    if (sampled_jobs_ > 0)
      text += "only sampled: " + count_text(sampled_moves_, "move") + " said to be clean, of " +
              count_text(sampled_jobs_, "job") + " (" + std::to_string(without_certificate_) +
              " without a certificate)\n";
    if (!has_manifest)
      text += std::string("not covered: whether ") + kBatchSummaryName +
              " is as the batch wrote it, as the folder has no " + kManifestName + "\n";
    if (count(JobOutcome::verified) + count(JobOutcome::sampled) + count(JobOutcome::uncovered) > 0)
      text += not_part_of_a_verification();
    return text + "result: " + verdict(jobs) + "\n";
  }

  [[nodiscard]] std::string verdict(std::size_t jobs) const {
    if (jobs == 0) return "nothing is verified; the batch has no jobs";
    if (count(JobOutcome::refuted) > 0)
      return "refuted; a result is not right, or it or its inputs are not those of the batch";
    if (status_ != kExitClean) return "not refuted, but not all of it is covered";
    return count(JobOutcome::sampled) == 0 ? "verified" : "not refuted; what is only sampled may be wrong all the same";
  }

  const VerifyArguments& arguments_;
  double seconds_;
  std::ostream& out_;
  std::ostream& err_;
  Progress progress_;
  std::array<std::size_t, kOutcomeWords.size()> counts_{};
  std::size_t sampled_moves_ = 0, sampled_jobs_ = 0, without_certificate_ = 0;
  int status_ = kExitClean;
};

}  // namespace

int run_verify_batch(const VerifyArguments& arguments, double seconds, std::ostream& out, std::ostream& err) {
  if (!arguments.certificate_file.empty())
    return fail(
        err,
        {make_error("usage",
                    "--certificate belongs to one result; for the folder of a batch, verify reads the "
                    "certificates that its jobs wrote (batch --certificates, or the key \"certificate\" of a job)")});
  const Result<std::vector<ListedJob>> jobs = read_batch_jobs(arguments.result_file, arguments.input);
  if (!jobs) return fail(err, {jobs.error()});
  return BatchVerifier(arguments, seconds, out, err).run(*jobs);
}

}  // namespace gouge
