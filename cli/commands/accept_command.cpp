#include "cli/commands/accept_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands/acceptance_file.h"
#include "cli/commands/acceptor.h"
#include "cli/commands/batch_results.h"
#include "cli/commands/load_result.h"
#include "cli/output/output_file.h"
#include "cli/output/report_folder.h"
#include "cli/terminal/length_text.h"
#include "lib/base/exit_code.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "postproc/accept/accepted.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

std::string date_of(std::time_t seconds) {
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d", &parts)};
}

// Returns the date of today, or of SOURCE_DATE_EPOCH if it is set:
// https://reproducible-builds.org/specs/source-date-epoch/
std::string today() {
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = parse_integer(fixed != nullptr ? fixed : "");
  return date_of(seconds ? static_cast<std::time_t>(*seconds) : std::time(nullptr));
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

bool is_accepting(const AcceptArguments& a) { return a.is_all || !a.findings.empty(); }

bool is_one_line(const std::string& text) {
  return std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

/// Finds what cannot be combined with --withdraw.
std::optional<Diagnostic> find_wrong_word_beside_withdraw(const AcceptArguments& a) {
  if (a.results.size() == 1 && !is_accepting(a) && a.reason.empty() && a.by.empty() && a.date.empty() &&
      a.output.empty())
    return std::nullopt;
  return make_error("usage",
                    "--withdraw removes entries from one file of accepted findings; expected that file and no "
                    "--finding, --all, --reason, --reviewer, --date or -o");
}

/// Finds an option other than the result that is missing or wrong.
std::optional<Diagnostic> find_wrong_word(const AcceptArguments& a) {
  if (!a.withdrawn.empty()) return find_wrong_word_beside_withdraw(a);
  if (a.is_all && !a.findings.empty())
    return make_error("usage", "accept takes --all or --finding, and not both: --all accepts every finding");
  if (!is_accepting(a)) {
    if (a.reason.empty() && a.by.empty() && a.date.empty() && a.output.empty()) return std::nullopt;
    return make_error("usage",
                      "accept needs --finding, the number of what is accepted, or --all; without any other option it "
                      "lists the findings of a result");
  }
  std::vector<ChosenFinding> findings = a.findings;
  std::ranges::sort(findings);
  if (const auto twice = std::ranges::adjacent_find(findings); twice != findings.end())
    return make_error("usage", "--finding names finding " + twice->text() + " twice; expected each once");
  if (!is_utf8(a.reason)) return usage_error("--reason", a.reason, "text in UTF-8");
  if (!is_utf8(a.by) || !is_one_line(a.by)) return usage_error("--reviewer", a.by, "one line of text in UTF-8");
  if (is_blank(a.reason)) return make_error("usage", "accept needs --reason, for those who read of it later");
  if (is_blank(a.by)) return make_error("usage", "accept needs --reviewer, who accepts it");
  if (a.output.empty())
    return make_error("usage", "accept needs -o FILE, where accepted findings are kept; what is there already stays");
  if (a.output == "-")
    return make_error("usage", "-o - is not possible with accept, because it adds to a file; expected -o FILE");
  if (!a.date.empty() && !is_date(a.date)) return usage_error("--date", a.date, "a day like 2026-11-23");
  return std::nullopt;
}

/// Returns the warning about a date that is not yet anywhere on earth.
Diagnostics doubts_about_date(const AcceptArguments& a) {
  constexpr std::time_t kDay_s = 86400;
  const std::time_t now = std::time(nullptr);
  if (a.date.empty() || a.date <= date_of(now + kDay_s)) return {};
  return {make_warning("accept-date", "--date " + a.date + " is in the future; today is " + date_of(now) + " (UTC)")};
}

/// Lists the findings of a result with the words for --finding. `job` is empty for a single result.
void list(const std::string& job, const StoredResult& result, std::ostream& out) {
  std::vector<const EventRecord*> findings;
  for (const EventRecord& finding : result.findings) findings.push_back(&finding);
  std::ranges::sort(findings, {}, &EventRecord::number);
  for (const EventRecord* finding : findings) {
    const ChosenFinding chosen{job, static_cast<std::uint32_t>(*finding->number)};
    out << printable(chosen.text() + "  " + result.record.toolpath.file + ":" + std::to_string(finding->line) + ": " +
                     stored_finding_text(result, *finding))
        << "\n";
  }
  out << count_text(findings.size(), "finding") << " in " << printable(result.file) << "\n";
}

/// Adds an option with numbers and ranges of them, which may belong to jobs. Calls `take` for each number.
void add_numbers_option(CLI::App& command, const char* name, bool may_name_jobs,
                        std::function<void(const ChosenFinding&)> take, const char* help, const char* expected) {
  command
      .add_option_function<std::vector<std::string>>(
          name,
          [take = std::move(take)](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) std::ranges::for_each(parse_findings(text).value(), take);
          },
          help)
      ->check([may_name_jobs, expected](const std::string& text) {
        const auto numbers = parse_findings(text);
        return numbers && (may_name_jobs || numbers->front().job.empty()) ? std::string() : std::string(expected);
      })
      ->type_name("N")
      ->allow_extra_args(false);
}

}  // namespace

