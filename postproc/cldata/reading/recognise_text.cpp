#include "postproc/cldata/reading/recognise_text.h"

#include <array>
#include <cstddef>
#include <string>

#include "lib/base/letters.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kDialectLines = 400;
constexpr std::size_t kBytesOfLineLookedAt = 200;

enum class Where {
  line_start,
  in_comment,
  at_start,        // in one of the first two lines: Autodesk's posts state the mode there, after a MACHIN
  without_partno,  // only in files without a PARTNO, which NX never writes
};

struct Mark {
  std::string_view text;  // in capitals, without blanks
  DialectKind kind;
  Where where = Where::line_start;
  DialectKind also = kind;           // another dialect whose files have it, besides marks of their own
  std::string_view other_text = {};  // a longer text, which is no such mark
};

// In order of reliability: the first mark of this list that occurs in the file's first lines decides.
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
    {"MOVARC/", DialectKind::autodesk, Where::line_start, DialectKind::autodesk, "MOVARC/CENTER"},
    {"MODE/MILL", DialectKind::autodesk, Where::at_start, DialectKind::camplete},
    {"OPNAME/", DialectKind::mori},
    {"TLDATA/", DialectKind::nx_clsf, Where::without_partno},
    {"END-OF-PATH", DialectKind::nx_clsf, Where::without_partno},
    {"PAINT/", DialectKind::nx_clsf, Where::without_partno},
    {"MSYS/", DialectKind::nx_clsf, Where::without_partno},
}};

std::string squeezed(std::string_view line) {
  std::string result;
  for (const char c : line.substr(0, kBytesOfLineLookedAt)) {
    if (!is_blank(c)) result += capital(c);
  }
  return result;
}

bool has_mark(const std::string& line, const Mark& mark) {
  if (!mark.other_text.empty() && line.starts_with(mark.other_text)) return false;
  if (mark.where != Where::in_comment) return line.starts_with(mark.text);
  const bool is_comment = line.starts_with("$$") || line.starts_with("REMARK");
  return is_comment && line.find(mark.text) != std::string::npos;
}

struct FirstLines {
  std::array<std::size_t, kMarks.size()> first_line{};  // line of each mark, counted from 1; 0: none
  std::size_t partno = 0;                               // line of the first PARTNO
  std::size_t gotos = 0, others = 0;
};

bool counts(const FirstLines& found, std::size_t mark) {
  const std::size_t line = found.first_line[mark];
  if (kMarks[mark].where == Where::at_start) return line > 0 && line <= 2;
  if (kMarks[mark].where == Where::without_partno) return line > 0 && found.partno == 0;
  return line > 0;
}

FirstLines look_at(std::string_view bytes) {
  FirstLines found;
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kDialectLines; ++lines) {
    const std::size_t end = bytes.find('\n', at);
    const std::string line = squeezed(bytes.substr(at, end - at));
    for (std::size_t i = 0; i < kMarks.size(); ++i) {
      if (found.first_line[i] == 0 && has_mark(line, kMarks[i])) found.first_line[i] = lines + 1;
    }
    if (found.partno == 0 && line.starts_with("PARTNO")) found.partno = lines + 1;
    if (line.starts_with("GOTO/")) {
      ++found.gotos;
    } else if (!line.empty()) {
      ++found.others;
    }
    at = end == std::string_view::npos ? bytes.size() : end + 1;
  }
  return found;
}

// Notes the first mark of another dialect. No known writer has marks of two.
Dialect with_other_mark(Dialect dialect, const FirstLines& found) {
  for (std::size_t i = 0; i < kMarks.size(); ++i) {
    if (kMarks[i].kind == dialect.kind || kMarks[i].also == dialect.kind || !counts(found, i)) continue;
    if (dialect.other_line > 0 && found.first_line[i] >= dialect.other_line) continue;
    dialect.other_id = dialect_of(kMarks[i].kind).id;
    dialect.other_line = found.first_line[i];
  }
  return dialect;
}

}  // namespace

Dialect recognise_text(std::string_view bytes) {
  const FirstLines found = look_at(bytes);
  for (std::size_t i = 0; i < kMarks.size(); ++i) {
    if (counts(found, i)) return with_other_mark(dialect_of(kMarks[i].kind), found);
  }
  return dialect_of(found.gotos > 0 && found.others == 0 ? DialectKind::goto_list : DialectKind::apt);
}

}  // namespace gouge
