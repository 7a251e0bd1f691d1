#include "cli/job/compare_laws.h"

#include <algorithm>
#include <array>

#include "cli/machine/joint_laws.h"
#include "cli/machine/machine_choice.h"
#include "lib/certify/check.h"
#include "lib/path/run_kind.h"

namespace gouge {
namespace {

/// Laws that each state one motion.
constexpr std::array kCompared = {TurnLaw::vector, TurnLaw::axis, TurnLaw::joint, TurnLaw::independent};

/// Returns the result for the rapids of a path, or for its other moves.
LawRecord record_for(TurnLaw law, bool is_rapid, const Toolpath& path, const MoveVerdicts& verdicts) {
  LawRecord record{.law = turn_law_name(law), .is_rapid = is_rapid};
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (runs_rapid(path.moves[i]) != is_rapid) continue;
    const MoveVerdict& verdict = verdicts[i];
    const bool is_open = verdict.state == MoveState::not_checked || verdict.state == MoveState::not_certified;
    if (is_open) ++record.open;
    if (verdict.state != MoveState::gouge && verdict.state != MoveState::buried) continue;
    ++record.gouges;
    if (record.depth_mm && !(verdict.depth_mm > *record.depth_mm)) continue;
    record.depth_mm = verdict.depth_mm;
    record.line = path.moves[i].line;
  }
  return record;
}

}  // namespace

std::vector<LawRecord> compare_laws(const Job& job, const PreparedScene& scene, const ProgressCall& progress) {
  std::vector<LawRecord> feeds, rapids;
  for (const TurnLaw law : kCompared) {
    const bool is_for_feeds = law != TurnLaw::independent;
    const TurnLaws laws{is_for_feeds ? law : job.laws.feeds, law, job.laws.joint_rapids};
    Result<MotionLaw> motion = make_motion_law(*job.machine, laws, job.options.check.law.rapid(),
                                               job.options.tool_length_mm, !job.heads().empty());
    if (!motion) {
      const std::string& missing = motion.error().message;
      if (is_for_feeds) feeds.push_back({.law = turn_law_name(law), .missing = missing});
      rapids.push_back({.law = turn_law_name(law), .is_rapid = true, .missing = missing});
      continue;
    }
    Toolpath path = job.toolpath;
    // Moves without tool centre point control keep their laws. Intervals were refused when the job was loaded.
    static_cast<void>(add_joint_laws(*job.machine, laws, job.options.tool_length_mm, 0, path, *motion));
    static_cast<void>(choose_joints_of(*job.machine, *motion, job.options.tool_length_mm,
                                       needs_turn(laws, !job.heads().empty()), path));
    CheckOptions options = job.options.check;
    options.law = *motion;
    CheckSetup setup = job.setup(scene);
    const CheckResult result =
        check_moves(path, {setup.tools, setup.heads, setup.scene, options, nullptr, setup.basis}, progress);
    if (is_for_feeds) feeds.push_back(record_for(law, false, path, result.verdicts));
    rapids.push_back(record_for(law, true, path, result.verdicts));
  }
  const auto is_rapid = [](const Move& move) { return runs_rapid(move); };
  if (std::ranges::any_of(job.toolpath.moves, is_rapid)) feeds.insert(feeds.end(), rapids.begin(), rapids.end());
  return feeds;
}

}  // namespace gouge
