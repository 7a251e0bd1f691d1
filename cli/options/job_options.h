#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/machine/joint_facts.h"
#include "cli/options/mesh_limits.h"
#include "cli/options/option_table.h"
#include "cli/options/reading_options.h"
#include "cli/options/stock_arguments.h"
#include "cli/terminal/listing_options.h"
#include "cli/terminal/print_diagnostics.h"
#include "cli/terminal/progress.h"
#include "lib/base/result.h"
#include "lib/check/check_options.h"
#include "lib/geom/pose.h"
#include "postproc/report/report_model.h"

namespace CLI {
class App;
}

namespace gouge {

/// The project file some of the options come from.
struct ProjectUse {
  InputFile input;      ///< the file, for reports
  std::string summary;  ///< "part, tools and tolerance 0.02 come from ../gougecheck.json"
};

/// The options common to `check` and `correct`, as typed.
struct JobArguments : Verbosity, StockArguments {
  std::string path;
  ReadingArguments reading;
  InputLimit input;
  std::vector<std::string> parts, fixtures, heads;
  LimitTexts part_limits, fixture_limits;
  std::vector<std::string> allowed_overlaps;  ///< of `fixtures`: those that may penetrate a part
  std::string place, stl_units;
  std::string tools_file, holder;
  std::vector<std::string> tool_names;  ///< N=NAME, or NAME for moves that name no tool
  std::string tolerance = "0.01", stock_to_leave = "0", clearance, near_miss = "0", resolution = "0.001";
  std::string rapid = "straight", progress = "auto";
  std::uint32_t threads = 0;
  std::string baseline_file;  ///< of `check`: findings that were accepted
  std::string report_folder, json_file, csv_file, sarif_file, junit_file;
  std::vector<std::string> export_files;
  ListingArguments listing;
  std::optional<ProjectUse> project_file;  ///< none: no project file was used
  std::string certificate_file;            ///< of `check` alone
  /// foreign files in the report's folder; of `correct` also a path that does not fit the part
  bool is_forced = false;
  bool is_extended_up = false;
  std::string machine, feed_law, rapid_law, joint_rapid_law, tool_length;
  StatedJoints joints;
  std::string zero;                           ///< part zero in machine coordinates
  std::string tip_tolerance, axis_tolerance;  ///< empty: 0
  std::vector<std::string> assumed;           ///< --assume
  bool is_strict = false;
  bool has_warnings_as_errors = false;
  std::string project, reviewer;           ///< of the head of the report
  std::string batch_job;                   ///< name of the job in its batch; empty: it is none
  std::string command;                     ///< the command line, to be typed again (command_text.h)
  std::vector<std::string> lengths_in_mm;  ///< typed without a unit (length_rule.h)
};

/// The same, understood.
struct JobOptions {
  ReadOptions reading;
  CheckOptions check;
  RigidTransform place;
  std::vector<MeshLimit> limits;  ///< of parts and fixtures
  std::vector<Vouched> vouched;
  std::optional<double> tool_length_mm;  ///< from the gauge point to the tip
  double tool_length_slack_mm = 0;       ///< the true length is at most so much longer or shorter
  ProgressMode progress = ProgressMode::automatic;
  std::string date;  ///< of the report
};

/// Returns the rows that `check`, `correct` and `batch` share, without those of ReadingArguments and StatedJoints; outputs
/// are rows of their own.
[[nodiscard]] const OptionRows<JobArguments>& job_options();

void add_job_options(CLI::App& command, JobArguments& arguments);
/// The subset that defines the check of one path: all but PATH itself and outputs, for commands that check many.
void add_common_job_options(CLI::App& command, JobArguments& arguments, bool needs_part);
/// The group of options that name outputs or state what they may replace.
inline constexpr const char* kOutputGroup = "Output";
/// --place and --stl-units, of commands that read meshes beside a toolpath.
void add_placement_options(CLI::App& command, std::string& place, std::string& stl_units);
/// --threads and --progress, as every command has them that may take long.
void add_threads_option(CLI::App& command, std::uint32_t& threads);
void add_progress_option(CLI::App& command, std::string& progress);

/// Errors (code usage): names the option, the typed text and the expected one.
[[nodiscard]] Result<JobOptions> understand(const JobArguments& arguments);

/// Returns "2026-11-23 14:05 UTC": now, or the instant of SOURCE_DATE_EPOCH in seconds since 1970. With the latter
/// reports can be made again to the byte (https://reproducible-builds.org/specs/source-date-epoch/). Errors: usage.
[[nodiscard]] Result<std::string> date_of_report();

}  // namespace gouge