void add_accept_options(CLI::App& command, AcceptArguments& arguments) {
  command
      .add_option("RESULT", arguments.results,
                  "Results with the findings (the output of --json, the folder of a report, or the folder of a batch); "
                  "or one file of accepted findings, to list its entries")
      ->type_name("FILE")
      ->required();
  add_numbers_option(
      command, "--finding", true, [&arguments](const ChosenFinding& finding) { arguments.findings.push_back(finding); },
      "Numbers of the findings to accept: 3, 3,4 or 3-6; for a job of a batch JOB:3 or JOB:3,5-7 (repeatable; default: list "
      "all findings)",
      "expected the number of a finding, or a range such as 3-6, or JOB:3-6");
  command.add_flag("--all", arguments.is_all,
                   "Accept every finding of each RESULT. Findings that cannot be accepted are named and stay gouges");
  command.add_option("--reason", arguments.reason, "Reason why the finding is accepted")->type_name("TEXT");
  command.add_option("--reviewer,--by", arguments.by, "Name of the person who accepts the finding")->type_name("NAME");
  command.add_option("--date", arguments.date, "Date of the acceptance, such as 2026-11-23 (default: today, UTC)")
      ->type_name("DAY");
  command.add_option("-o,--output", arguments.output, "File of accepted findings; existing entries stay")
      ->type_name("FILE");
  add_numbers_option(
      command, "--withdraw", false,
      [&arguments](const ChosenFinding& entry) { arguments.withdrawn.push_back(entry.number); },
      "Numbers of the entries to remove from the file of accepted findings RESULT: 3, 3,4 or 3-6 (repeatable)",
      "expected the number of an entry, or a range such as 3-6");
  add_input_limit(command, arguments.input);
  command.footer(
      "Examples:\n"
      "  gougecheck accept report/result.json\n"
      "  gougecheck accept report/result.json --finding 3 --reason \"stock allowance\" \\\n"
      "      --reviewer \"R. Miller\" -o accepted.json\n"
      "  gougecheck accept night --finding op10:3 --finding op20:1-4 \\\n"
      "      --reason \"stock allowance\" --reviewer \"R. Miller\" -o accepted.json\n"
      "  gougecheck accept night --all --reason \"prototype\" \\\n"
      "      --reviewer \"R. Miller\" -o accepted.json\n"
      "  gougecheck check part.apt --part part.stl --baseline accepted.json\n"
      "  gougecheck accept accepted.json\n"
      "  gougecheck accept accepted.json --withdraw 2\n\n"
      "An acceptance holds for these motions up to this depth, with this tool, part, place, tolerance and "
      "clearances. If one of them changes, the acceptance is no longer valid. A buried tool cannot be accepted, "
      "nor can a move that was not checked or not certified.");
}

