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

/// One finding as plain data, apart from the model it was made of. Lengths are in the toolpath's unit.
struct Finding {
  MoveState state = MoveState::gouge;
  std::size_t line = 0;  ///< of its worst move; 0: none
  std::size_t move = 0;  ///< its worst one; of what was not checked the first
  std::size_t moves = 0;
  std::string tool;                             ///< number, else name
  std::string body, against;                    ///< "holder", the mesh's name; empty where there is no witness
  std::optional<double> depth, depth_upper, t;  ///< none where nothing measured it
  std::optional<Vec3> point;
  std::string message;      ///< without its location
  std::string fingerprint;  ///< 16 digits, the same wherever the line moves, as long as statement, tool and body stay
  /// "new", "updated" (something else was accepted there) or "unchanged" (accepted); empty: no --baseline.
  std::string baseline_state;
  std::string justification;  ///< of what is accepted: who accepted it and why
};

/// Returns the number of each of CheckResult::events as a finding, from 1, or 0 for an event that is not one. Buried
/// tools come first, then gouges, the deepest first, then near misses. Those alike are in the order of the path.
[[nodiscard]] std::vector<std::size_t> finding_numbers(const CheckResult& result);

/// Returns every event in the order of the path, then every reason why moves were not checked or not certified.
[[nodiscard]] std::vector<Finding> list_findings(const ReportModel& model);

/// Facts of a run beside its findings.
struct SarifNote {
  std::string level, code, text;
};
[[nodiscard]] SarifNote sarif_note_of(const Diagnostic& diagnostic);

/// The part of one run in a SARIF file.
struct SarifJob {
  std::string toolpath;  ///< as the user named it
  int exit_status = 0;
  std::vector<SarifNote> notes;
  std::vector<Finding> findings;
};
[[nodiscard]] SarifJob sarif_job_of(const ReportModel& model);
/// Writes SARIF 2.1.0 of one run or many: one invocation and one artifact each, the findings in their order.
[[nodiscard]] std::string write_sarif(const std::vector<SarifJob>& jobs);

/// One test case of JUnit: an operation with one tool.
struct JunitCase {
  std::string name;
  std::size_t moves = 0;
  std::string failure_type, failure_message, failure_text;  ///< empty type: none
  std::string skipped_message;                              ///< empty: not skipped
  std::string error_message;                                ///< empty: none
};

/// The part of one run in a JUnit file. `seconds` is divided among the cases by their moves.
struct JunitSuite {
  std::string toolpath;  ///< as the user named it
  std::string name;      ///< of the suite
  double seconds = 0;
  std::size_t moves = 0;
  std::vector<JunitCase> cases;
  std::string beside;  ///< warnings and notes, a line each
};
[[nodiscard]] JunitSuite junit_suite_of(const ReportModel& model);
[[nodiscard]] std::string write_junit(const std::vector<JunitSuite>& suites);

/// Layout of findings in text output. It changes no verdict, no count and no file.
struct FindingsView {
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  bool is_deepest_first = false;  ///< else in the order of the path
  double min_depth_mm = 0;        ///< findings proved shallower are not listed; 0: all are
  std::size_t most = kAll;        ///< no more findings are listed than so many, the deepest
  bool has_statements = false;    ///< quotes the statement of each
  bool is_coloured = false;
};

/// The findings that a view lists.
struct ListedFindings {
  std::vector<std::size_t> events;  ///< of CheckResult::events, in the order of the view
  std::size_t shallower = 0;        ///< not listed by min_depth_mm
  std::size_t more = 0;             ///< not listed by `most` ...
  double deepest_more_mm = 0;       ///< ... and the deepest of them; 0: none gouges
};

/// Lists gouges, buried tools and near misses. A buried tool counts as deepest, a near miss as less deep than any
/// gouge. A finding is listed if its upper bound reaches min_depth_mm, or if it is buried.
[[nodiscard]] ListedFindings list_events(const ReportModel& model, const FindingsView& view);

}  // namespace gouge
