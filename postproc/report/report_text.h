#pragma once

#include <string>
#include <string_view>

#include "postproc/report/report_model.h"

// Texts and escapes that the writers share. Numbers for people are rounded; those for programs are written by
// exact_text.

namespace gouge {

/// Code of the note, next to the verdict, about the options that a project file sets.
inline constexpr const char* kProjectFile = "project-file";

/// Returns a number with separated thousands: "4,957".
[[nodiscard]] std::string grouped_text(std::size_t count);
/// Returns "3 rapids left out as asked", about the moves that --rapid skip does not check.
[[nodiscard]] std::string left_out_text(std::size_t rapids);
/// Returns a rounded length in `unit`, with its name: "0.213 mm", "0.0084 in". Small lengths keep two digits.
[[nodiscard]] std::string depth_text(double length_mm, LengthUnit unit);
/// Returns a rounded length that is stated together with the limits of the check. It has enough digits to differ from
/// the tolerance, from tolerance + resolution and from the requested near miss: "0.0112 mm" next to 0.011 mm.
[[nodiscard]] std::string depth_text(double length_mm, LengthUnit unit, const CheckOptions& limits);
/// Returns up to six digits, four below 1, without trailing zeros: "0.011 mm", "44.4543 mm", "0.0004331 in".
[[nodiscard]] std::string length_text(double length_mm, LengthUnit unit);
/// Returns a short length for pictures: six decimals, or more if three digits need them, without trailing zeros:
/// "0.000394 in".
[[nodiscard]] std::string short_length_text(double length_mm, LengthUnit unit);
/// Returns "(12.3, 4.5, 6.7)" in `unit`: three decimals in mm and four in inches, without trailing zeros.
[[nodiscard]] std::string point_text(const Vec3& point_mm, LengthUnit unit);
/// Returns "0.42": four decimals, without trailing zeros.
[[nodiscard]] std::string instant_text(double t);
/// Returns "mm" or "inches" for headings, in which "in in" would read badly.
[[nodiscard]] const char* unit_words(LengthUnit unit);

/// Returns the number of changes that are new positions of the path.
[[nodiscard]] std::size_t inserted_positions(const CorrectionFacts& correction);
/// Returns the number of programmed positions that were moved, not left uncut.
[[nodiscard]] std::size_t moved_positions(const CorrectionFacts& correction);

/// Returns "cuts were moved by up to 0.213 mm: less is cut there than was programmed"; empty if no cut was moved.
[[nodiscard]] std::string moved_cuts_text(const CorrectionFacts& correction, LengthUnit unit);

/// Sums over all stretches that are left out, and over the holes that are drilled less deep.
struct UncutTotal {
  std::size_t stretches = 0, positions = 0;
  double length_mm = 0;
  std::size_t holes = 0;
  double max_of_hole_mm = 0;  ///< maximum depth that is missing in a hole
};
[[nodiscard]] UncutTotal uncut_total(const CorrectionFacts& correction);
/// Returns "12 positions and 81.2 mm left uncut in 1 stretch, 2 holes left uncut by up to 0.02 mm"; empty if nothing is
/// left uncut.
[[nodiscard]] std::string uncut_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns "up to 1.62 mm of what was finished left in 2 stretches, most at (0, 1, 2), line 12"; empty if no stock is
/// left.
[[nodiscard]] std::string stock_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns "2 rapids that were written keep less than the clearance of 2 mm: the least 0.005 mm, line 12"; empty if
/// there is none.
[[nodiscard]] std::string low_rapids_text(const CorrectionFacts& correction, LengthUnit unit);
/// Returns the distance that a rapid keeps: "0.005 mm". If it is negative, no distance is certified: the text is "may touch
/// by up to 0.005 mm".
[[nodiscard]] std::string kept_text(double keeps_mm, LengthUnit unit);
/// Returns the thickness of the stock in one stretch: "20 mm or more".
[[nodiscard]] std::string thickness_text(const LeftStock& left, LengthUnit unit);
/// Returns "2 curves became 79 straight moves".
[[nodiscard]] std::string straightened_text(const CorrectionFacts& correction);

/// Returns "T1", else the quoted name, else "unnamed tool"; "no tool" for kNone.
[[nodiscard]] std::string tool_label(const Toolpath& toolpath, std::size_t tool);
/// Returns the key of a tool for programs: its number, else its name, else nothing.
[[nodiscard]] std::string tool_key(const Toolpath& toolpath, std::size_t tool);
/// Returns the name of the mesh of a witness; empty if the model does not have it.
[[nodiscard]] std::string mesh_name(const ReportModel& model, const Witness& witness);
/// Returns the clearance of the mesh of a witness; 0: none.
[[nodiscard]] double mesh_clearance_mm(const ReportModel& model, const Witness& witness);
[[nodiscard]] std::string operation_name(const Toolpath& toolpath, std::size_t operation);
/// Returns the bytes of a move's statement with its line end; empty if the path does not have them.
[[nodiscard]] std::string_view statement_text(const Toolpath& toolpath, const Move& move);
/// Returns whether a statement can be shown: it has no control characters but tabs and line ends, unlike the binary
/// records of NCCS.
[[nodiscard]] bool is_text(std::string_view statement);

/// Returns the statement of a move as in its file, up to three lines of at most 200 bytes. Longer text ends in " ...".
/// Returns none if the move has no statement or the file is not text.
[[nodiscard]] std::vector<std::string> statement_lines(const Toolpath& toolpath, std::size_t move);

/// Returns " against fixture vise.stl", with the mesh's clearance. Empty for the only part, and for stock.
[[nodiscard]] std::string counterpart_text(const ReportModel& model, const Witness& witness);

/// Returns one finding without its location: "gouge: 0.213 mm cutter T1 at (12.3, 4.5, 6.7), move 118 t=0.42".
[[nodiscard]] std::string event_text(const ReportModel& model, const Event& event);
/// Returns " (7 moves, 118-124)", or nothing if the event is one move.
[[nodiscard]] std::string span_text(const Event& event);
/// Returns "feed 800 mm/min" or "rapid"; empty: not known.
[[nodiscard]] std::string feed_text(const Feed& feed, LengthUnit unit);
/// Returns where the event is in the words of the shop: ", lines 12-13, operation FINISH, tool ball D10, feed 800 mm/min,
/// spindle 12000 rpm".
/// Parts that are not known are left out.
[[nodiscard]] std::string setting_text(const ReportModel& model, const Event& event);
/// Returns the pose of the tool at the witness of a move; nothing without a witness, or if the law leaves the motion open.
[[nodiscard]] std::optional<Pose> witness_pose(const ReportModel& model, std::size_t move);
/// Returns the pose of the tool at the worst instant: "tip (1, 2, 3), axis (0, 0, 1)"; empty without a witness.
[[nodiscard]] std::string pose_text(const ReportModel& model, const Event& event);
/// Returns one of group_reasons without its location: "not checked: <reason> (3 moves, the first is move 7)".
[[nodiscard]] std::string group_text(const ReasonGroup& group);

/// Returns the text escaped for XML and HTML text and attributes. Bytes that are not UTF-8 become U+FFFD, and control
/// characters become blanks.
[[nodiscard]] std::string xml_escaped(std::string_view text);
/// Returns a file as a relative reference of RFC 3986, as the user named it; absolute paths become file URIs.
[[nodiscard]] std::string uri_of(const std::string& file);
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace gouge
