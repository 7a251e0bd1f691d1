#include "postproc/report/write_csv.h"

#include <cmath>
#include <optional>
#include <string_view>

#include "lib/base/number_text.h"
#include "lib/base/utf8.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::string_view kHeader =
    "move,line,kind,tool,state,depth,depth_upper,t,body,against,x,y,z,nx,ny,nz,mesh,triangle,operation,reason,"
    "clearance,overcut,overcut_upper\n";

// Whether a spreadsheet might take the text for a formula: =, +, - or @, also in full width, behind blanks,
// quotes and the apostrophe that hides one; tabs and carriage returns begin a cell of their own in some.
bool may_be_formula(std::string_view text) {
  using namespace std::string_view_literals;
  for (std::size_t at = 0; at < text.size();) {
    const std::optional<CodePoint> c = decode_utf8(text, at);
    if (!c) return false;
    if (U"=+-@\t\r\n\uFF1D\uFF0B\uFF0D\uFF20\u2212"sv.find(c->value) != std::u32string_view::npos) return true;
    if (U" \"'\u00A0\u200B\u3000\uFEFF"sv.find(c->value) == std::u32string_view::npos) return false;
    at += c->bytes;
  }
  return false;
}

// An apostrophe in front of what may be a formula, also behind the separators of other locales: there a row
// is split at semicolons, tabs and line ends without regard to quotes that begin within it.
std::string without_formula(std::string_view text) {
  if (parse_number(text)) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins_cell = at == 0 || std::string_view(";\t\r\n").find(text[at - 1]) != std::string_view::npos;
    if (begins_cell && may_be_formula(text.substr(at))) out += '\'';
    out += text[at];
  }
  return out;
}

std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    out += c;
    if (c == '"') out += '"';
  }
  return out + "\"";
}

class Row {
 public:
  void text(std::string_view value) {
    if (!is_first_) line_ += ',';
    is_first_ = false;
    line_ += quoted(value);
  }
  // Text from a file, which somebody else may have written for the spreadsheet that opens ours.
  void foreign(std::string_view value) { text(without_formula(value)); }
  // A bound that was never reached is no number, and a row has no word for it.
  void number(double value) { text(std::isfinite(value) ? exact_text(value) : std::string()); }
  void empty(int count) {
    for (int i = 0; i < count; ++i) text("");
  }
  [[nodiscard]] const std::string& line() const { return line_; }

 private:
  std::string line_;
  bool is_first_ = true;
};

void add_witness(Row& row, const Witness& witness, LengthUnit unit) {
  row.number(witness.t);
  row.text(body_name(witness.body));
  row.text(against_name(witness.against));
  for (int k = 0; k < 3; ++k) row.number(witness.point[k] / mm_per(unit));
  for (int k = 0; k < 3; ++k) row.number(witness.normal[k]);
}

std::string row_of(const ReportModel& model, std::size_t index) {
  const Move& move = model.toolpath->moves[index];
  const MoveVerdict& verdict = model.result->verdicts[index];
  const LengthUnit unit = model.toolpath->unit;
  Row row;
  row.text(std::to_string(index));
  row.text(std::to_string(move.line));
  row.text(kind_name(move.kind));
  row.foreign(tool_key(*model.toolpath, move.tool));
  row.text(state_name(verdict.state));
  const bool has_depth = verdict.state != MoveState::buried && verdict.state != MoveState::not_checked;
  if (has_depth) {
    row.number(verdict.depth_mm / mm_per(unit));
    row.number(verdict.depth_upper_mm / mm_per(unit));
  } else {
    row.empty(2);
  }
  const bool has_witness = has_depth && verdict.depth_mm > 0 && verdict.witness.has_value();
  if (has_witness)
    add_witness(row, *verdict.witness, unit);
  else
    row.empty(9);
  row.foreign(has_witness ? mesh_name(model, *verdict.witness) : std::string());
  row.text(has_witness ? std::to_string(verdict.witness->triangle) : std::string());
  row.foreign(operation_name(*model.toolpath, move.operation));
  row.foreign(reason_text(verdict.reason));
  if (verdict.clearance_mm)
    row.number(*verdict.clearance_mm / mm_per(unit));
  else
    row.empty(1);
  if (verdict.overcut_mm) {
    row.number(*verdict.overcut_mm / mm_per(unit));
    row.number(verdict.overcut_upper_mm / mm_per(unit));
  } else {
    row.empty(2);
  }
  return row.line() + "\n";
}

}  // namespace

std::string write_csv(const ReportModel& model) {
  std::string text(kHeader);
  for (std::size_t i = 0; i < model.result->verdicts.size(); ++i) text += row_of(model, i);
  return text;
}

}  // namespace gouge
