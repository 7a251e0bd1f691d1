#include "cli/machine/start_notes.h"

#include <algorithm>

#include "lib/machine/joint_path.h"
#include "lib/machine/start_turn.h"

namespace gouge {

Diagnostics describe_other_starts(const Machine& machine, const MotionLaw& law, const Toolpath& path) {
  Diagnostics notes;
  if (std::ranges::none_of(path.moves, [&](const Move& move) { return move.has_start && law.is_by_axes(move); }))
    return notes;
  for (const OtherStart& start : find_other_starts(machine, path)) {
    const Joint& joint = machine.joints[start.joint];
    notes.push_back(make_note(
        "machine-start",
        "the check assumes that joint " + joint.name + " begins at " + joint_value_text(joint, start.chosen_rad) +
            "; its limits also permit " + joint_value_text(joint, start.other_rad) +
            ", from where it must turn back at or before this line; compare the start in the control, "
            "or state limits (--joint-limit)",
        path.file, path.moves[start.move].line));
  }
  return notes;
}

}  // namespace gouge
