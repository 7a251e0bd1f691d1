#include "cli/commands/accept_command.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <ostream>

#include "cli/output/output_file.h"
#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/accept/accepted.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

/// A lock of a folder. If two processes accept at once, it keeps one from losing the entries of the other.
class FolderLock {
 public:
  explicit FolderLock(const std::string& file) {
    const fs::path folder = fs::path(file).parent_path();
    handle_ = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle_ >= 0) ::flock(handle_, LOCK_EX);
  }
  ~FolderLock() {
    if (handle_ >= 0) ::close(handle_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_ = -1;
};

// Returns the date of today, or of SOURCE_DATE_EPOCH if it is set:
// https://reproducible-builds.org/specs/source-date-epoch/
std::string today() {
  std::time_t now = std::time(nullptr);
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  if (const auto seconds = parse_integer(fixed != nullptr ? fixed : "")) now = static_cast<std::time_t>(*seconds);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

bool is_date(const std::string& text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return false;
  const auto year = parse_integer(text.substr(0, 4)), month = parse_integer(text.substr(5, 2)),
             day = parse_integer(text.substr(8, 2));
  if (!year || !month || !day || *year < 1900 || *month < 1 || *day < 1) return false;
  using namespace std::chrono;
  return year_month_day(std::chrono::year(static_cast<int>(*year)), std::chrono::month(static_cast<unsigned>(*month)),
                        std::chrono::day(static_cast<unsigned>(*day)))
      .ok();
}

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r\n") == std::string::npos; }

/// Finds an option other than the result that is missing or wrong.
std::optional<Diagnostic> find_wrong_word(const AcceptArguments& a) {
  if (a.findings.empty()) {
    if (a.reason.empty() && a.by.empty() && a.date.empty() && a.output.empty()) return std::nullopt;
    return make_error("usage",
                      "accept needs --finding, the number of what is accepted; without any other option it "
                      "lists the findings of a result");
  }
  if (is_blank(a.reason)) return make_error("usage", "accept needs --reason, for those who read of it later");
  if (is_blank(a.by)) return make_error("usage", "accept needs --by, who accepts it");
  if (a.output.empty() || a.output == "-")
    return make_error("usage", "accept needs -o FILE, where accepted findings are kept; what is there already stays");
  if (!a.date.empty() && !is_date(a.date)) return usage_error("--date", a.date, "a day like 2026-11-23");
  return std::nullopt;
}

void list(const StoredResult& result, std::ostream& out) {
  std::vector<const EventRecord*> findings;
  for (const EventRecord& finding : result.findings) findings.push_back(&finding);
  std::ranges::sort(findings, {}, &EventRecord::number);
  for (const EventRecord* finding : findings) {
    out << printable(std::to_string(*finding->number) + "  " + result.record.toolpath.file + ":" +
                     std::to_string(finding->line) + ": " + stored_finding_text(result, *finding))
        << "\n";
  }
  out << count_text(findings.size(), "finding") << " in " << printable(result.file) << "\n";
}

/// Returns the existing entries of the file; none if there is no file.
Result<std::vector<Acceptance>> read_existing(const std::string& file, const InputLimit& limit) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(file, ignored))) return std::vector<Acceptance>();
  if (fs::is_fifo(fs::status(file, ignored)))
    return make_error("accepted-format", "is a pipe; expected a file that accepted findings can be added to", file);
  const Result<std::string> bytes = read_file(file, limit.max_bytes);
  if (!bytes) return bytes.error();
  return read_accepted(file, *bytes);
}

}  // namespace

void add_accept_options(CLI::App& command, AcceptArguments& arguments) {
  command
      .add_option("RESULT", arguments.result,
                  "Result with the findings (the output of --json, or result.json of a report)")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--finding", arguments.findings,
                  "Number of a finding to accept (repeatable; default: list all findings)")
      ->type_name("UINT")
      ->allow_extra_args(false);
  command.add_option("--reason", arguments.reason, "Reason why the finding is accepted")->type_name("TEXT");
  command.add_option("--by", arguments.by, "Name of the person who accepts the finding")->type_name("NAME");
  command.add_option("--date", arguments.date, "Date of the acceptance, such as 2026-11-23 (default: today, UTC)")
      ->type_name("DAY");
  command.add_option("-o,--output", arguments.output, "File of accepted findings; existing entries stay")
      ->type_name("FILE");
  add_input_limit(command, arguments.input);
  command.footer(
      "Examples:\n"
      "  gougecheck accept report/result.json\n"
      "  gougecheck accept report/result.json --finding 3 --reason \"stock allowance\" \\\n"
      "      --by \"R. Miller\" -o accepted.json\n"
      "  gougecheck check part.apt --part part.stl --baseline accepted.json\n\n"
      "An acceptance holds for these motions up to this depth, with this tool, part, place, tolerance and "
      "clearances. If one of them changes, the acceptance is no longer valid. A buried tool cannot be accepted, "
      "nor can a move that was not checked or not certified.");
}

int run_accept(const AcceptArguments& arguments, std::ostream& out, std::ostream& err) {
  if (const auto wrong = find_wrong_word(arguments)) return fail(err, {*wrong});
  const OutputTable outputs = asked_for({{"-o", arguments.output}});
  if (const auto status = refuse_outputs({{"the result", arguments.result}}, outputs, err)) return *status;
  const Result<std::string> bytes = read_file(arguments.result, arguments.input.max_bytes);
  if (!bytes) return fail(err, {bytes.error()});
  const Result<StoredResult> result = read_result(arguments.result, *bytes);
  if (!result) return fail(err, {result.error()});
  if (arguments.findings.empty()) {
    list(*result, out);
    return kExitClean;
  }
  const FolderLock lock(arguments.output);
  Result<std::vector<Acceptance>> accepted = read_existing(arguments.output, arguments.input);
  if (!accepted) return fail(err, {accepted.error()});
  const AcceptanceNote note{arguments.reason, arguments.by, arguments.date.empty() ? today() : arguments.date};
  for (const std::uint32_t number : arguments.findings) {
    Result<Acceptance> made = accept_finding(*result, number, note, *accepted);
    if (!made) return fail(err, {made.error()});
    accepted->push_back(std::move(*made));
  }
  if (const Outcome written = write_output(arguments.output, write_accepted(*accepted), out); !written)
    return fail(err, {written.error()}, kExitInternal);
  for (std::size_t k = accepted->size() - arguments.findings.size(); k < accepted->size(); ++k) {
    const Acceptance& made = (*accepted)[k];
    out << printable("accepted: " + made.toolpath + ":" + std::to_string(made.line) + ": " + made.finding) << "\n";
  }
  out << printable(arguments.output + " has " + count_text(accepted->size(), "accepted finding")) << "\n";
  return kExitClean;
}

}  // namespace gouge
