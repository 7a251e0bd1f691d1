#include "postproc/report/write_report.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

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

// Text from a file, which somebody else may have written for the spreadsheet that opens ours: an apostrophe in front of
// what may be a formula, also behind the separators of other locales, where a row is split at semicolons, tabs and line
// ends without regard to quotes that begin within it.
std::string without_formula(std::string_view text) {
  if (text.empty() || parse_number(text)) return std::string(text);
  std::string out;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool begins_cell = at == 0 || std::string_view(";\t\r\n").find(text[at - 1]) != std::string_view::npos;
    if (begins_cell && may_be_formula(text.substr(at))) out += '\'';
    out += text[at];
  }
  return out;
}

/// Appends one row to a text.
class Row {
 public:
  explicit Row(std::string& out) : out_(out) {}
  ~Row() { out_ += '\n'; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  /// A word of our own, which needs no quotes.
  void word(std::string_view value) {
    begin_cell();
    out_ += value;
  }
  void text(std::string_view value) {
    if (value.find_first_of(",\"\r\n") == std::string_view::npos) return word(value);
    begin_cell();
    out_ += '"';
    for (const char c : value) {
      out_ += c;
      if (c == '"') out_ += '"';
    }
    out_ += '"';
  }
  // A bound that was never reached is no number, and a row has no word for it.
  void number(double value) { std::isfinite(value) ? word(exact_text(value)) : word({}); }
  void count(std::size_t value) {
    std::array<char, 24> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    word({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }
  void empty(int count) {
    for (int i = 0; i < count; ++i) word({});
  }

 private:
  void begin_cell() {
    if (!is_first_) out_ += ',';
    is_first_ = false;
  }

  std::string& out_;
  bool is_first_ = true;
};

void add_witness(Row& row, const Witness& witness, LengthUnit unit) {
  row.number(witness.t);
  row.word(body_name(witness.body));
  row.word(against_name(witness.against));
  for (int k = 0; k < 3; ++k) row.number(witness.point[k] / mm_per(unit));
  for (int k = 0; k < 3; ++k) row.number(witness.normal[k]);
}

/// Texts of the toolpath as they stand in cells, each made once.
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
  const auto length = [unit](Row& row, double mm) { row.number(mm / mm_per(unit)); };
  Row row(out);
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
  if (verdict.overcut_mm) {
    length(row, *verdict.overcut_mm);
    length(row, verdict.overcut_upper_mm);
  } else {
    row.empty(2);
  }
}

}  // namespace

std::string write_csv(const ReportModel& model) {
  const PathCells cells(*model.toolpath);
  std::string text(kHeader);
  for (std::size_t i = 0; i < model.result->verdicts.size(); ++i) add_row(model, cells, i, text);
  return text;
}

}  // namespace gouge
