#include "postproc/cldata/interpreting/reasons.h"

#include <algorithm>
#include <array>

#include "lib/base/letters.h"
#include "postproc/cldata/language/text.h"

namespace gouge {

namespace {

struct Row {
  std::string_view text;
  ReasonKind kind;
};

// All reasons that are not in this table are not_understood.
constexpr std::array<Row, 14> kKinds = {{{Reasons::kCutcom, ReasonKind::compensated},
                                         {Reasons::kAfterCutcom, ReasonKind::compensated},
                                         {Reasons::kAfterRetract, ReasonKind::after_retract},
                                         {Reasons::kAfterHomeOfAxes, ReasonKind::after_retract},
                                         {Reasons::kHomeOfAxes, ReasonKind::unread},
                                         {Reasons::kRetractPlane, ReasonKind::around_hole},
                                         {Reasons::kAfterCycle, ReasonKind::around_hole},
                                         {Reasons::kSixNumbers, ReasonKind::unread},
                                         {Reasons::kNineNumbers, ReasonKind::unread},
                                         {Reasons::kStepFromUnread, ReasonKind::unread},
                                         {Reasons::kNoArcEnd, ReasonKind::unread},
                                         {Reasons::kNoTlon, ReasonKind::unread},
                                         {Reasons::kCutShort, ReasonKind::unread},
                                         {Reasons::kUnread, ReasonKind::may_be_unread}}};

bool is_of(std::string_view reason, std::string_view text) {
  return reason.starts_with(text) && (reason.size() == text.size() || reason[text.size()] == ':');
}

}  // namespace

ReasonKind kind_of(std::string_view reason) {
  if (reason.empty()) return ReasonKind::none;
  const auto* const row = std::ranges::find_if(kKinds, [&](const Row& known) { return is_of(reason, known.text); });
  return row == kKinds.end() ? ReasonKind::not_understood : row->kind;
}

namespace {

constexpr std::size_t kLongestMajor = 24;

}  // namespace

std::string word_as_reported(std::string_view major) {
  if (major.empty()) return "(no word)";
  const char c = major.front();
  if ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.') return "(line of numbers)";
  return in_capitals(shown_text(major, kLongestMajor));
}

const char* NamedReasons::name(std::string_view reason, std::string_view major, std::size_t line) {
  std::string word = word_as_reported(major);
  std::string text = std::string(reason) + ": " + word;
  if (line == 0) return lasting_text(std::move(text));
  std::size_t& lines = lines_named_[{std::string(reason), std::move(word)}];
  if (lines < kMaxLines) {
    ++lines;
    text += " in line " + std::to_string(line);
  }
  return lasting_text(std::move(text));
}

}  // namespace gouge
