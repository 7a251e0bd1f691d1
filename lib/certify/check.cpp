#include "lib/certify/check.h"

#include <string>

#include "lib/certify/any_turn.h"
#include "lib/check/check_path.h"
#include "lib/check/check_result.h"
#include "lib/further/further_contacts.h"
#include "lib/head/check_heads.h"
#include "lib/overcut/measure_overcut.h"

namespace gouge {

namespace {
// Settles the verdicts of covering motions, which contain every motion that an ambiguous statement may mean. If such a
// motion meets an obstacle, it proves nothing. It also proves nothing about bodies that were not widened.
void settle_covers(const Toolpath& path, bool has_heads, CheckResult& result) {
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    MoveVerdict& verdict = result.verdicts[i];
    if (!move.is_covered() || verdict.state == MoveState::not_checked) continue;
    const bool is_proved = verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
    if (is_proved && !(has_heads && move.needs_wide_tool())) {
      MoveVerdict clean;
      clean.depth_upper_mm = verdict.depth_upper_mm;
      verdict = clean;
    } else {
      verdict = not_checked({Reason::Kind::of_path, Body::cutter, 0, std::string(move.not_checked_reason)});
    }
  }
}

}  // namespace

CheckResult check_moves(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress) {
  CheckResult result = check_path(path, setup.tools, setup.scene, setup.options, progress, setup.kept);
  check_heads(path, setup.heads, setup.scene, setup.options, result, progress, setup.kept);
  settle_covers(path, !setup.heads.empty(), result);
  summarise(path, result);  // measure_overcuts needs the worst move of each event
  measure_overcuts(path, setup.tools, setup.scene, setup.options, result, setup.heads, progress, setup.kept);
  return result;
}

CheckResult check(const Toolpath& path, const CheckSetup& setup, const ProgressCall& progress) {
  CheckResult result = check_moves(path, setup, progress);
  find_further_contacts(path, setup.tools, setup.scene, setup.options, setup.heads, result, progress);
  result.any_turn = count_any_turns(path, setup, result, progress);
  if (setup.stock != nullptr) {
    settle_stock(path, setup, result, progress);
    summarise(path, result);
  }
  assess(path, setup, result);
  return result;
}

}  // namespace gouge
