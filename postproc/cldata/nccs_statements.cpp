#include "postproc/cldata/nccs_statements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gouge {
namespace {

struct PostWord {
  std::uint16_t subclass;
  std::string_view name;
  Word word;
};

// Codes of the IBM table of words, which the files agree with. How their words are stored as arguments is not
// known, so those whose arguments could change where the tool is are motion that is not read.
constexpr auto kPostWords = std::to_array<PostWord>({
    {1, "END", Word::harmless},
    {2, "STOP", Word::harmless},
    {3, "OPSTOP", Word::harmless},
    {4, "ISTOP", Word::harmless},
    {5, "RAPID", Word::rapid},
    {7, "RETRCT", Word::retrct},
    {14, "GOHOME", Word::gohome},
    {1005, "TMARK", Word::harmless},
    {1006, "SWITCH", Word::harmless},
    {1007, "CUTCOM", Word::cutcom},
    {1009, "FEDRAT", Word::fedrat},
    {1010, "DELAY", Word::harmless},
    {1012, "OPSKIP", Word::harmless},
    {1013, "LEADER", Word::harmless},
    {1014, "GOHOME", Word::unread_motion},
    {1015, "MACHIN", Word::harmless},
    {1016, "MCHTOL", Word::harmless},
    {1019, "SEQNO", Word::harmless},
    {1021, "DISPLY", Word::harmless},
    {1022, "AUXFUN", Word::harmless},
    {1025, "TOOLNO", Word::toolno},
    {1026, "ROTABL", Word::unread_frame},
    {1027, "ORIGIN", Word::unread_frame},
    {1030, "COOLNT", Word::harmless},
    {1031, "SPINDL", Word::harmless},
    {1035, "ROTHED", Word::unread_frame},
    {1036, "THREAD", Word::unread_motion},
    {1037, "TRANS", Word::unread_frame},
    {1038, "TRACUT", Word::unread_frame},
    {1040, "COPY", Word::unread_frame},
    {1043, "LETTER", Word::free_text},
    {1044, "PPRINT", Word::pprint},
    {1045, "PARTNO", Word::free_text},
    {1046, "INSERT", Word::insert},
    {1048, "PREFUN", Word::harmless},
    {1054, "CYCLE", Word::unread_frame},
    {1055, "LOADTL", Word::loadtl},
    {1056, "SELCTL", Word::harmless},
    {1057, "CLRSRF", Word::harmless},
    {1058, "DWELL", Word::harmless},
    {1060, "CLAMP", Word::harmless},
    {1073, "LINTOL", Word::harmless},
});

constexpr std::uint16_t kPoints = 5, kMorePoints = 6, kFrom = 3, kStep = 4;
constexpr std::uint16_t kCutter = 6, kInnerTolerance = 4, kOuterTolerance = 5;
constexpr std::uint16_t kMultaxOn = 0, kMultaxOff = 1;

// Numbers that a CL file may hold; words and text read as a number are far from it.
bool is_plausible(double value) {
  const double size = std::abs(value);
  return size <= 1e9 && (size <= 0 || size >= 1e-30);
}

Word motion_word(std::uint16_t subclass) {
  switch (subclass) {
    case kPoints:
    case kMorePoints:
      return Word::go_to;
    case kFrom:
      return Word::from;
    case kStep:
      return Word::godlta;
    default:
      return Word::unread_motion;
  }
}

std::string_view motion_name(std::uint16_t subclass) {
  return subclass == kFrom ? "FROM" : subclass == kStep ? "GODLTA" : "GOTO";
}

}  // namespace

void NccsStatements::take_numbers(const NccsHeader& header, Statement& statement) {
  for (std::size_t i = 1; i < header.words; ++i) {
    const double value = words_.number(word_ + i);
    const std::string_view bytes = words_.bytes(word_ + i);
    statement.decoded.push_back({bytes, is_plausible(value) ? std::optional<double>(value) : std::nullopt});
  }
}

