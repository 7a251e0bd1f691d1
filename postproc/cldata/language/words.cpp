#include "postproc/cldata/language/words.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "postproc/cldata/language/harmless_words.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

namespace {

using Entry = std::pair<std::string_view, Word>;

// Words of the APT source language.
constexpr auto kOfPrograms = std::to_array<std::string_view>(
    {"CALL",   "DNTCUT", "DO",     "GO",     "GOBACK", "GODOWN", "GOFWD", "GOLFT",  "GORGT",
     "GOUP",   "IF",     "INDIRP", "JUMPTO", "LOOPND", "LOOPST", "MACRO", "POCKET", "PSIS",
     "RESERV", "TLLFT",  "TLOFPS", "TLONPS", "TLRGT",  "TRANTO", "ZSURF"});
// Words that may turn or shift later positions.
constexpr auto kOfFrames = std::to_array<std::string_view>(
    {"COORD", "COUPLE", "DEFSUB", "ENDSUB", "MIRROR", "REFSYS", "REVERS", "SCALE", "TRACUT", "WORKPL"});

constexpr auto kOthers = std::to_array<Entry>({
    {"ARC", Word::arc_record},
    {"ARCSLP", Word::arc_slope},
    {"AUXFUN", Word::auxfun},
    {"BSPLIN", Word::curve},
    {"CALSUB", Word::repeat},
    {"CAMERA", Word::camera},
    {"CIRCLE", Word::circle},
    {"CLEARP", Word::clear_plane},
    {"CNTRL", Word::cntrl},
    {"COPY", Word::copy},
    {"CSI_INSERT_CUSTOM_GCODE", Word::insert},
    {"CSI_SET_EXTENSION_LENGTH", Word::extension_length},
    {"CSI_SET_FLUTE_LENGTH", Word::flute_length},
    {"CSI_TOOL_PATH", Word::operation},
    {"CSYS", Word::csys},
    {"CUTCOM", Word::cutcom},
    {"CUTTER", Word::cutter},
    {"CYCLE", Word::cycle},
    {"DELETE", Word::opskip},
    {"END", Word::fini},
    {"END-OF-PATH", Word::end_of_path},
    {"FEDRAT", Word::fedrat},
    {"FINI", Word::fini},
    {"FROM", Word::from},
    {"GOCLER", Word::retrct},
    {"GODLTA", Word::godlta},
    {"GOHOME", Word::gohome},
    {"GOTO", Word::go_to},
    {"HELICAL", Word::helical},
    {"HELIX", Word::curve},
    {"HOME", Word::unread_motion},
    {"INCLUD", Word::unread_motion},
    {"INCLUDE", Word::unread_motion},
    {"INDEX", Word::index},
    {"INDIRV", Word::indirv},
    {"INSERT", Word::insert},
    {"KNOT", Word::knot},
    {"LETTER", Word::free_text},
    {"LOAD", Word::load},
    {"LOADTL", Word::loadtl},
    {"MCS", Word::mcs},
    {"MCSYS", Word::mcsys},
    {"MODE", Word::mode},
    {"MOVARC", Word::movarc},
    {"MOVNRB", Word::movnrb},
    {"MSYS", Word::msys},
    {"MULTAX", Word::multax},
    {"NURBS", Word::nurbs},
    {"OPFEATEND", Word::free_text},
    {"OPFEATSTART", Word::operation},
    {"OPNAME", Word::operation},
    {"OPSKIP", Word::opskip},
    {"ORIGIN", Word::trans},
    {"PARTNO", Word::free_text},
    {"POSITN", Word::unread_motion},
    {"PPRINT", Word::pprint},
    {"PPWORD", Word::ppword},
    {"PREFUN", Word::prefun},
    {"RAPID", Word::rapid},
    {"REMARK", Word::free_text},
    {"RETRCT", Word::retrct},
    {"ROTABL", Word::rotabl},
    {"ROTATE", Word::rotabl},
    {"ROTHED", Word::rotabl},
    {"SELECT", Word::select},
    {"SETUP", Word::setup},
    {"SKIP", Word::opskip},
    {"SPLINE", Word::curve},
    {"SWITCH", Word::turret},  // the point of a turning tool
    {"SYN", Word::syn},
    {"THREAD", Word::curve},
    {"TITLES", Word::free_text},
    {"TLAXIS", Word::tlaxis},
    {"TLDATA", Word::tldata},
    {"TLON", Word::tlon},
    {"TOOLNO", Word::toolno},
    {"TOOLPATH", Word::tool_path},
    {"TPRINT", Word::tprint},
    {"TRANS", Word::trans},
    {"TRNTYP", Word::trntyp},
    {"TURRET", Word::turret},
    {"UNIT", Word::units},
    {"UNITS", Word::units},
    {"ZERO", Word::setup},
});

constexpr std::size_t kWordCount = kOfPrograms.size() + kOfFrames.size() + kOthers.size();

// All words except the harmless ones, sorted.
constexpr std::array<Entry, kWordCount> kWords = [] {
  std::array<Entry, kWordCount> all;
  std::size_t count = 0;
  const auto add = [&](std::span<const std::string_view> names, Word word) {
    for (const std::string_view name : names) all[count++] = {name, word};
  };
  add(kOfPrograms, Word::part_program);
  add(kOfFrames, Word::unread_frame);
  std::copy(kOthers.begin(), kOthers.end(), all.begin() + count);
  std::sort(all.begin(), all.end(), [](const Entry& a, const Entry& b) { return a.first < b.first; });
  return all;
}();

// Words that never begin a statement but are important for motion.
constexpr auto kMinorWords =
    std::to_array<std::string_view>({"AAXIS",  "ADJUST", "ANGLE",  "ATANGL", "BAXIS",     "BORE",  "BRKCHP",
                                     "CAXIS",  "CCLW",   "CENTER", "CLEAR",  "CLOCKWISE", "CLW",   "COUNTERCLOCKWISE",
                                     "DEEP",   "DEPTH",  "DRILL",  "FEDTO",  "INCHES",    "INCR",  "IPM",
                                     "IPR",    "LEFT",   "MILL",   "MM",     "MMPM",      "MMPR",  "NOMORE",
                                     "OFF",    "ON",     "RAPTO",  "REAM",   "RETURN",    "RIGHT", "RPM",
                                     "RTRCTO", "STEP",   "TAP",    "TIMES",  "TRANSL",    "TURN",  "WORLD",
                                     "XYPLAN", "YZPLAN", "ZXPLAN"});

constexpr std::array<std::string_view, 6> kSixLetterTexts = {"INSERT", "LETTER", "PARTNO",
                                                             "PPRINT", "REMARK", "TPRINT"};
constexpr std::array<std::string_view, 5> kWholeWordTexts = {"CSI_TOOL_PATH", "OPFEATEND", "OPFEATSTART", "OPNAME",
                                                             "TITLES"};

bool is_major_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

// Returns the length of "TOOL PATH" with any number of blanks between the words.
std::size_t tool_path_length(std::string_view line) {
  constexpr std::string_view kTool = "TOOL", kPath = "PATH";
  if (!starts_with_ignoring_case(line, kTool)) return 0;
  std::size_t at = kTool.size();
  while (at < line.size() && is_blank(line[at])) ++at;
  if (!starts_with_ignoring_case(line.substr(at), kPath)) return 0;
  at += kPath.size();
  return at == line.size() || !is_major_character(line[at]) ? at : 0;
}

// Returns whether a word is joined to other text: "GOTO" in "GOTO(0", "GODLTA" in "GODLTA-50.". The rest must not
// belong to a longer word.
bool is_glued_to(std::string_view word, std::string_view major) {
  if (word.empty() || major.size() <= word.size() || !starts_with_ignoring_case(major, word)) return false;
  const char next = major[word.size()];
  if (is_letter(next)) return is_minor_word(major.substr(word.size()));  // "CYCLEOFF"
  if (next != '-') return next != '_';
  const std::string_view rest = major.substr(word.size() + 1);
  return !rest.empty() && (is_digit(rest.front()) || rest.front() == '.');
}

// Returns whether a word may be misspelt as `major`. A short word may only lack a character, because other errors make
// it similar to other words, such as MODE and MODEL.
bool may_be_misspelt(const Entry& entry, std::string_view major) {
  constexpr std::size_t kLong = 5;
  if (!changes_motion(entry.second)) return false;
  if (entry.first.size() >= kLong || entry.second == Word::go_to || entry.second == Word::from) return true;
  return entry.first.size() + 1 == kLong && major.size() < entry.first.size();
}

}  // namespace

