#include "cli/options/batch_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {

Result<Shard> understand_shard(const std::string& text) {
  if (text.empty()) return Shard{};
  const std::size_t slash = text.find('/');
  const auto index = parse_integer(text.substr(0, slash));
  const auto count = slash == std::string::npos ? std::nullopt : parse_integer(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *count < *index || *count > 1'000'000)
    return make_error("usage", "--shard '" + printable(text) + "': expected I/N, share I of N, such as 2/8");
  return Shard{static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

void add_batch_options(CLI::App& command, BatchArguments& a) {
  command
      .add_option(
          "JOBS", a.files,
          "Job list (JOBS.json, docs/formats/batch.md), or toolpaths that are checked with the options of check "
          "on this command line. A folder means all toolpaths in it and below it")
      ->type_name("FILE");
  command
      .add_option("-o,--output", a.folder,
                  "Folder for the results: index.html, summary.csv, summary.json, junit.xml, findings.sarif, "
                  "results.sqlite, reports/, corrected/, certificates/")
      ->type_name("FOLDER")
      ->required();
  command.add_option("--jobs", a.jobs, "Maximum number of jobs that run at once (0: as many as threads)")
      ->capture_default_str();
  command.add_flag("--resume", a.is_resumed, "Continue an interrupted batch. Finished jobs are kept");
  command.add_flag("--fresh", a.is_fresh, "Run every job again, even if its inputs and options have not changed");
  command.add_flag("--dry-run", a.is_rehearsal,
                   "List the jobs, their options and their missing files, and write nothing");
  command.add_flag("--no-reports", a.is_without_reports,
                   "Write only the summary of all jobs, without the reports of the jobs");
  command.add_flag(
      "--certificates", a.has_certificates,
      "Let each check write its certificate to certificates/, with which 'gougecheck verify FOLDER' proves its "
      "clean moves; the proofs take longer than the checks");
  command
      .add_option("--stop-on", a.stop_on,
                  "Start no more jobs after a job that failed (error), or also after a job with gouges (gouge)")
      ->check(CLI::IsMember({"error", "gouge"}));
  command
      .add_option("--memory", a.memory_gb,
                  "Maximum memory in GB of the jobs that run at once, as estimated (default: 3/4 of the memory of "
                  "the machine)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--chunk", a.chunk,
                  "Number of moves after which a long check stores its progress for --resume, rounded up to a "
                  "multiple of 256")
      ->capture_default_str()
      ->check(CLI::PositiveNumber)
      ->type_name("MOVES");
  command.add_option("--shard", a.shard, "Run only share I of N of the jobs. 'gougecheck merge' joins the folders")
      ->type_name("I/N");
  command
      .add_option("--watch", a.watch,
                  "Check the toolpaths of a folder or pattern ('hot/*.apt'), and each toolpath that is written "
                  "there later, until ctrl-C")
      ->type_name("FOLDER");
  command
      .add_option("--scratch", a.scratch,
                  "Folder on a local disk for copies of meshes from a slow shared file system. Each mesh is copied "
                  "once for all processes of this machine")
      ->type_name("FOLDER");
  command.add_flag("--force", a.is_forced,
                   "Let outputs replace files of the same name that were not written by a batch or report, except "
                   "inputs");
  add_options_of_checks(command, a.check);
  add_progress_option(command, a.progress);
  add_verbosity(command, a, "Print the warnings and notes of all jobs (not with -q)",
                "Print no results, only errors, those of jobs that failed included, and a warning of inputs that "
                "changed meanwhile");
  command.footer(
      "Examples:\n"
      "  gougecheck batch ops/*.apt --part part.stl --tools tools.json -o night\n"
      "  gougecheck batch ops --part part.stl --tools tools.json -o night\n"
      "  gougecheck batch jobs.json -o night --resume\n\n"
      "A job list:\n"
      "  {\"defaults\": {\"part\": \"part.stl\", \"tools\": \"tools.json\"},\n"
      "   \"jobs\": [{\"name\": \"op10\", \"path\": \"op10.apt\"},\n"
      "            {\"path\": \"finish/*.apt\", \"command\": \"correct\"}]}\n\n"
      "The exit status is that of the worst job. The order from worst to best is 5, 2, 3, 1, 4, 0. 'gougecheck "
      "help check' explains the statuses.");
}

void take_words(const CLI::App& command, BatchArguments& arguments) {
  constexpr std::string_view kOwn[] = {
      "output", "jobs",  "resume",  "fresh", "dry-run", "no-reports", "certificates", "stop-on", "memory", "chunk",
      "shard",  "watch", "scratch", "force", "threads", "progress",   "quiet",        "verbose", "color",  "help"};
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string& name = option->get_lnames().front();
    if (std::ranges::find(kOwn, name) != std::end(kOwn)) continue;
    if (option->get_items_expected_max() == 0) {
      arguments.words.push_back("--" + name);
      continue;
    }
    for (const std::string& value : option->results()) arguments.words.push_back("--" + name + "=" + value);
  }
}

}  // namespace gouge
