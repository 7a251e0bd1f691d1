#include "postproc/image/picture_events.h"

#include <algorithm>

#include "lib/check/motion.h"

namespace gouge {

std::vector<PictureEvent> worst_events(const PictureInput& input, std::size_t most) {
  std::vector<Event> events;
  for (const Event& event : input.result->events) {
    const bool has_tool = event.tool < input.tools.size() && input.tools[event.tool] != nullptr;
    if (has_tool && (event.state == MoveState::gouge || event.state == MoveState::buried))
      events.push_back(event);
  }
  const auto depth_of = [&](const Event& event) {
    return event.state == MoveState::buried ? -1.0 : input.result->verdicts[event.worst_move].depth_mm;
  };
  std::stable_sort(events.begin(), events.end(),
                   [&](const Event& a, const Event& b) { return depth_of(a) > depth_of(b); });
  if (events.size() > most) events.resize(most);
  std::vector<PictureEvent> out;
  for (const Event& event : events) {
    const Move& move = input.toolpath->moves[event.worst_move];
    const MoveVerdict& verdict = input.result->verdicts[event.worst_move];
    PictureEvent one;
    one.number = static_cast<int>(out.size()) + 1;
    one.event = event;
    one.has_witness = event.state == MoveState::gouge && verdict.witness.has_value();
    if (one.has_witness) one.witness = *verdict.witness;
    const Motion motion =
        move.start ? Motion(*move.start, move.end, is_dogleg(move, input.options)) : Motion(move.end);
    one.pose = motion.is_defined() ? motion.at(one.has_witness ? one.witness.t : 1.0) : move.end;
    one.depth_mm = std::max(0.0, depth_of(event));
    const CompiledTool& bare = input.tools[event.tool]->bare;
    one.at = one.has_witness ? one.witness.point : Vec3(one.pose.tip + one.pose.axis * bare.core.y());
    out.push_back(one);
  }
  return out;
}

}  // namespace gouge
