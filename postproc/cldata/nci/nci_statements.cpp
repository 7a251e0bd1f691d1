#include "postproc/cldata/nci/nci_statements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr std::size_t kToolField = 3;
constexpr double kCompOff = 40, kCompLeft = 41, kCompRight = 42, kCompOffAtEnd = 140;

// Returns whether a plane is that of the part. The nine numbers of a matrix are followed by those of an origin, and the
// number of the plane.
bool is_identity(const std::vector<Argument>& fields) {
  constexpr std::size_t kMatrix = 9, kOrigin = 12;
  if (fields.size() < kMatrix || fields.size() > kOrigin + 1) return false;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i].number) return false;
    if (i == kOrigin) return *fields[i].number >= 0 && std::floor(*fields[i].number) >= *fields[i].number;
    const double expected = i < kMatrix && i % 4 == 0 ? 1 : 0;
    if (std::abs(*fields[i].number - expected) > Tolerance::kSameDirection) return false;
  }
  return true;
}

CutcomSide side_of(double compensation) {
  const auto is = [&](double value) { return std::abs(compensation - value) < Tolerance::kSameDirection; };
  if (is(kCompOff) || is(kCompOffAtEnd)) return CutcomSide::none;
  return is(kCompLeft) ? CutcomSide::left : is(kCompRight) ? CutcomSide::right : CutcomSide::unknown;
}

// Returns whether a code only describes tools, stock or toolpaths to a post-processor (chapter "The NCI File").
bool is_harmless_nci_code(int code) {
  constexpr std::array<int, 9> kCodes = {1011, 1012, 1016, 1017, 1020, 1050, 1051, 1052, 1053};
  constexpr int kFirstOfPath = 10000, kLastOfTool = 29999;
  return std::ranges::find(kCodes, code) != kCodes.end() || (code >= kFirstOfPath && code <= kLastOfTool);
}

Argument number(double value) { return {{}, value}; }

}  // namespace

const std::vector<Argument>& NciStatements::read_fields() {
  split_nci_fields(pair_.parameters, fields_);
  return fields_;
}

void NciStatements::add(Word word, std::string_view major) {
  Statement& statement = queue_[queued_++];
  statement.clear();
  statement.line = pair_.line;
  statement.first_byte = statement.last_byte = pair_.first_byte;
  statement.word = word;
  statement.major = major;
  statement.is_decoded = true;
  statement.pieces.push_back(pair_.parameters);
}

// Takes compensation. A pair that may have switched it in a way that is not read leaves it on.
void NciStatements::take_compensation(std::optional<double> value) {
  if (value && std::abs(*value) < Tolerance::kSameDirection) return;
  const CutcomSide side = value ? side_of(*value) : CutcomSide::unknown;
  if (side == cutcom_) return;
  cutcom_ = side;
  add(Word::cutcom, "CUTCOM");
  decoded().push_back({cutcom_word(side), std::nullopt});
}

void NciStatements::take_speed(const NciMotion& motion) {
  if (motion.is_rapid) {
    add(Word::rapid, "RAPID");
  } else if (*fields_[motion.feed].number > 0) {
    add(Word::fedrat, "FEDRAT");
    decoded().push_back(fields_[motion.feed]);
  }
}

void NciStatements::add_circle(const NciMotion& motion) {
  add(Word::circle, "CIRCLE");
  std::vector<Argument>& words = decoded();
  for (Eigen::Index i = 0; i < 3; ++i) words.push_back(number(motion.center[i]));
  const Vec3 axis = motion.plane == NciPlane::xy   ? Vec3::UnitZ()
                    : motion.plane == NciPlane::yz ? Vec3::UnitX()
                                                   : Vec3::UnitY();
  for (Eigen::Index i = 0; i < 3; ++i) words.push_back(number(axis[i]));
  words.push_back({motion.is_clockwise ? "CLOCKWISE" : "COUNTERCLOCKWISE", std::nullopt});
  if (motion.plane == NciPlane::xz) words.push_back({"ZXPLAN", std::nullopt});
  if (!motion.is_full_circle) return;
  words.push_back({"ANGLE", std::nullopt});
  words.push_back(number(360));
}

