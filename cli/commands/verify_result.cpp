#include "cli/commands/verify_result.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "cli/options/baseline.h"
#include "lib/base/files.h"
#include "lib/base/sha256.h"

namespace gouge {

namespace {

/// Compares the files of a result with those that are there now.
class InputComparer {
 public:
  explicit InputComparer(std::uint64_t max_bytes) : max_bytes_(max_bytes) {}

  Outcome compare(const std::vector<InputFile>& inputs) {
    for (const InputFile& input : inputs) {
      if (Outcome compared = compare(input); !compared) return compared;
    }
    return Done{};
  }

  /// Returns the inputs that differ.
  [[nodiscard]] std::vector<Verification::Refuted> take() { return std::move(changed_); }

 private:
  Outcome compare(const InputFile& input) {
    if (input.name == "-")
      return make_error("verify-input", "the " + input.role +
                                            " of this result was read from standard input; expected a file: check it "
                                            "again by its name");
    const Result<FileView> file = view_file(input.name, max_bytes_);
    if (!file) {
      Diagnostic error = file.error();
      if (error.code == "file-not-found")
        error.message = "there is no such file, nor in the folder of the result or in one above it; expected the " +
                        input.role + " that was checked";
      return error;
    }
    const bool is_same = "sha256:" + sha256_of(file->bytes) == input.checksum;
    if (is_same && file->bytes.size() == input.bytes) return Done{};
    Verification::Refuted one;
    one.what = "the " + input.role + " " + input.name + " is not the file that was checked (its " +
               (is_same ? "size" : "SHA-256") + " differs)";
    changed_.push_back(std::move(one));
    return Done{};
  }

  std::uint64_t max_bytes_;
  std::vector<Verification::Refuted> changed_;
};

bool are_same(const std::vector<InputFile>& a, const std::vector<InputFile>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const InputFile& x, const InputFile& y) {
    return x.role == y.role && x.checksum == y.checksum;
  });
}

/// Returns the inputs of `a` that are not in `b`.
std::vector<InputFile> missing_from(const std::vector<InputFile>& a, std::vector<InputFile> b) {
  std::vector<InputFile> missing;
  for (const InputFile& input : a) {
    const auto same = std::ranges::find_if(
        b, [&](const InputFile& other) { return input.role == other.role && input.checksum == other.checksum; });
    if (same == b.end())
      missing.push_back(input);
    else
      b.erase(same);
  }
  return missing;
}

/// Returns the files that are read now but were not when the result was made, and those that are no longer read: a file
/// was put beside the program or the tool library since.
std::vector<Verification::Refuted> find_other_files(const std::vector<InputFile>& now,
                                                    const std::vector<InputFile>& then) {
  std::vector<Verification::Refuted> others;
  const auto add = [&](const InputFile& input, const std::string& what) {
    Verification::Refuted one;
    one.what = "the " + input.role + " " + input.name + what;
    others.push_back(std::move(one));
  };
  for (const InputFile& input : missing_from(now, then))
    add(input, " is read now, but was not there when this was checked");
  for (const InputFile& input : missing_from(then, now))
    add(input, " was read when this was checked, but no longer is");
  return others;
}

/// Returns the error about a result that does not name the files of all inputs.
std::optional<Diagnostic> find_not_recorded(const std::string& file, const ClaimedResult& result) {
  if (result.not_recorded.empty() || result.digest != DigestState::right) return std::nullopt;
  return make_error("verify-input",
                    "the result does not name the file of the " + result.not_recorded +
                        ", which was in memory of the library or of Python; expected files for all inputs",
                    file);
}

/// Verifies the claims of `one.result`, whose inputs are unchanged.
void verify_unchanged(const std::string& file, const NamedCertificate& certificate, double seconds, Progress& progress,
                      VerifiedResult& one) {
  const ClaimedResult& result = one.result;
  LoadedJob loaded = load_job(result.arguments, result.options, progress);
  if (!loaded.job) {
    one.errors = std::move(loaded.errors);
    return;
  }
  loaded.job->toolpath.file = result.record.toolpath.file;  // a baseline names the toolpath as the result does
  std::optional<LoadedStock> stock;
  if (!result.arguments.stock.empty()) {
    stock = load_stock(result.arguments, *loaded.job, progress, one.errors);
    if (!stock) return;
  }
  if (!are_same(loaded.job->inputs, result.inputs)) {
    if (std::vector<Verification::Refuted> others = find_other_files(loaded.job->inputs, result.inputs);
        !others.empty()) {
      one.verification.emplace().refuted = std::move(others);
      return;
    }
    one.errors = {make_error("input-changed", "the inputs changed while they were read; run it again", file)};
    return;
  }
  Result<LoadedBaseline> baseline = load_baseline(result.arguments.baseline_file, result.arguments.input);
  if (!baseline) {
    one.errors = {baseline.error()};
    return;
  }
  if (result.record.baseline) baseline->file = result.record.baseline->file;
  one.notes = loaded.job->notes;
  Result<Verification> verification =
      verify_claims(*loaded.job, {stock ? &*stock : nullptr, *baseline}, result, certificate, seconds, progress);
  if (verification)
    one.verification = std::move(*verification);
  else
    one.errors = {verification.error()};
}

}  // namespace

VerifiedResult verify_result(const std::string& file, std::string_view bytes, const NamedCertificate& certificate,
                             const VerifyArguments& arguments, double seconds, Progress& progress) {
  VerifiedResult one;
  Result<ClaimedResult> result = read_claimed_result(file, bytes);
  if (!result) {
    one.errors = {result.error()};
    return one;
  }
  if (const auto missing = find_not_recorded(file, *result)) {
    one.errors = {*missing};
    return one;
  }
  one.result = std::move(*result);
  one.result.arguments.input = arguments.input;
  one.result.options.check.threads = arguments.threads;
  InputComparer inputs(arguments.input.max_bytes);
  for (const auto* files : {&one.result.inputs, &one.result.beside_inputs}) {
    if (const Outcome compared = inputs.compare(*files); !compared) {
      one.errors = {compared.error()};
      return one;
    }
  }
  if (std::vector<Verification::Refuted> changed = inputs.take(); !changed.empty())
    one.verification.emplace().refuted = std::move(changed);
  else
    verify_unchanged(file, certificate, seconds, progress, one);
  return one;
}

}  // namespace gouge
