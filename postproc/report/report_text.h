#pragma once

#include <string>
#include <string_view>

#include "postproc/report/report_model.h"

// Wording and escapes that the writers share. Text for people is rounded; text for programs goes through
// exact_text instead.

namespace gouge {

/// Code of the note on what a project file sets, which stands beside the verdict.
inline constexpr const char* kProjectFile = "project-file";

/// Thousands apart: "4,957".
[[nodiscard]] std::string grouped_text(std::size_t count);
/// Returns a length for people, in `unit`, with its name: "0.213 mm", "0.0084 in". Small lengths keep two digits.
[[nodiscard]] std::string depth_text(double length_mm, LengthUnit unit);
/// Returns the same beside the limits of the check. It has enough digits to differ from the tolerance, from tolerance +
/// resolution and from the near miss requested: "0.0112 mm" beside 0.011 mm.
[[nodiscard]] std::string depth_text(double length_mm, LengthUnit unit, const CheckOptions& limits);
/// Up to six digits, four below 1, no trailing zeros: "0.011 mm", "44.4543 mm", "0.0004331 in".
[[nodiscard]] std::string length_text(double length_mm, LengthUnit unit);
/// Returns for pictures, where room is short: six decimals, or more where three digits need them; no trailing zeros:
/// "0.000394 in".
[[nodiscard]] std::string short_length_text(double length_mm, LengthUnit unit);
/// Returns "(12.3, 4.5, 6.7)" in `unit`: three decimals in mm and four in inches, trailing zeros dropped.
[[nodiscard]] std::string point_text(const Vec3& point_mm, LengthUnit unit);
/// Returns "0.42": four decimals, trailing zeros dropped.
[[nodiscard]] std::string instant_text(double t);
/// Returns "mm" or "inches": for headings, where "in in" would read badly.
[[nodiscard]] const char* unit_words(LengthUnit unit);

/// Returns how many of its changes are positions that the path did not have.
[[nodiscard]] std::size_t inserted_positions(const CorrectionFacts& correction);
/// Returns the programmed positions that are not left uncut.
[[nodiscard]] std::size_t moved_positions(const CorrectionFacts& correction);

/// Returns "cuts were moved by up to 0.213 mm: less is cut there than was programmed"; empty where none was.
[[nodiscard]] std::string moved_cuts_text(const CorrectionFacts& correction, LengthUnit unit);

/// Sums over all stretches left out, and over the holes that are drilled less deep.
struct UncutTotal {
  std::size_t stretches = 0, positions = 0;
  double length_mm = 0;
  std::size_t holes = 0;
  double max_of_hole_mm = 0;  ///< most that is missing of the depth of one
};
[[nodiscard]] UncutTotal uncut_total(const CorrectionFacts& correction);
/// Returns "12 positions and 81.2 mm left uncut in 1 stretch, 2 holes left uncut by up to 0.02 mm"; empty where nothing
/// is.
[[nodiscard]] std::string uncut_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns "up to 1.62 mm of what was finished left in 2 stretches, most at (0, 1, 2), line 12"; empty where nothing
/// is.
[[nodiscard]] std::string stock_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns "2 rapids that were written keep less than the clearance of 2 mm: the least 0.005 mm, line 12"; empty where
/// none does.
[[nodiscard]] std::string low_rapids_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns "0.005 mm", "0.005 mm inside": what a rapid keeps.
[[nodiscard]] std::string kept_text(double keeps_mm, LengthUnit unit);
/// Returns "20 mm or more", of one stretch.
[[nodiscard]] std::string thickness_text(const LeftStock& left, LengthUnit unit);
/// Returns "2 curves became 79 straight moves".
[[nodiscard]] std::string straightened_text(const CorrectionFacts& correction);

/// Returns "T1", else the quoted name, else "unnamed tool"; "no tool" for kNone.
[[nodiscard]] std::string tool_label(const Toolpath& toolpath, std::size_t tool);
/// Returns for programs: the number, else the name, else nothing.
[[nodiscard]] std::string tool_key(const Toolpath& toolpath, std::size_t tool);
/// Returns the name of the mesh a witness lies on; empty when the model does not state it.
[[nodiscard]] std::string mesh_name(const ReportModel& model, const Witness& witness);
/// Returns the clearance of the mesh of a witness; 0: none.
[[nodiscard]] double mesh_clearance_mm(const ReportModel& model, const Witness& witness);
[[nodiscard]] std::string operation_name(const Toolpath& toolpath, std::size_t operation);
/// Returns the bytes of a move's statement, line end included; empty where the path does not state.
[[nodiscard]] std::string_view statement_text(const Toolpath& toolpath, const Move& move);

/// Returns the statement of a move as its file has it, up to three lines of at most 200 bytes. Longer text ends in "
/// ...". None where the move has no statement or the file is not text.
[[nodiscard]] std::vector<std::string> statement_lines(const Toolpath& toolpath, std::size_t move);

/// Returns one finding without its location: "gouge: 0.213 mm cutter T1 at (12.3, 4.5, 6.7), move 118 t=0.42".
[[nodiscard]] std::string event_text(const ReportModel& model, const Event& event);
/// Returns " (7 moves, 118-124)", or nothing when the event is one move.
[[nodiscard]] std::string span_text(const Event& event);
/// Returns one of group_reasons without its location: "not checked: <reason> (3 moves, the first is move 7)".
[[nodiscard]] std::string group_text(const ReasonGroup& group);

/// Returns for XML and HTML text and attributes. Bytes that are not UTF-8 become U+FFFD, control characters blanks.
[[nodiscard]] std::string xml_escaped(std::string_view text);
/// A file as a relative reference of RFC 3986, as the user named it; absolute paths become file URIs.
[[nodiscard]] std::string uri_of(const std::string& file);
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace gouge
