#pragma once

#include <string>
#include <vector>

#include "lib/base/text_writer.h"
#include "postproc/report/findings.h"
#include "postproc/report/named_file.h"
#include "postproc/report/report_model.h"

// Writers of a report as text, one function for each format.

namespace gouge {

/// Returns the text that `check` and `correct` print. First is one line for each finding in the format of compilers, in
/// the order of the path. Then come the moves that were not checked or not certified, grouped by reason, and a summary
/// of a few lines. `view` may select findings and their order; the others are counted.
/// `path.apt:123: gouge: 0.213 mm cutter T1 at (12.3, 4.5, 6.7), move 118 t=0.42 (7 moves, 118-124), operation ROUGH`
[[nodiscard]] std::string findings_text(const ReportModel& model, const FindingsView& view = {});

/// The first lines of a report, such as "gouges: 4 findings in 126 of 2477 moves, ...". `now` is that of the result,
/// and `before` is that of the path before a correction.
struct Headlines {
  std::string now, before;
};
[[nodiscard]] Headlines headlines(const ReportModel& model);

/// Returns only the summary.
[[nodiscard]] std::string summary_text(const ReportModel& model, bool is_coloured = false, std::size_t columns = 0);

/// Parts of a page that other modules make.
struct HtmlParts {
  std::string view;                        ///< the 3D view (postproc/viewer), which precedes the pictures
  std::vector<std::string> tool_drawings;  ///< SVG for each tool; empty: no drawings
  std::string review = {};                 ///< data of review_data (postproc/accept); empty: findings have no review
};

/// Returns the report as one HTML page that needs no other file. It has verdict, guarantee, pictures (embedded),
/// findings and the changes of a correction. It also has the unchecked moves, inputs with checksums, and options. It
/// can be printed on A4. Long tables show their worst rows and the number of the others; CSV and JSON have all rows.
/// `pictures` are PNG files with the names of draw_report_pictures; event_N.png is linked from the findings.
[[nodiscard]] std::string write_html(const ReportModel& model, const std::vector<NamedFile>& pictures,
                                     const HtmlParts& more = {});

/// Returns the report as JSON: docs/formats/report_json.md, schema docs/formats/report.schema.json. The order of keys
/// is fixed. Lengths are in the toolpath's unit and read back exactly; text is UTF-8.
[[nodiscard]] std::string write_json(const ReportModel& model);

/// Returns a header and one row for every move, in the format of RFC 4180 but with line feeds. Columns and their
/// meaning: docs/formats/csv.md. Lengths are in the toolpath's unit and read back exactly.
[[nodiscard]] std::string write_csv(const ReportModel& model);
/// Passes the same text on in parts, so that it is never whole in memory.
void put_csv(const ReportModel& model, const PutText& put);

/// Returns the findings as SARIF 2.1.0, for code hosts and editors. There is one result for each event, and one for
/// each reason why moves were not checked or not certified. Rules: gouge, buried, near, not-checked, not-certified.
/// The fingerprint of a finding stays the same while its statement, tool and body do, even if its line changes.
[[nodiscard]] std::string write_sarif(const ReportModel& model);

/// Returns the result as JUnit XML, for build servers: one test case for each operation and tool, in path order. A case
/// fails on gouges and buried tools, and the worst of them is named. It counts as an error if it has moves that
/// could not be checked or certified. The `time` of the suite is model.seconds. That of a case is a share in proportion to
/// its moves, because all moves are swept together.
[[nodiscard]] std::string write_junit(const ReportModel& model);

}  // namespace gouge
