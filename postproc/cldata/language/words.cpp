#include "postproc/cldata/language/words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

using Entry = std::pair<std::string_view, Word>;

constexpr auto kWords = std::to_array<Entry>({
    {"AIR", Word::harmless},
    {"APPLY", Word::harmless},
    {"ARCSLP", Word::harmless},
    {"AUTOPS", Word::harmless},
    {"AUXFUN", Word::auxfun},
    {"BEGIN", Word::harmless},
    {"BOX", Word::harmless},
    {"BREAK", Word::harmless},
    {"BSPLIN", Word::curve},
    {"CALL", Word::part_program},
    {"CALSUB", Word::repeat},
    {"CAMERA", Word::camera},
    {"CIRCLE", Word::circle},
    {"CLAMP", Word::harmless},
    {"CLEARP", Word::harmless},
    {"CLPRNT", Word::harmless},
    {"CLRSRF", Word::harmless},
    {"CNTRL", Word::cntrl},
    {"COOLNT", Word::harmless},
    {"COORD", Word::unread_frame},
    {"COPY", Word::repeat},
    {"COUPLE", Word::unread_frame},
    {"CSI_PATH_TOLERANCE", Word::harmless},
    {"CSI_SET_EXTENSION_LENGTH", Word::harmless},
    {"CSI_SET_FLUTE_LENGTH", Word::flute_length},
    {"CSI_TOOL_PATH", Word::operation},
    {"CSYS", Word::csys},
    {"CUTCOM", Word::cutcom},
    {"CUTTER", Word::cutter},
    {"CYCLE", Word::cycle},
    {"DEFSUB", Word::unread_frame},
    {"DELAY", Word::harmless},
    {"DISPLY", Word::harmless},
    {"DNTCUT", Word::part_program},
    {"DO", Word::part_program},
    {"DWELL", Word::harmless},
    {"END", Word::fini},
    {"END-OF-PATH", Word::end_of_path},
    {"ENDSUB", Word::unread_frame},
    {"FEDRAT", Word::fedrat},
    {"FINI", Word::fini},
    {"FLUSH", Word::harmless},
    {"FROM", Word::from},
    {"GO", Word::part_program},
    {"GOBACK", Word::part_program},
    {"GOCLER", Word::retrct},
    {"GODLTA", Word::godlta},
    {"GODOWN", Word::part_program},
    {"GOFWD", Word::part_program},
    {"GOHOME", Word::gohome},
    {"GOLFT", Word::part_program},
    {"GORGT", Word::part_program},
    {"GOTO", Word::go_to},
    {"GOUP", Word::part_program},
    {"HELIX", Word::curve},
    {"HOME", Word::unread_motion},
    {"IF", Word::part_program},
    {"INCLUD", Word::unread_motion},
    {"INCLUDE", Word::unread_motion},
    {"INDEX", Word::part_program},
    {"INDIRP", Word::part_program},
    {"INDIRV", Word::indirv},
    {"INSERT", Word::insert},
    {"INTOL", Word::harmless},
    {"JUMPTO", Word::part_program},
    {"KNOT", Word::knot},
    {"LEADER", Word::harmless},
    {"LETTER", Word::free_text},
    {"LINTOL", Word::harmless},
    {"LOAD", Word::load},
    {"LOADTL", Word::loadtl},
    {"LOOPND", Word::part_program},
    {"LOOPST", Word::part_program},
    {"MACHIN", Word::harmless},
    {"MACRO", Word::part_program},
    {"MATERL", Word::harmless},
    {"MCHTOL", Word::harmless},
    {"MCS", Word::mcs},
    {"MCSYS", Word::mcsys},
    {"MIRROR", Word::unread_frame},
    {"MODE", Word::mode},
    {"MOVARC", Word::movarc},
    {"MOVE_ATTRIB", Word::harmless},
    {"MSYS", Word::msys},
    {"MULTAX", Word::multax},
    {"NOPOST", Word::harmless},
    {"NURBS", Word::nurbs},
    {"OPFEATEND", Word::free_text},
    {"OPFEATSTART", Word::operation},
    {"OPNAME", Word::operation},
    {"OPSKIP", Word::harmless},
    {"OPSTOP", Word::harmless},
    {"ORIGIN", Word::trans},
    {"OUTTOL", Word::harmless},
    {"PAINT", Word::harmless},
    {"PARTNO", Word::free_text},
    {"PITCH", Word::harmless},
    {"POCKET", Word::part_program},
    {"POSITN", Word::unread_motion},
    {"PPFUN", Word::harmless},
    {"PPRINT", Word::pprint},
    {"PPWORD", Word::ppword},
    {"PREFUN", Word::prefun},
    {"PRINT", Word::harmless},
    {"PSIS", Word::part_program},
    {"RAPID", Word::rapid},
    {"REFSYS", Word::unread_frame},
    {"REMARK", Word::free_text},
    {"RESERV", Word::part_program},
    {"RETRCT", Word::retrct},
    {"REVERS", Word::unread_frame},
    {"REWIND", Word::harmless},
    {"ROTABL", Word::rotabl},
    {"ROTATE", Word::rotabl},
    {"ROTHED", Word::rotabl},
    {"SCALE", Word::unread_frame},
    {"SELCTL", Word::harmless},
    {"SELECT", Word::select},
    {"SEQNO", Word::harmless},
    {"SETUP", Word::setup},
    {"SPINDL", Word::harmless},
    {"SPLINE", Word::curve},
    {"STOP", Word::harmless},
    {"SWITCH", Word::harmless},
    {"SYN", Word::syn},
    {"TCP", Word::harmless},
    {"THREAD", Word::curve},
    {"TITLES", Word::free_text},
    {"TLAXIS", Word::tlaxis},
    {"TLDATA", Word::tldata},
    {"TLLFT", Word::part_program},
    {"TLOFPS", Word::part_program},
    {"TLON", Word::tlon},
    {"TLONPS", Word::part_program},
    {"TLRGT", Word::part_program},
    {"TMARK", Word::harmless},
    {"TOLER", Word::harmless},
    {"TOOLNO", Word::toolno},
    {"TOOLPATH", Word::tool_path},
    {"TPRINT", Word::tprint},
    {"TRACUT", Word::unread_frame},
    {"TRANS", Word::trans},
    {"TRANTO", Word::part_program},
    {"TRNTYP", Word::trntyp},
    {"TURRET", Word::turret},
    {"UNIT", Word::units},
    {"UNITS", Word::units},
    {"UNLOAD", Word::harmless},
    {"WORKPL", Word::unread_frame},
    {"ZERO", Word::setup},
    {"ZSURF", Word::part_program},
});

