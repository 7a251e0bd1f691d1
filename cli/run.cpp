#include "cli/run.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <ostream>
#include <span>

#include "cli/batch_command.h"
#include "cli/check_command.h"
#include "cli/clash_command.h"
#include "cli/correct_command.h"
#include "cli/help_text.h"
#include "cli/merge_command.h"
#include "cli/mesh_command.h"
#include "cli/parse_errors.h"
#include "cli/path_command.h"
#include "cli/print_diagnostics.h"
#include "cli/standard_output.h"
#include "cli/tool_command.h"
#include "cli/verify_command.h"
#include "lib/base/exit_code.h"
#include "lib/base/parallel.h"
#include "lib/base/printable_text.h"
#include "postproc/report/report_model.h"

namespace gouge {
namespace {

struct Arguments {
  CheckArguments check;
  CorrectArguments correct;
  BatchArguments batch;
  ClashArguments clash;
  MergeArguments merge;
  MeshArguments mesh;
  PathArguments path;
  ToolArguments tool;
  VerifyArguments verify;
};

void describe(CLI::App& app) {
  app.name(kProgramName);
  app.formatter(make_help_formatter());
  app.description(
      "Certified gouge check and correction of 5-axis toolpaths.\n"
      "Reads the CL data of NX, CATIA, Creo, SolidWorks CAM, Fusion, NCCS, Mastercam (NCI) and plain APT, checks "
      "cutter, shank and holder over the whole motion of every move against STL parts and fixtures, corrects what "
      "gouges, and reports with evidence for every finding.");
  app.set_version_flag("--version", std::string(kProgramName) + " " + kProgramVersion);
  app.require_subcommand(1);
  app.footer("Every command explains itself: gougecheck check --help");
}

/// What --threads asks for, for everything the command does. False where that is more than can be.
bool set_threads(const CLI::App& app, const Arguments& arguments, std::ostream& err) {
  std::uint64_t threads = 0;
  if (app.got_subcommand("check")) threads = arguments.check.job.threads;
  if (app.got_subcommand("correct")) threads = arguments.correct.job.threads;
  if (app.got_subcommand("batch")) threads = arguments.batch.job.threads;
  if (app.got_subcommand("mesh")) threads = arguments.mesh.threads;
  if (app.got_subcommand("verify")) threads = arguments.verify.threads;
  if (threads > kMostThreads) {
    print(err, {make_error("too-many-threads", "--threads '" + std::to_string(threads) + "': expected at most " +
                                                   std::to_string(kMostThreads) + ", or 0 for all the machine has")});
    return false;
  }
  set_default_threads(static_cast<unsigned>(threads));
  return true;
}

int dispatch(const CLI::App& app, const Arguments& arguments, std::ostream& out, std::ostream& err) {
  if (!set_threads(app, arguments, err)) return kExitInternal;
  if (app.got_subcommand("check")) return run_check(arguments.check, {out, err});
  if (app.got_subcommand("correct")) return run_correct(arguments.correct, {out, err});
  if (app.got_subcommand("batch")) return run_batch(arguments.batch, out, err);
  if (app.got_subcommand("clash")) return run_clash(arguments.clash, out, err);
  if (app.got_subcommand("merge")) return run_merge(arguments.merge, out, err);
  if (app.got_subcommand("mesh")) return run_mesh(arguments.mesh, out, err);
  if (app.got_subcommand("tool")) return run_tool(arguments.tool, out, err);
  if (app.got_subcommand("verify")) return run_verify(arguments.verify, out, err);
  return run_path(arguments.path, out, err);
}

// What people read may end early (`| head -1`); data that could not be delivered is a failure its command has reported.
int after_printing(int status, std::ostream& out, std::ostream& err) {
  out.flush();
  if (out || status == kExitInternal || is_reader_gone()) return status;
  return fail(err, {describe_failed_output()}, kExitInternal);
}

}  // namespace

int run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  try {
    CLI::App app;
    describe(app);
    Arguments arguments;
    add_check_options(*app.add_subcommand("check", "Find gouges; report"), arguments.check);
    add_correct_options(*app.add_subcommand("correct", "Write a corrected toolpath and check it again"),
                        arguments.correct);
    add_batch_options(*app.add_subcommand("batch", "Check or correct many toolpaths; resumed where it stopped"),
                      arguments.batch);
    add_clash_options(*app.add_subcommand("clash", "Find out whether two bodies of a set-up penetrate, and how deep"),
                      arguments.clash);
    add_merge_options(*app.add_subcommand("merge", "Join the results of the shards of a batch"), arguments.merge);
    add_mesh_options(*app.add_subcommand("mesh", "Validate an STL file and repair it"), arguments.mesh);
    add_path_options(*app.add_subcommand("path", "Show what is in a toolpath file"), arguments.path);
    add_tool_options(*app.add_subcommand("tool", "List, show, draw and import the tools of a library"), arguments.tool);
    add_verify_options(*app.add_subcommand("verify", "Verify the result of a check by independent means"),
                       arguments.verify);
    const std::span words(argv, static_cast<std::size_t>(argc));
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      // --help and --version come as errors of status 0.
      if (error.get_exit_code() == 0) return after_printing(app.exit(error, out, err), out, err);
      const std::optional<Diagnostic> empty = find_empty_value(app, words);
      return fail(err, {empty ? *empty : describe_parse_error(app, error)});
    }
    if (const std::optional<Diagnostic> empty = find_empty_value(app, words)) return fail(err, {*empty});
    if (app.got_subcommand("batch")) take_words(*app.get_subcommand("batch"), arguments.batch);
    return after_printing(dispatch(app, arguments, out, err), out, err);
  } catch (const std::bad_alloc&) {
    err << "gougecheck: error: out of memory; nothing more was written [out-of-memory]\n";
  } catch (const std::exception& error) {
    err << "gougecheck: error: internal failure: " << printable(error.what()) << " [internal]\n";
  }
  return kExitInternal;
}

}  // namespace gouge