void NciStatements::take_motion() {
  const NciMotion motion = read_nci_motion(*pair_.code, read_fields());
  take_compensation(motion.compensation);
  if (motion.problem != nullptr) return add(Word::unread_motion, motion.problem);
  take_speed(motion);
  if (motion.form == NciForm::arc) add_circle(motion);
  add(Word::go_to, "GOTO");
  for (const std::size_t field : motion.tip) decoded().push_back(fields_[field]);
  if (motion.form != NciForm::five_axis) return;
  for (Eigen::Index i = 0; i < 3; ++i) decoded().push_back(number(motion.axis[i]));
}

// Takes a tool plane. It turns positions in a way that no public reference describes. The plane of the part means that
// lines of three axes have the axis +Z, independent of earlier pairs.
void NciStatements::take_plane() {
  if (!is_identity(read_fields())) return add(Word::unread_frame, "NCI 1014 (tool plane)");
  add(Word::tlaxis, "NCI 1014 (tool plane)");
  for (Eigen::Index i = 0; i < 3; ++i) decoded().push_back(number(Vec3::UnitZ()[i]));
}

// Takes a tool change. A diameter that 1013 states before it belongs to the tool.
void NciStatements::take_tool() {
  const std::optional<double> diameter = std::exchange(diameter_, std::nullopt);
  if (read_fields().size() <= kToolField) return add(Word::unread_tool, "NCI 1000 to 1002");
  if (diameter && *diameter > 0) {
    add(Word::toolno, "TOOLNO");
    decoded() = {fields_[kToolField], number(*diameter)};
  }
  add(Word::loadtl, "LOADTL");
  decoded().push_back(fields_[kToolField]);
}

void NciStatements::take_pair() {
  const int code = pair_.code.value_or(-1);
  if (is_nci_motion(code)) return take_motion();
  switch (code) {
    case NciCode::kDwell:
    case NciCode::kCycleOff:
      return add(Word::harmless, "80");
    case NciCode::kCancelComp:
      take_compensation(kCompOff);
      return add(Word::harmless, "1004");
    case NciCode::kEnd:
      return add(Word::fini, "1003");
    case NciCode::kEntryFirst:
    case NciCode::kEntrySecond:
    case NciCode::kEntryLast:
      return add(Word::insert, "NCI manual entry");
    case NciCode::kComment:
      return add(Word::operation, "1008");
    case NciCode::kToolSize: {
      constexpr std::size_t kDiameterField = 1;
      diameter_ = read_fields().size() > kDiameterField ? fields_[kDiameterField].number : std::nullopt;
      return add(Word::harmless, "1013");
    }
    case NciCode::kToolPlane:
      return take_plane();
    case NciCode::kSubBegin:
    case NciCode::kSubEnd:
      return add(Word::unread_frame, "NCI 1018 (subprogram)");
    case NciCode::kWcs: {
      const bool is_same = wcs_ ? *wcs_ == pair_.parameters : is_identity(read_fields());
      wcs_ = pair_.parameters;
      return add(is_same ? Word::harmless : Word::unread_frame, "NCI 1027 (coordinate system)");
    }
    default:
      break;
  }
  if (code >= NciCode::kToolFirst && code <= NciCode::kToolLast) {
    take_tool();
  } else {
    add(code < NciCode::kToolFirst   ? Word::unread_motion
        : is_harmless_nci_code(code) ? Word::harmless
                                     : Word::unknown,
        "NCI other code");
  }
}

bool NciStatements::next(Statement& statement) {
  if (given_ == queued_) {
    given_ = queued_ = 0;
    if (!lines_.next(pair_)) return false;
    if (pair_.is_whole) {
      take_pair();
    } else {
      add(Word::unknown, "");
      queue_[0].is_unterminated = true;
    }
    queue_[queued_ - 1].last_byte = pair_.last_byte;
  }
  std::swap(statement, queue_[given_++]);
  return true;
}

std::unique_ptr<StatementSource> open_nci(std::string_view bytes, std::size_t first_byte, std::size_t line) {
  return std::make_unique<NciStatements>(bytes, first_byte, line);
}

}  // namespace gouge