static_assert(std::is_sorted(kWords.begin(), kWords.end(),
                             [](const Entry& a, const Entry& b) { return a.first < b.first; }));

// Of those that never begin a statement the ones that matter to motion.
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

// "TOOL PATH", with as many blanks as there are.
std::size_t tool_path_length(std::string_view line) {
  constexpr std::string_view kTool = "TOOL", kPath = "PATH";
  if (!starts_with_ignoring_case(line, kTool)) return 0;
  std::size_t at = kTool.size();
  while (at < line.size() && is_blank(line[at])) ++at;
  if (!starts_with_ignoring_case(line.substr(at), kPath)) return 0;
  at += kPath.size();
  return at == line.size() || !is_major_character(line[at]) ? at : 0;
}

// "GOTO" before "GOTO(0" and "GODLTA" before "GODLTA-50.": what follows is no part of a longer word.
bool is_glued_to(std::string_view word, std::string_view major) {
  if (word.empty() || major.size() <= word.size() || !starts_with_ignoring_case(major, word)) return false;
  const char next = major[word.size()];
  if (is_letter(next)) return is_minor_word(major.substr(word.size()));  // "CYCLEOFF"
  if (next != '-') return next != '_';
  const std::string_view rest = major.substr(word.size() + 1);
  return !rest.empty() && (is_digit(rest.front()) || rest.front() == '.');
}

// Short words are too near to others, such as MODE to MODEL, but where a character is missing.
bool may_be_misspelt(const Entry& entry, std::string_view major) {
  constexpr std::size_t kLong = 5;
  if (!changes_motion(entry.second)) return false;
  if (entry.first.size() >= kLong || entry.second == Word::go_to || entry.second == Word::from) return true;
  return entry.first.size() + 1 == kLong && major.size() < entry.first.size();
}

}  // namespace

bool is_minor_word(std::string_view word) {
  return std::any_of(kMinorWords.begin(), kMinorWords.end(),
                     [&](std::string_view minor) { return equals_ignoring_case(minor, word); });
}

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
  static constexpr WordSet kOthers = {Word::comment,      Word::unknown, Word::harmless, Word::free_text,
                                      Word::pprint,       Word::insert,  Word::tprint,   Word::operation,
                                      Word::part_program, Word::fedrat,  Word::fini,     Word::flute_length};
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

Word find_word(std::string_view major) {
  const auto* const it = std::lower_bound(kWords.begin(), kWords.end(), major, [](const Entry& e, std::string_view m) {
    return compare_ignoring_case(e.first, m) < 0;
  });
  if (it == kWords.end() || compare_ignoring_case(it->first, major) != 0) return Word::unknown;
  return it->second;
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

}  // namespace gouge
