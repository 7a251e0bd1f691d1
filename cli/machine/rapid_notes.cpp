#include "cli/machine/rapid_notes.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "lib/base/number_text.h"
#include "lib/base/tolerance.h"
#include "lib/machine/kinematics.h"

namespace gouge {
namespace {

// Returns the law of a rapid, as the control states it; none: it states none.
std::optional<TurnLaw> law_of(const Control& control, const Move& move) {
  return move.runs_joints ? control.joint_rapid_law : control.rapid_law;
}

// Returns whether a rapid runs by its joints, and not all of them arrive together.
bool may_bend(const Control& control, const Move& move) {
  const std::optional<TurnLaw> law = law_of(control, move);
  return law ? *law == TurnLaw::independent : move.runs_joints;
}

// Returns whether several joints run in a move. The length of the tool makes no difference where no joint turns.
bool runs_several_joints(const Machine& machine, const Toolpath& path, std::size_t index) {
  const std::optional<RotaryAngles>&from = path.joints->start[index], &to = path.joints->end[index];
  if (!from || !to) return true;
  const JointValues before = inverse(machine, path.start_of(index).tip, *from, 0);
  const JointValues after = inverse(machine, path.moves[index].end.tip, *to, 0);
  std::size_t running = 0;
  for (std::size_t joint = 0; joint < before.size(); ++joint)
    if (std::abs(after[joint] - before[joint]) > Tolerance::kWitness_mm) ++running;
  return running > 1;
}

}  // namespace

Diagnostics find_lost_rapids(const Machine& machine, const Toolpath& path) {
  if (path.joints == nullptr) return {};
  std::size_t count = 0, first = kNone;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Move& move = path.moves[i];
    const bool is_rapid = move.feed_unit == FeedUnit::rapid && move.has_start;
    if (!is_rapid || !may_bend(machine.control, move) || !runs_several_joints(machine, path, i)) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return {};
  const bool is_stated = law_of(machine.control, path.moves[first]).has_value();
  return {make_warning("convert-rapid",
                       count_text(count, "rapid move") + " of several axes written as straight: in the program, " +
                           (is_stated ? "each axis runs at its own rate"
                                      : "nothing states that the axes arrive together (--joint-rapid-law)") +
                           "; check the output with --rapid dogleg",
                       path.file, path.moves[first].line)};
}

}  // namespace gouge