bool is_minor_word(std::string_view word) { return is_one_of(word, kMinorWords); }

Word find_word_at_end(std::string_view token) {
  constexpr std::size_t kLong = 4;
  const Entry* found = nullptr;
  for (const Entry& entry : kWords) {
    const std::size_t size = entry.first.size();
    if (size < kLong || size >= token.size() || (found != nullptr && size < found->first.size())) continue;
    if (changes_motion(entry.second) && equals_ignoring_case(entry.first, token.substr(token.size() - size)))
      found = &entry;
  }
  return found == nullptr ? Word::unknown : found->second;
}

bool changes_motion(Word word) {
  static constexpr WordSet kOthers = {Word::comment,     Word::unknown,   Word::harmless,     Word::free_text,
                                      Word::clear_plane, Word::arc_slope, Word::index,        Word::pprint,
                                      Word::insert,      Word::tprint,    Word::operation,    Word::part_program,
                                      Word::fedrat,      Word::fini,      Word::flute_length, Word::extension_length};
  return !kOthers.has(word);
}

Word find_intended_word(std::string_view major) {
  const Entry* found = nullptr;
  for (const Entry& entry : kWords) {
    const bool is_longer = found == nullptr || entry.first.size() > found->first.size();
    if (is_longer && changes_motion(entry.second) && is_glued_to(entry.first, major)) found = &entry;
  }
  if (found != nullptr) return found->second;
  for (const Entry& entry : kWords) {
    if (may_be_misspelt(entry, major) && is_one_letter_off(entry.first, major)) return entry.second;
  }
  return Word::unknown;
}

