#include "postproc/cldata/nci_statements.h"

#include <cmath>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/cldata/arguments.h"

namespace gouge {
namespace {

struct NciCode {
  static constexpr int kRapid = 0, kLinear = 1, kArc = 2, kArcBack = 3, kDwell = 4, kFiveAxis = 11;
  static constexpr int kCycleOff = 80, kToolFirst = 1000, kToolLast = 1002, kEnd = 1003, kComment = 1008,
                       kToolPlane = 1014, kSubBegin = 1018, kSubEnd = 1019, kWcs = 1027;
};

constexpr std::size_t kFieldsOfLinear = 5;  // compensation, x, y, z, feed; flags may follow
constexpr std::size_t kToolField = 3;
constexpr double kRapidFeed = -2, kSameFeed = -1;
constexpr double kIdentityError = 1e-9;

bool is_identity(const std::vector<Argument>& fields) {
  if (fields.size() < 9) return false;
  for (std::size_t i = 0; i < 9; ++i) {
    const double expected = i % 4 == 0 ? 1 : 0;
    if (!fields[i].number || std::abs(*fields[i].number - expected) > kIdentityError) return false;
  }
  return true;
}

}  // namespace

const std::vector<Argument>& NciStatements::read_fields() {
  parameters_.pieces.assign(1, pair_.parameters);
  split_arguments(parameters_, fields_);
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

void NciStatements::take_linear() {
  const std::vector<Argument>& fields = read_fields();
  if (fields.size() < kFieldsOfLinear) return add(Word::unread_motion, "NCI 0 or 1 of too few numbers");
  const std::optional<double> feed = fields[4].number;
  const bool is_rapid =
      *pair_.code == NciCode::kRapid || (feed && std::abs(*feed - kRapidFeed) < kIdentityError);
  if (is_rapid) {
    add(Word::rapid, "RAPID");
  } else if (feed && *feed > 0) {
    add(Word::fedrat, "FEDRAT");
    queue_[queued_ - 1].decoded.push_back(fields[4]);
  }
  add(Word::go_to, "GOTO");
  queue_[queued_ - 1].decoded.assign(fields.begin() + 1, fields.begin() + 4);
}

// The tool plane turns positions in a way that no public reference tells.
void NciStatements::take_plane() {
  add(is_identity(read_fields()) ? Word::harmless : Word::unread_frame,
      "NCI 1014 (tool plane)");
}

void NciStatements::take_pair() {
  const int code = pair_.code.value_or(-1);
  switch (code) {
    case NciCode::kRapid:
    case NciCode::kLinear:
      return take_linear();
    case NciCode::kArc:
    case NciCode::kArcBack:
      return add(Word::unread_motion, "NCI 2 or 3 (arc)");
    case NciCode::kFiveAxis:
      return add(Word::unread_motion, "NCI 11 (five axes)");
    case NciCode::kDwell:
    case NciCode::kCycleOff:
      return add(Word::harmless, "80");
    case NciCode::kEnd:
      return add(Word::fini, "1003");
    case NciCode::kComment:
      return add(Word::operation, "1008");
    case NciCode::kToolPlane:
      return take_plane();
    case NciCode::kSubBegin:
    case NciCode::kSubEnd:
      return add(Word::unread_frame, "NCI 1018 (subprogram)");
    case NciCode::kWcs: {
      const bool is_same = !wcs_ || *wcs_ == pair_.parameters;
      wcs_ = pair_.parameters;
      return add(is_same ? Word::harmless : Word::unread_frame, "NCI 1027 (coordinate system)");
    }
    default:
      break;
  }
  if (code >= NciCode::kToolFirst && code <= NciCode::kToolLast) {
    const std::vector<Argument>& fields = read_fields();
    if (fields.size() <= kToolField) return add(Word::unread_tool, "NCI 1000 to 1002");
    add(Word::loadtl, "LOADTL");
    queue_[queued_ - 1].decoded.push_back(fields[kToolField]);
  } else {
    add(code < NciCode::kToolFirst ? Word::unread_motion : Word::harmless, "NCI other code");
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

}  // namespace gouge
