#include "cli/commands/verify_command.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

#include "cli/commands/verification_text.h"
#include "cli/commands/verify_batch.h"
#include "cli/commands/verify_result.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/progress.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"

namespace gouge {

namespace {

constexpr double kMaxSeconds = 1e6;

}  // namespace

void add_verify_options(CLI::App& command, VerifyArguments& a) {
  command
      .add_option("RESULT", a.result_file,
                  "Result of a check: the output of --json, the folder of a report, or the folder of a batch")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--certificate", a.certificate_file, "Proofs of the same check (the output of check --certificate)")
      ->type_name("FILE");
  command
      .add_option(
          "--seconds", a.seconds,
          "Minimum duration of sampling (default: 0, for the end of every move without a proof and 4000 instants more, "
          "whatever time they take; maximum: 1000000)")
      ->type_name("SECONDS");
  add_input_limit(command, a.input);
  add_threads_option(command, a.threads);
  add_progress_option(command, a.progress);
  add_verbosity(
      command, a,
      "Print notes of all inputs and the peak memory, and for a batch the text of each verification (not with -q)");
  command.footer(
      "Example:\n"
      "  gougecheck check part.apt --part part.stl --tools tools.json \\\n"
      "      --json result.json --certificate proofs.gcp\n"
      "  gougecheck verify result.json --certificate proofs.gcp\n"
      "  gougecheck verify night      # all jobs of a batch\n\n"
      "The command reads the inputs that the result names, from their paths, or relative to the folder of the result "
      "or to one above it. It recomputes every witness, tests every proof in interval arithmetic and looks for "
      "counterexamples. Its code for depths and findings shares nothing with the check except the readers of files. It also "
      "makes the other fields of the result anew and compares them. docs/method/verify.md explains "
      "the method and has an example that is computed by hand.\n\n"
      "For the folder of a batch it verifies the result of each job, with the certificate that the job wrote. Clean moves "
      "without a certificate are only sampled.\n\n"
      "Exit status: 0 verified, 1 refuted, 2 wrong command line, 3 input unreadable, 4 not everything is "
      "covered, 5 internal or resource failure. For a batch it is that of the worst job, in the order 5, 2, 3, 1, 4, 0; "
      "a job without a result counts as 4.");
}

int run_verify(const VerifyArguments& typed, std::ostream& out, std::ostream& err) {
  VerifyArguments a = typed;
  if (const auto error = find_contradiction(a)) return fail(err, {*error});
  const std::optional<double> seconds = a.seconds.empty() ? 0 : parse_number(a.seconds);
  if (!seconds || !(*seconds >= 0 && *seconds <= kMaxSeconds))
    return fail(err, {usage_error("--seconds", a.seconds,
                                  "a number of seconds from 0 to " + display_text(kMaxSeconds, 0) + ", such as 2.5")});
  if (is_batch_folder(typed.result_file)) return run_verify_batch(typed, *seconds, out, err);
  if (const auto other = refuse_other_folder(typed.result_file)) return fail(err, {*other});
  a.result_file = result_in(typed.result_file);
  Progress progress(err, understand_progress(a.progress));
  progress.begin("reading " + a.result_file);
  const Result<FileView> bytes = view_file(a.result_file, a.input.max_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  FileView certificate;
  if (!a.certificate_file.empty()) {
    Result<FileView> read = view_file(a.certificate_file, a.input.max_bytes);
    if (!read) return fail(err, {read.error()});
    certificate = std::move(*read);
  }
  const VerifiedResult one =
      verify_result(a.result_file, bytes->bytes, {a.certificate_file, certificate.bytes}, a, *seconds, progress);
  progress.end();
  print_notes(err, one.notes, a);
  if (!one.verification) return fail(err, one.errors, kExitInput);
  if (a.is_verbose) print_peak_memory(err);
  if (!a.is_quiet) out << verification_text(*one.verification, one.result);
  return exit_status(*one.verification);
}

}  // namespace gouge