namespace {

/// Returns all results that were named; the folder of a batch stands for the results of its jobs. Single results have
/// no job name. `warnings` receives the jobs without a result.
Result<std::vector<ListedJob>> named_results(const AcceptArguments& arguments, Diagnostics& warnings) {
  std::vector<ListedJob> all;
  for (const std::string& typed : arguments.results) {
    if (!is_batch_folder(typed)) {
      if (const auto other = refuse_other_folder(typed)) return *other;
      all.push_back({{}, {}, result_in(typed)});
      continue;
    }
    const Result<std::vector<ListedJob>> jobs = read_batch_jobs(typed, arguments.input);
    if (!jobs) return jobs.error();
    const std::size_t before = all.size();
    std::ranges::copy_if(*jobs, std::back_inserter(all), [](const ListedJob& job) { return !job.result_file.empty(); });
    if (all.size() == before)
      return make_error("usage",
                        typed + " is the folder of a batch without reports; run it again without --no-reports");
    for (const ListedJob& job : *jobs)
      if (job.result_file.empty())
        warnings.push_back(make_warning(
            "accept-no-result",
            "job " + job.name + " (" + job.verdict + ") has no result, so nothing of it is accepted", typed));
  }
  return all;
}

Result<std::vector<StoredResult>> read_results(const AcceptArguments& arguments, const std::vector<ListedJob>& named) {
  std::vector<StoredResult> results;
  for (const ListedJob& one : named) {
    Result<StoredResult> result =
        one.name.empty() ? load_result(one.result_file, arguments.input) : load_job_result(one, arguments.input);
    if (!result) return result.error();
    results.push_back(std::move(*result));
  }
  return results;
}

/// Returns the numbers of the findings of a job that were asked for. Those without a job belong to the only result.
std::vector<std::size_t> chosen_of(const AcceptArguments& arguments, const std::string& job) {
  std::vector<std::size_t> numbers;
  for (const ChosenFinding& finding : arguments.findings)
    if (finding.job.empty() || finding.job == job) numbers.push_back(finding.number);
  return numbers;
}

int accept(const AcceptArguments& arguments, const std::vector<ListedJob>& named,
           const std::vector<StoredResult>& results, std::ostream& out, std::ostream& err) {
  const FolderLock lock(arguments.output);
  Result<std::vector<Acceptance>> existing = read_acceptances(arguments.output, arguments.input);
  if (!existing) return fail(err, {existing.error()});
  const AcceptanceNote note{arguments.reason, arguments.by, arguments.date.empty() ? today() : arguments.date};
  Acceptor acceptor(note, std::move(*existing));
  for (std::size_t k = 0; k < results.size(); ++k) {
    if (arguments.is_all) {
      acceptor.accept_all(results[k]);
    } else if (const Outcome added = acceptor.accept_named(chosen_of(arguments, named[k].name), results[k]); !added) {
      return fail(err, {added.error()});
    }
  }
  acceptor.test_outcome();
  std::error_code ignored;
  const bool is_stated = arguments.is_all && acceptor.refused().empty();  // also that there is nothing to accept
  if (acceptor.has_new() || (is_stated && !fs::exists(arguments.output, ignored))) {
    if (const Outcome written = write_output(arguments.output, write_accepted(acceptor.entries()), out); !written)
      return fail(err, {written.error()}, kExitInternal);
  }
  print(err, doubts_about_date(arguments));
  acceptor.tell(out);
  if (acceptor.has_new() || is_stated) out << count_line(arguments.output, acceptor.entries().size());
  return acceptor.refused().empty() ? kExitClean : fail(err, acceptor.refused());
}

/// Returns the entries if the only RESULT is a file of accepted findings, and `reason` otherwise.
Result<std::vector<Acceptance>> entries_in_place_of_results(const AcceptArguments& arguments,
                                                            const Diagnostic& reason) {
  if (reason.code != "result-format" || arguments.results.size() != 1 || is_accepting(arguments)) return reason;
  Result<std::vector<Acceptance>> entries = read_acceptances(arguments.results.front(), arguments.input);
  return entries || entries.error().code != "accepted-format" ? entries : reason;
}

/// Lists the findings of results, or the entries of a file of accepted findings.
int list_all(const AcceptArguments& arguments, const std::vector<ListedJob>& named, std::ostream& out,
             std::ostream& err) {
  const Result<std::vector<StoredResult>> results = read_results(arguments, named);
  if (!results) {
    const auto entries = entries_in_place_of_results(arguments, results.error());
    if (!entries) return fail(err, {entries.error()});
    list_acceptances(arguments.results.front(), *entries, out);
    return kExitClean;
  }
  for (std::size_t k = 0; k < results->size(); ++k) list(named[k].name, (*results)[k], out);
  return kExitClean;
}

}  // namespace

int run_accept(const AcceptArguments& arguments, std::ostream& out, std::ostream& err) {
  if (const auto wrong = find_wrong_word(arguments)) return fail(err, {*wrong});
  if (!arguments.withdrawn.empty())
    return withdraw_acceptances(arguments.results.front(), arguments.withdrawn, arguments.input, out, err);
  const OutputTable outputs = asked_for({{"-o", arguments.output}});
  std::vector<InputOption> inputs;
  Diagnostics warnings;
  const Result<std::vector<ListedJob>> named = named_results(arguments, warnings);
  if (!named) return fail(err, {named.error()});
  if (const auto wrong = find_wrong_choice(arguments.findings, *named)) return fail(err, {*wrong});
  for (const ListedJob& one : *named) inputs.push_back({"the result", one.result_file});
  if (const auto status = refuse_outputs(inputs, outputs, err)) return *status;
  if (!is_accepting(arguments)) return list_all(arguments, *named, out, err);
  const Result<std::vector<StoredResult>> results = read_results(arguments, *named);
  if (!results) return fail(err, {results.error()});
  if (arguments.is_all) print(err, warnings);
  return accept(arguments, *named, *results, out, err);
}

}  // namespace gouge
