#include "postproc/cldata/reading/recognise_dialect.h"

#include <array>
#include <cstddef>
#include <string>

#include "postproc/cldata/language/text.h"
#include "postproc/cldata/nccs/nccs_records.h"
#include "postproc/cldata/nci/nci_lines.h"

namespace gouge {
namespace {

constexpr std::size_t kDialectLines = 400;
constexpr std::size_t kBytesOfLineLookedAt = 200;

enum class Where { line_start, in_comment };

struct Mark {
  std::string_view text;  // in capitals, without blanks
  DialectKind kind;
  Where where = Where::line_start;
};

// In order of trust: the first mark of the list that occurs in the file's first lines decides.
constexpr std::array<Mark, 21> kMarks = {{
    {"TOOLPATH/", DialectKind::nx_clsf},
    {"CATIAAPT", DialectKind::catia, Where::in_comment},
    {"$$*CATIA0", DialectKind::catia},
    {"PRO/CLFILE", DialectKind::creo, Where::in_comment},
    {"$$->", DialectKind::creo},
    {"REMARK->", DialectKind::creo},
    {"NCLCAM", DialectKind::nccs, Where::in_comment},
    {"OPFEATSTART/", DialectKind::clt},
    {"MCSYS/", DialectKind::mori},
    {"CSI_TOOL_PATH/", DialectKind::camplete},
    {"MCS/", DialectKind::camplete},
    {"TRNTYP/", DialectKind::solidworks_cam},
    {"CSI_SET_EXTENSION_LENGTH/", DialectKind::solidworks_cam},
    {"MOVARC/CENTER", DialectKind::mori},
    {"MOVARC/", DialectKind::autodesk},
    {"MODE/MILL", DialectKind::autodesk},
    {"OPNAME/", DialectKind::mori},
    {"TLDATA/", DialectKind::nx_clsf},
    {"END-OF-PATH", DialectKind::nx_clsf},
    {"PAINT/", DialectKind::nx_clsf},
    {"MSYS/", DialectKind::nx_clsf},
}};

std::string squeezed(std::string_view line) {
  std::string result;
  for (const char c : line.substr(0, kBytesOfLineLookedAt)) {
    if (!is_blank(c)) result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return result;
}

bool has_mark(const std::string& line, const Mark& mark) {
  if (mark.where == Where::line_start) return line.starts_with(mark.text);
  const bool is_comment = line.starts_with("$$") || line.starts_with("REMARK");
  return is_comment && line.find(mark.text) != std::string::npos;
}

struct FirstLines {
  std::size_t best_mark = kMarks.size();
  std::size_t gotos = 0, others = 0;
};

FirstLines look_at(std::string_view bytes) {
  FirstLines found;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kDialectLines; ++lines) {
    const std::size_t end = bytes.find('\n', at);
    const std::string line = squeezed(bytes.substr(at, end - at));
    for (std::size_t i = 0; i < found.best_mark; ++i) {
      if (has_mark(line, kMarks[i])) found.best_mark = i;
    }
    if (line.starts_with("GOTO/")) {
      ++found.gotos;
    } else if (!line.empty()) {
      ++found.others;
    }
    at = end == std::string_view::npos ? bytes.size() : end + 1;
  }
  return found;
}

}  // namespace

Dialect recognise_dialect(std::string_view bytes) {
  if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
  if (is_nccs_binary(bytes)) return dialect_of(DialectKind::nccs_binary);
  if (is_nci(bytes)) return dialect_of(DialectKind::nci);
  const FirstLines found = look_at(bytes);
  if (found.best_mark < kMarks.size()) return dialect_of(kMarks[found.best_mark].kind);
  return dialect_of(found.gotos > 0 && found.others == 0 ? DialectKind::goto_list : DialectKind::apt);
}

}  // namespace gouge
