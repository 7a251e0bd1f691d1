#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/check_result.h"
#include "lib/geom/vec.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// One finding as plain data, independent of its model. Lengths are in the unit of the toolpath.
struct Finding {
  MoveState state = MoveState::gouge;
  std::size_t line = 0;  ///< line of its worst move; 0: none
  std::size_t move = 0;  ///< its worst move; for moves that were not checked the first one
  std::size_t moves = 0;
  std::string tool;                             ///< number of the tool, else its name
  std::string body, against;                    ///< "holder", and the name of the mesh; empty if there is no witness
  std::optional<double> depth, depth_upper, t;  ///< none: not measured
  std::optional<Vec3> point;
  std::string message;      ///< without the location
  std::string fingerprint;  ///< 16 digits that depend on statement, tool and body, but not on the line
  /// "new", "updated" (an acceptance concerns it, but does not accept it) or "unchanged" (accepted). Empty: no
  /// --baseline.
  std::string baseline_state;
  std::string justification;  ///< for an accepted finding: who accepted it and why
};

/// Returns the number of each of CheckResult::events as a finding, from 1, or 0 for an event that is not a finding.
/// Buried tools come first, then gouges, the deepest first, then near misses. Equal ones have the order of the path.
[[nodiscard]] std::vector<std::size_t> finding_numbers(const CheckResult& result);

/// Returns every event in the order of the path, then every reason why moves were not checked or not certified.
[[nodiscard]] std::vector<Finding> list_findings(const ReportModel& model);

/// Facts about a run that are not findings.
struct SarifNote {
  std::string level, code, text;
};
[[nodiscard]] SarifNote sarif_note_of(const Diagnostic& diagnostic);

/// The data of one run for a SARIF file.
struct SarifJob {
  std::string toolpath;  ///< as the user named it
  int exit_status = 0;
  std::vector<SarifNote> notes;
  std::vector<Finding> findings;
};
[[nodiscard]] SarifJob sarif_job_of(const ReportModel& model);
/// Returns SARIF 2.1.0 of one or several runs: one invocation and one artifact for each, with the findings in their
/// order.
[[nodiscard]] std::string write_sarif(const std::vector<SarifJob>& jobs);

/// The type of the failure of a test case about material left on the part.
inline constexpr const char* kExcessFailure = "excess";
/// The name of that test case, whose failure_text has a line for each place.
inline constexpr const char* kExcessCase = "material left on the part";

/// One test case of JUnit: an operation with one tool.
struct JunitCase {
  std::string name;
  std::size_t moves = 0;
  std::string failure_type, failure_message, failure_text;  ///< empty type: no failure
  std::string skipped_message;                              ///< why the job has not run; empty: it has
  std::string error_message;                                ///< what is not established; empty: nothing
};

/// The data of one run for a JUnit file. `seconds` is divided among the cases in proportion to their moves.
struct JunitSuite {
  std::string toolpath;  ///< as the user named it
  std::string name;      ///< name of the suite
  double seconds = 0;
  std::size_t moves = 0;
  std::vector<JunitCase> cases;
  std::string beside;  ///< warnings and notes, one in each line
};
[[nodiscard]] JunitSuite junit_suite_of(const ReportModel& model);
[[nodiscard]] std::string write_junit(const std::vector<JunitSuite>& suites);

/// A run that ended without a result.
struct FailedRun {
  std::string toolpath;  ///< as the user named it
  int exit_status = 0;
  Diagnostics errors;
};
/// Returns JUnit XML with one test case, which is an error.
[[nodiscard]] std::string write_junit(const FailedRun& run);
/// Returns SARIF 2.1.0 with an unsuccessful invocation and the errors as its notifications.
[[nodiscard]] std::string write_sarif(const FailedRun& run);

/// Layout of findings in text output. It has no effect on verdicts, counts and files.
struct FindingsView {
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  bool is_deepest_first = false;  ///< false: in the order of the path
  double min_depth_mm = 0;        ///< findings with a smaller upper bound are not listed; 0: all are listed
  std::size_t most = kAll;        ///< maximum number of findings listed, the deepest ones
  bool has_statements = false;    ///< whether the statement of each finding is quoted
  bool is_coloured = false;
  std::size_t columns = 0;  ///< width of the terminal, at which long lines of the summary break; 0: none is one
};

/// The findings that a view lists.
struct ListedFindings {
  std::vector<std::size_t> events;  ///< indices into CheckResult::events, in the order of the view
  std::size_t shallower = 0;        ///< number not listed because of min_depth_mm
  std::size_t more = 0;             ///< number not listed because of `most`
  double deepest_more_mm = 0;       ///< depth of the deepest of these; 0: none of them gouges
};

/// Returns the gouges, buried tools and near misses to list. A buried tool counts as deepest, and a near miss as less
/// deep than any gouge. A finding is listed if its upper bound reaches min_depth_mm, or if it is buried.
[[nodiscard]] ListedFindings list_events(const ReportModel& model, const FindingsView& view);

}  // namespace gouge
