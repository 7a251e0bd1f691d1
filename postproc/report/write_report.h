#pragma once

#include <string>
#include <vector>

#include "lib/base/text_writer.h"
#include "postproc/report/findings.h"
#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

// A report as text, one function for each form.

namespace gouge {

/// Writes the text that `check` and `correct` print. First comes one finding a line as compilers print them, in the
/// order of the path. Then come the moves that were not checked or not certified, grouped by reason, and a summary of a
/// few lines. The `view` may list fewer of the findings, in another order; findings that it leaves out are counted.
/// `path.apt:123: gouge: 0.213 mm cutter T1 at (12.3, 4.5, 6.7), move 118 t=0.42 (7 moves, 118-124), operation ROUGH`
[[nodiscard]] std::string findings_text(const ReportModel& model, const FindingsView& view = {});

/// "gouges: 4 findings in 126 of 2477 moves, ..." of the result; of a correction also of the path before.
struct Headlines {
  std::string now, before;
};
[[nodiscard]] Headlines headlines(const ReportModel& model);

/// Returns the summary alone.
[[nodiscard]] std::string summary_text(const ReportModel& model, bool is_coloured = false);

/// Writes the report as one HTML page that needs nothing beside it. It holds verdict, guarantee, pictures (embedded),
/// findings and the changes of a correction. It also holds the unchecked moves, inputs with checksums, and options.
/// Prints well on A4. Long tables show their worst rows and state how many more there are; the CSV and JSON have them
/// all.
/// The `pictures` are PNG files named as by draw_report_pictures; event_N.png is linked from the findings. The `view`
/// is the 3D view (postproc/viewer), HTML that stands before the pictures; it may be empty.
[[nodiscard]] std::string write_html(const ReportModel& model, const std::vector<NamedFile>& pictures,
                                     const std::string& view = {});

/// Returns the report as JSON: docs/formats/report_json.md, schema docs/formats/report.schema.json. Key order is fixed,
/// lengths are in the toolpath's unit and read back exactly, text is UTF-8.
[[nodiscard]] std::string write_json(const ReportModel& model);

/// Returns one row for every move, header first; RFC 4180 with line feeds. Columns and their meaning:
/// docs/formats/csv.md. Lengths in the toolpath's unit, written so that they read back exactly.
[[nodiscard]] std::string write_csv(const ReportModel& model);
/// The same in parts, never whole in memory.
void put_csv(const ReportModel& model, const PutText& put);

/// Writes the findings as SARIF 2.1.0, for code hosts and editors. There is one result an event, and one for each
/// reason why moves were not checked or not certified. Rules: gouge, buried, near, not-checked, not-certified.
/// The fingerprint of a finding holds as long as its statement, tool and body do, wherever the line moves.
[[nodiscard]] std::string write_sarif(const ReportModel& model);

/// Writes the result as JUnit XML, for build servers: one test case for each operation and tool, in path order. A case
/// fails on gouges and buried tools (named by the worst of them). It counts as skipped when it has moves that could not
/// be checked or certified. The `time` of the suite is model.seconds. That of a case is its share by moves, as all
/// moves are swept together.
[[nodiscard]] std::string write_junit(const ReportModel& model);

}  // namespace gouge
