#include "postproc/report/write_csv.h"

#include <cmath>
#include <string_view>

#include "lib/base/number_text.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::string_view kHeader =
    "move,line,kind,tool,state,depth,depth_upper,t,body,against,x,y,z,nx,ny,nz,"
    "mesh,triangle,operation,reason,clearance,overcut,overcut_upper\n";

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
  row.text(tool_key(*model.toolpath, move.tool));
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
  row.text(has_witness ? mesh_name(model, *verdict.witness) : std::string());
  row.text(has_witness ? std::to_string(verdict.witness->triangle) : std::string());
  row.text(operation_name(*model.toolpath, move.operation));
  row.text(verdict.reason);
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
