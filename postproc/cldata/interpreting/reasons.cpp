#include "postproc/cldata/interpreting/reasons.h"

#include <algorithm>
#include <array>

namespace gouge {
namespace {

struct Row {
  std::string_view text;
  ReasonKind kind;
};

// All others are not_understood.
constexpr std::array<Row, 12> kKinds = {{{Reasons::kCutcom, ReasonKind::compensated},
                                         {Reasons::kAfterCutcom, ReasonKind::compensated},
                                         {Reasons::kAfterRetract, ReasonKind::after_retract},
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

}  // namespace gouge