void NccsStatements::take_post(const NccsHeader& header, Statement& statement) {
  const auto* const it = std::find_if(kPostWords.begin(), kPostWords.end(),
                                      [&](const PostWord& w) { return w.subclass == header.subclass; });
  if (it == kPostWords.end()) {
    statement.major = "post-processor word";
    return;
  }
  statement.word = it->word;
  statement.major = it->name;
  const bool is_text = it->word == Word::pprint || it->word == Word::free_text || it->word == Word::insert;
  if (is_text && header.words > 1) {
    statement.pieces.front() = words_.bytes(word_ + 1);
  } else {
    take_numbers(header, statement);
  }
}

// CUTTER/d,r,h as programmed, or d,r,h,side angle. APT's d is where the flank meets the bottom plane; its
// ASCII twin shows it: 0.2,0.1,0.2,-89 is CUTTER/22.918,0.1,0,0.1,0,-89,0.2.
void NccsStatements::take_cutter(const NccsHeader& header, Statement& statement) {
  take_numbers(header, statement);
  const std::vector<Argument> given = statement.decoded;
  const bool is_known =
      (given.size() == 3 || given.size() == 4) &&
      std::all_of(given.begin(), given.end(), [](const Argument& a) { return a.number.has_value(); });
  statement.word = Word::cutter;
  statement.major = "CUTTER";
  if (!is_known) {
    statement.word = Word::unread_tool;
    return;
  }
  const double radius = *given[1].number;
  const double side_deg = given.size() == 4 ? *given[3].number : 0;
  const double e = *given[0].number / 2 - radius;
  const double side_rad = side_deg * std::numbers::pi / 180;
  const double d = std::abs(side_deg) > 0
                       ? 2 * (e + radius / std::cos(side_rad) - radius * std::tan(side_rad))
                       : *given[0].number;
  statement.decoded.clear();
  for (const double value : {d, radius, e, radius, 0.0, side_deg, *given[2].number})
    statement.decoded.push_back({given.front().text, value});
}

bool NccsStatements::next(Statement& statement) {
  if (is_over_ || word_ >= words_.words()) return false;
  const NccsHeader header = words_.header(word_);
  statement.clear();
  statement.line = ++record_;
  statement.first_byte = NccsWords::offset(word_);
  statement.last_byte = statement.first_byte + words_.bytes(word_).size();
  statement.is_decoded = true;
  statement.pieces.emplace_back();
  if (header.words == 0 || header.words > words_.words() - word_) {
    statement.is_unterminated = true;
    is_over_ = true;
    return true;
  }
  statement.last_byte = NccsWords::offset(word_ + header.words - 1) + words_.bytes(word_).size();
  statement.word = Word::harmless;
  switch (header.klass) {
    case NccsClass::kPost:
      statement.word = Word::unknown;
      take_post(header, statement);
      break;
    case NccsClass::kMotion:
      statement.word = motion_word(header.subclass);
      statement.major = motion_name(header.subclass);
      take_numbers(header, statement);
      break;
    case NccsClass::kCircle:
      statement.word = Word::circle;
      statement.major = "CIRCLE";
      take_numbers(header, statement);
      break;
    case NccsClass::kTool:
      if (header.subclass == kCutter)
        take_cutter(header, statement);
      else if (header.subclass != kInnerTolerance && header.subclass != kOuterTolerance)
        statement.major = "tool record";
      break;
    case NccsClass::kMode:
      statement.word = header.subclass <= kMultaxOff ? Word::multax : Word::unread_frame;
      statement.major = header.subclass <= kMultaxOff ? "MULTAX" : "mode record";
      if (header.subclass == kMultaxOff) statement.decoded.push_back({"OFF", std::nullopt});
      break;
    case NccsClass::kFini:
      statement.word = Word::fini;
      is_over_ = true;
      break;
    case NccsClass::kHeader:
    case NccsClass::kSourceLine:
    case NccsClass::kShownTool:
      break;
    default:
      statement.word = Word::unread_motion;
      statement.major = "record of an unknown class";
  }
  word_ += header.words;
  return true;
}

}  // namespace gouge
