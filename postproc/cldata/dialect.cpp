#include "postproc/cldata/dialect.h"

#include <array>
#include <cstddef>
#include <vector>

#include "postproc/cldata/arguments.h"
#include "postproc/cldata/lexer.h"
#include "postproc/cldata/text.h"

namespace gouge {
namespace {

constexpr std::size_t kLinesLookedAt = 400;
constexpr std::size_t kStatementsLookedAt = 20000;

struct Mark {
  std::string_view text;  // in capitals, without blanks: how a line begins, or anywhere for comments
  DialectKind kind;
  bool is_anywhere = false;
};

// In order of trust: the first mark of the list that occurs in the file's first lines decides.
constexpr std::array<Mark, 20> kMarks = {{
    {"TOOLPATH/", DialectKind::nx_clsf},
    {"CATIAAPT", DialectKind::catia, true},
    {"$$*CATIA0", DialectKind::catia},
    {"PRO/CLFILE", DialectKind::creo, true},
    {"$$->", DialectKind::creo},
    {"NCLCAM", DialectKind::nccs, true},
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
  for (const char c : line.substr(0, 200)) {
    if (!is_blank(c)) result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return result;
}

std::size_t best_mark(std::string_view bytes) {
  std::size_t best = kMarks.size();
  for (std::size_t at = 0, lines = 0; at < bytes.size() && lines < kLinesLookedAt; ++lines) {
    const std::size_t end = bytes.find('\n', at);
    const std::string line = squeezed(bytes.substr(at, end - at));
    for (std::size_t i = 0; i < best; ++i) {
      const std::size_t found = line.find(kMarks[i].text);
      if (found == 0 || (kMarks[i].is_anywhere && found != std::string::npos)) best = i;
    }
    at = end == std::string_view::npos ? bytes.size() : end + 1;
  }
  return best;
}

bool is_position(Word word) {
  return word == Word::go_to || word == Word::from || word == Word::gohome || word == Word::tlon;
}

}  // namespace

Dialect recognise_dialect(std::string_view bytes) {
  const std::size_t mark = best_mark(bytes);
  switch (mark < kMarks.size() ? kMarks[mark].kind : DialectKind::apt) {
    case DialectKind::nx_clsf:
      return {DialectKind::nx_clsf, "nx-clsf", true, false, true};
    case DialectKind::solidworks_cam:
      return {DialectKind::solidworks_cam, "apt-solidworks-cam", false, true, true};
    case DialectKind::autodesk:
      return {DialectKind::autodesk, "apt-autodesk", false, true, false};
    case DialectKind::camplete:
      return {DialectKind::camplete, "apt-camplete", false, true, true};
    case DialectKind::catia:
      return {DialectKind::catia, "apt-catia", false, false, true};
    case DialectKind::creo:
      return {DialectKind::creo, "apt-creo", false, true, true};
    case DialectKind::nccs:
      return {DialectKind::nccs, "apt-nccs", false, false, false};
    case DialectKind::clt:
      return {DialectKind::clt, "camworks-clt", false, true, true};
    case DialectKind::mori:
      return {DialectKind::mori, "apt-mori", false, false, true};
    case DialectKind::apt:
      break;
  }
  return {};
}

UnitGuess find_unit(std::string_view bytes) {
  UnitGuess guess;
  Lexer lexer(bytes);
  Statement statement;
  std::vector<Argument> arguments;
  bool has_position = false;
  for (std::size_t i = 0; i < kStatementsLookedAt && lexer.next(statement); ++i) {
    if (is_position(statement.word)) {
      has_position = true;
      if (guess.source != UnitGuess::Source::assumed) return guess;
    }
    if (statement.word != Word::units && statement.word != Word::fedrat) continue;
    split_arguments(statement, arguments);
    for (const Argument& argument : arguments) {
      if (statement.word == Word::units && !has_position) {
        if (const auto unit = unit_of_word(argument.text)) return {*unit, UnitGuess::Source::stated};
      } else if (statement.word == Word::fedrat && guess.source == UnitGuess::Source::assumed) {
        if (const auto unit = unit_of_feed_word(argument.text)) guess = {*unit, UnitGuess::Source::feed_word};
      }
    }
  }
  return guess;
}

std::optional<LengthUnit> unit_of_word(std::string_view word) {
  for (const std::string_view mm : {"MM", "MMS", "MILLIMETER", "MILLIMETERS", "METRIC"}) {
    if (equals_ignoring_case(word, mm)) return LengthUnit::mm;
  }
  for (const std::string_view inch : {"IN", "INCH", "INCHES"}) {
    if (equals_ignoring_case(word, inch)) return LengthUnit::inch;
  }
  return std::nullopt;
}

std::optional<LengthUnit> unit_of_feed_word(std::string_view word) {
  if (equals_ignoring_case(word, "MMPM") || equals_ignoring_case(word, "MMPR")) return LengthUnit::mm;
  for (const std::string_view inch : {"IPM", "IPR", "FPM", "FPR"}) {
    if (equals_ignoring_case(word, inch)) return LengthUnit::inch;
  }
  return std::nullopt;
}

}  // namespace gouge