std::string_view similar_word(std::string_view major) {
  constexpr std::size_t kLong = 5;
  if (major.size() < kLong || find_word(major) != Word::unknown) return {};
  for (const Entry& entry : kWords) {
    if (entry.first.size() >= kLong && is_one_letter_off(entry.first, major)) return entry.first;
  }
  for (const HarmlessWord& row : harmless_words()) {
    if (row.word.size() >= kLong && is_one_letter_off(row.word, major)) return row.word;
  }
  return {};
}

Word find_word(std::string_view major) {
  const auto* const it = std::lower_bound(kWords.begin(), kWords.end(), major, [](const Entry& e, std::string_view m) {
    return compare_ignoring_case(e.first, m) < 0;
  });
  if (it != kWords.end() && compare_ignoring_case(it->first, major) == 0) return it->second;
  return find_harmless_word(major) == nullptr ? Word::unknown : Word::harmless;
}

std::size_t free_text_word_length(std::string_view line) {
  if (line.empty() || line[0] == 'G' || line[0] == 'g') return 0;
  for (const std::string_view word : kSixLetterTexts) {
    if (starts_with_ignoring_case(line, word)) return word.size();
  }
  for (const std::string_view word : kWholeWordTexts) {
    if (starts_with_ignoring_case(line, word) &&
        (line.size() == word.size() || !is_major_character(line[word.size()]))) {
      return word.size();
    }
  }
  return tool_path_length(line);
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
  for (const std::string_view mm : {"MMPM", "MMPR"}) {
    if (equals_ignoring_case(word, mm)) return LengthUnit::mm;
  }
  for (const std::string_view inch : {"IPM", "IPR", "FPM", "FPR"}) {
    if (equals_ignoring_case(word, inch)) return LengthUnit::inch;
  }
  return std::nullopt;
}

}  // namespace gouge
