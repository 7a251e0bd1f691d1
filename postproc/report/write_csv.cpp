#include "postproc/report/write_report.h"

#include <string_view>
#include <vector>

#include "lib/base/number_text.h"
#include "postproc/report/csv_row.h"
#include "postproc/report/report_text.h"

namespace gouge {
namespace {

constexpr std::string_view kHeader =
    "move,line,kind,tool,state,depth,depth_upper,t,body,against,x,y,z,nx,ny,nz,mesh,triangle,operation,reason,"
    "clearance,overcut,overcut_upper\n";

void add_witness(CsvRow& row, const Witness& witness, LengthUnit unit) {
  row.number(witness.t);
  row.word(body_name(witness.body));
  row.word(against_name(witness.against));
  for (int k = 0; k < 3; ++k) row.number(witness.point[k] / mm_per(unit));
  for (int k = 0; k < 3; ++k) row.number(witness.normal[k]);
}

/// Texts of the toolpath in the form of cells; each is made once.
struct PathCells {
  explicit PathCells(const Toolpath& path) {
    for (std::size_t i = 0; i < path.tools.size(); ++i) tools.push_back(without_formula(tool_key(path, i)));
    for (const Operation& operation : path.operations) operations.push_back(without_formula(operation.name));
  }
  [[nodiscard]] static std::string_view at(const std::vector<std::string>& cells, std::size_t index) {
    return index < cells.size() ? std::string_view(cells[index]) : std::string_view();
  }

  std::vector<std::string> tools, operations;
};

void add_row(const ReportModel& model, const PathCells& cells, std::size_t index, std::string& out) {
  const Move& move = model.toolpath->moves[index];
  const MoveVerdict& verdict = model.result->verdicts[index];
  const LengthUnit unit = model.toolpath->unit;
  const auto length = [unit](CsvRow& row, double mm) { row.number(mm / mm_per(unit)); };
  CsvRow row(out);
  row.count(index);
  row.count(move.line);
  row.word(kind_name(move.kind));
  row.text(PathCells::at(cells.tools, move.tool));
  row.word(state_name(verdict.state));
  const bool has_depth = verdict.state != MoveState::buried && verdict.state != MoveState::not_checked;
  if (has_depth) {
    length(row, verdict.depth_mm);
    length(row, verdict.depth_upper_mm);
  } else {
    row.empty(2);
  }
  if (has_depth && verdict.depth_mm > 0 && verdict.witness) {
    add_witness(row, *verdict.witness, unit);
    row.text(without_formula(mesh_name(model, *verdict.witness)));
    row.count(verdict.witness->triangle);
  } else {
    row.empty(11);
  }
  row.text(PathCells::at(cells.operations, move.operation));
  row.text(without_formula(reason_text(verdict.reason)));
  verdict.clearance_mm ? length(row, *verdict.clearance_mm) : row.empty(1);
  if (verdict.overcut) {
    length(row, verdict.overcut->lower_mm);
    length(row, verdict.overcut->upper_mm);
  } else {
    row.empty(2);
  }
}

}  // namespace

std::string write_csv(const ReportModel& model) {
  std::string text;
  put_csv(model, [&](std::string_view part) { text += part; });
  return text;
}

void put_csv(const ReportModel& model, const PutText& put) {
  constexpr std::size_t kPart = std::size_t{1} << 20U;
  const PathCells cells(*model.toolpath);
  std::string text(kHeader);
  for (std::size_t i = 0; i < model.result->verdicts.size(); ++i) {
    add_row(model, cells, i, text);
    if (text.size() < kPart) continue;
    put(text);
    text.clear();
  }
  put(text);
}

}  // namespace gouge
