#include "cli/failed_line.h"

#include "cli/output/outputs.h"
#include "cli/program.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"

namespace gouge {

void write_failure_of(const std::vector<std::string>& words, const Diagnostic& error, int status, std::ostream& out,
                      std::ostream& err) {
  if (status == kExitUsage || words.empty()) return;
  Program program;
  if (!program.parse_incomplete({words.begin() + 1, words.end()})) return;
  const Arguments& arguments = program.arguments;
  const bool is_check = program.app.got_subcommand("check");
  if (!is_check && !program.app.got_subcommand("correct")) return;
  const JobOutputs outputs =
      is_check ? JobOutputs(arguments.check.job, {}) : JobOutputs(arguments.correct.job, arguments.correct.output);
  const JobArguments& job = is_check ? arguments.check.job : arguments.correct.job;
  const Outcome written = outputs.write_failure({job.path, status, {error}}, out);
  if (!written) print(err, {written.error()});
}

int fail_line(const std::vector<std::string>& words, const Diagnostic& error, std::ostream& out, std::ostream& err) {
  const int status = fail(err, {error});
  write_failure_of(words, error, status, out, err);
  return status;
}

}  // namespace gouge
