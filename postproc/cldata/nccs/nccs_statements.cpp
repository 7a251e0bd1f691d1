#include "postproc/cldata/nccs/nccs_statements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/post_words.h"

namespace gouge {
namespace {

constexpr std::uint16_t kMorePoints = 6, kFrom = 3, kStep = 4;
constexpr std::uint16_t kCutter = 6, kInnerTolerance = 4, kOuterTolerance = 5;
constexpr std::uint16_t kFirstText = 1043, kLastText = 1046, kOtherText = 1199;
constexpr std::size_t kTextLetters = 66;  // the rest of the record is not part of the text
constexpr std::size_t kCircleNumbers = 7;
// The numbers of a circle may follow five words about the kind of its geometry.
constexpr std::size_t kCircleWords = 12;

// An item that is neither a number nor a known word.
constexpr Argument kNotKnown = {"?", std::nullopt};

// Returns whether a CL file may contain this number. Words and text read as a number are far outside the range.
bool is_plausible(double value) {
  constexpr double kLargest = 1e9, kSmallest = 1e-30;
  const double size = std::abs(value);
  return size <= kLargest && (size <= 0 || size >= kSmallest);
}

Word motion_word(std::uint16_t subclass) {
  if (subclass == NccsSubclass::kPoints || subclass == kMorePoints) return Word::go_to;
  if (subclass == kFrom) return Word::from;
  return subclass == kStep ? Word::godlta : Word::unread_motion;
}

std::string_view motion_name(std::uint16_t subclass) {
  return subclass == kFrom ? "FROM" : subclass == kStep ? "GODLTA" : "GOTO";
}

bool is_text(std::uint16_t subclass) {
  return (subclass >= kFirstText && subclass <= kLastText) || subclass == kOtherText;
}

// Returns the word in text with the same meaning. It is not a word that can occur only in text.
Word post_word(const Statement& statement) {
  const Word word = find_word(statement.major);
  if (word == Word::part_program) return Word::unread_frame;
  if (word != Word::gohome || statement.decoded.empty()) return word;
  const bool is_position = find_word_argument(statement.decoded) == nullptr &&
                           (statement.decoded.size() == 3 || statement.decoded.size() == 6);
  return is_position ? word : Word::unread_motion;
}

}  // namespace

Argument NccsStatements::number_at(std::size_t index) const {
  const double value = words_.number(word_ + index);
  return is_plausible(value) ? Argument{words_.bytes(word_ + index), value} : kNotKnown;
}

Argument NccsStatements::argument_at(std::size_t index) const {
  const NccsHeader parts = words_.header(word_ + index);
  if (parts.sequence != 0 || parts.words == 0) return number_at(index);
  const std::string_view name = minor_of_code(parts.words);
  return name.empty() ? kNotKnown : Argument{name, std::nullopt};
}

// Returns the text of a record, as far as it is in one block.
std::string_view NccsStatements::text_of(const NccsHeader& header) const {
  std::size_t letters = 0;
  const std::size_t first = NccsWords::offset(word_ + 1);
  for (std::size_t i = 1; i < header.words && NccsWords::offset(word_ + i) == first + letters; ++i)
    letters += words_.bytes(word_ + i).size();
  return words_.bytes(word_ + 1, std::min(letters, kTextLetters));
}

void NccsStatements::take_post(const NccsHeader& header, Statement& statement) {
  if (is_text(header.subclass)) {
    statement.major = header.subclass == kOtherText ? "text" : major_of_code(header.subclass);
    statement.word = header.subclass == kOtherText ? Word::free_text : find_word(statement.major);
    if (header.words > 1) statement.pieces.front() = text_of(header);
    return;
  }
  statement.major = major_of_code(header.subclass);
  const bool is_harmless = find_word(statement.major) == Word::harmless;
  if (!is_harmless || statement.major == "SPINDL")
    for (std::size_t i = 1; i < header.words; ++i) statement.decoded.push_back(argument_at(i));
  statement.word = is_harmless ? Word::harmless : statement.major.empty() ? Word::unknown : post_word(statement);
  if (statement.major.empty()) statement.major = "post-processor word";
}

void NccsStatements::take_motion(const NccsHeader& header, Statement& statement) {
  statement.word = motion_word(header.subclass);
  statement.major = motion_name(header.subclass);
  statement.is_continuation = header.subclass == kMorePoints;
  for (std::size_t i = 1; i < header.words; ++i) statement.decoded.push_back(number_at(i));
}

// Takes expanded motion. Each point has its position, its axis and five more vectors, none of which is needed for the
// position of the tool.
void NccsStatements::take_expanded(const NccsHeader& header, Statement& statement) {
  statement.word = Word::unread_motion;
  statement.major = "expanded motion";
  const std::size_t count = header.words - std::size_t{1};
  const bool is_known_form = header.subclass == NccsSubclass::kPoints || header.subclass == kMorePoints;
  if (!is_known_form || count == 0 || count % kNccsExpandedWords != 0) return;
  for (std::size_t point = 1; point < header.words; point += kNccsExpandedWords) {
    const Vec3 axis(words_.number(word_ + point + 3), words_.number(word_ + point + 4),
                    words_.number(word_ + point + 5));
    // Without MULTAX the post-processor would ignore an axis other than +Z.
    const bool is_dropped = is_multax_off_ && (axis - Vec3::UnitZ()).norm() > Tolerance::kUnitVectorError;
    if (!(std::abs(axis.norm() - 1) <= Tolerance::kUnitVectorError) || is_dropped) {
      statement.decoded.clear();
      return;
    }
    for (std::size_t i = 0; i < 6; ++i) statement.decoded.push_back(number_at(point + i));
  }
  statement.word = Word::go_to;
  statement.major = "GOTO";
  statement.has_axes = true;
  statement.is_continuation = header.subclass == kMorePoints;
}

void NccsStatements::take_circle(const NccsHeader& header, Statement& statement) {
  statement.word = Word::circle;
  statement.major = "CIRCLE";
  const std::size_t count = header.words - std::size_t{1};
  if (count != kCircleNumbers && count != kCircleWords) return;  // an arc that is not understood
  for (std::size_t i = header.words - kCircleNumbers; i < header.words; ++i) statement.decoded.push_back(number_at(i));
}

// Takes CUTTER/d,r,h as programmed, or d,r,h,side angle. In APT, d is the diameter at which the flank meets the bottom
// plane. The ASCII file of the same program shows it: 0.2,0.1,0.2,-89 is CUTTER/22.918,0.1,0,0.1,0,-89,0.2.
void NccsStatements::take_cutter(const NccsHeader& header, Statement& statement) {
  std::vector<Argument> given;
  for (std::size_t i = 1; i < header.words; ++i) given.push_back(number_at(i));
  statement.word = Word::cutter;
  statement.major = "CUTTER";
  if ((given.size() != 3 && given.size() != 4) || find_word_argument(given) != nullptr) {
    statement.word = Word::unread_tool;
    return;
  }
  const double radius = *given[1].number;
  const double side_deg = given.size() == 4 ? *given[3].number : 0;
  const double e = *given[0].number / 2 - radius;
  const double side_rad = side_deg * std::numbers::pi / 180;
  const double d =
      std::abs(side_deg) > 0 ? 2 * (e + radius / std::cos(side_rad) - radius * std::tan(side_rad)) : *given[0].number;
  for (const double value : {d, radius, e, radius, 0.0, side_deg, *given[2].number})
    statement.decoded.push_back({given.front().text, value});
}

void NccsStatements::take_record(const NccsHeader& header, Statement& statement) {
  statement.word = Word::harmless;
  switch (header.klass) {
    case NccsClass::kPost:
      return take_post(header, statement);
    case NccsClass::kMotion:
      return take_motion(header, statement);
    case NccsClass::kExpanded:
      return take_expanded(header, statement);
    case NccsClass::kCircle:
      return take_circle(header, statement);
    case NccsClass::kTool:
      if (header.subclass == kCutter) return take_cutter(header, statement);
      if (header.subclass != kInnerTolerance && header.subclass != kOuterTolerance) statement.major = "tool record";
      return;
    case NccsClass::kMode:
      statement.word = header.subclass <= NccsSubclass::kMultaxOff ? Word::multax : Word::unread_frame;
      statement.major = header.subclass <= NccsSubclass::kMultaxOff ? "MULTAX" : "mode record";
      is_multax_off_ = header.subclass == NccsSubclass::kMultaxOff;
      if (is_multax_off_) statement.decoded.push_back({"OFF", std::nullopt});
      return;
    case NccsClass::kFini:
      statement.word = Word::fini;
      is_over_ = true;
      return;
    case NccsClass::kHeader:
    case NccsClass::kSourceLine:
    case NccsClass::kSourceNumber:
    case NccsClass::kShownTool:
      return;
    default:
      statement.word = Word::unread_motion;
      statement.major = "record of an unknown class";
  }
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
  take_record(header, statement);
  word_ += header.words;
  return true;
}

std::unique_ptr<StatementSource> open_nccs(std::string_view bytes, std::size_t, std::size_t) {
  return std::make_unique<NccsStatements>(bytes);
}

}  // namespace gouge
