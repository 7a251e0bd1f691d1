#include "tests/laws/expander_words.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace gouge::laws {
namespace {

constexpr std::array<std::string_view, 37> kMeaningful{
    "GOTO",   "GODLTA", "FROM",   "GOHOME", "CIRCLE", "MOVARC", "CYCLE",       "CUTCOM", "MULTAX",   "TLAXIS",
    "MSYS",   "MCS",    "MCSYS",  "UNITS",  "UNIT",   "LOADTL", "LOAD",        "TOOLNO", "CUTTER",   "TLDATA",
    "INDIRV", "TLON",   "NURBS",  "KNOT",   "CNTRL",  "TRANS",  "END-OF-PATH", "ORIGIN", "TOOLPATH", "ROTABL",
    "TRNTYP", "MODE",   "TRACUT", "COPY",   "SPLINE", "HELIX",  "TURRET"};

constexpr std::array<std::string_view, 43> kPassive{"RAPID",
                                                    "PRINT",
                                                    "FEDRAT",
                                                    "SPINDL",
                                                    "COOLNT",
                                                    "PAINT",
                                                    "MACHIN",
                                                    "INTOL",
                                                    "OUTTOL",
                                                    "AUTOPS",
                                                    "DELAY",
                                                    "STOP",
                                                    "OPSTOP",
                                                    "END",
                                                    "FINI",
                                                    "BEGIN",
                                                    "SELECT",
                                                    "BOX",
                                                    "MOVE_ATTRIB",
                                                    "OPNAME",
                                                    "MATERL",
                                                    "APPLY",
                                                    "TCP",
                                                    "REWIND",
                                                    "OPFEATSTART",
                                                    "OPFEATEND",
                                                    "ZERO",
                                                    "CSI_TOOL_PATH",
                                                    "SWITCH",
                                                    "PPFUN",
                                                    "CSYS",
                                                    "OSETNO",
                                                    "PPRINT",
                                                    "TPRINT",
                                                    "REMARK",
                                                    "PARTNO",
                                                    "INSERT",
                                                    "LETTER",
                                                    "CSI_SET_FLUTE_LENGTH",
                                                    "CSI_SET_EXTENSION_LENGTH",
                                                    "CSI_PATH_TOLERANCE",
                                                    "PPWORD",
                                                    "MFGNO"};

}  // namespace

bool is_one_letter_away(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1) return false;
  std::size_t i = 0;
  while (i < a.size() && a[i] == b[i]) ++i;
  if (a.size() < b.size()) return a.substr(i) == b.substr(i + 1);
  if (i == a.size()) return true;
  if (a.substr(i + 1) == b.substr(i + 1)) return true;
  return i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
}

bool is_all_numbers(const std::vector<LooseArgument>& arguments) {
  return std::all_of(arguments.begin(), arguments.end(), [](const LooseArgument& a) { return a.number.has_value(); });
}

bool is_meaningful(std::string_view word) {
  return std::find(kMeaningful.begin(), kMeaningful.end(), word) != kMeaningful.end();
}

bool is_passive(std::string_view word) { return std::find(kPassive.begin(), kPassive.end(), word) != kPassive.end(); }

bool is_naming(std::string_view word) {
  return word == "OPFEATSTART" || word == "OPFEATEND" || word == "CSI_TOOL_PATH" || word == "OPNAME" ||
         word == "TOOLPATH" || word == "MACHIN" || word == "MFGNO";
}

std::string_view meaning_within(std::string_view text) {
  for (const std::string_view word : kMeaningful) {
    if (word.size() > 4 || word == "GOTO") {
      // A block that is not closed is closed by the next one.
      const std::size_t at = word == "END-OF-PATH" ? std::string_view::npos : text.find(word);
      if (at == std::string_view::npos) continue;
      const std::string_view rest = text.substr(at + word.size());
      const bool is_position = word == "GOTO" || word == "GODLTA" || word == "FROM";
      if (rest.empty() || rest.front() == '/') return word;
      if (is_position && rest.find_first_of("+-.0123456789") == 0) return word;
    }
  }
  return {};
}

std::string_view meaning_before_blank(std::string_view text) {
  std::string_view found;
  for (const std::string_view word : kMeaningful) {
    if (text.starts_with(word) && word.size() > found.size()) found = word;
  }
  return found;
}

}  // namespace gouge::laws
