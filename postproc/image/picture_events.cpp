#include "postproc/image/picture_events.h"

#include <algorithm>
#include <cmath>

#include "lib/field/field_instants.h"
#include "lib/head/find_head.h"
#include "lib/hierarchy/sight.h"
#include "lib/mesh/indexed_mesh.h"
#include "lib/motion/body_motion.h"
#include "lib/motion/motion_law.h"
#include "postproc/report/findings.h"

namespace gouge {

namespace {

double scene_size(const Scene& scene) {
  const Box3 box = box_of(scene.parts);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

void find_head(const CheckedToolpath& input, const Reason& reason, PictureEvent& one) {
  if (input.heads.empty()) return;
  if (one.has_witness && one.witness.body == Body::head) {
    one.head = deepest_head(input.heads, one.heads.inverse().point(one.at));
  } else if (!one.has_witness && reason.is(Reason::Kind::buried) && reason.body == Body::head) {
    if (const auto buried = find_buried_core(input.heads, one.heads, *input.scene)) {
      one.head = buried->head;
      one.at = buried->at;
    }
  }
}

PictureEvent picture_event(const CheckedToolpath& input, const Event& event) {
  const Move& move = input.toolpath->moves[event.worst_move];
  const MoveVerdict& verdict = input.result->verdicts[event.worst_move];
  PictureEvent one;
  one.event = event;
  one.has_witness = event.state == MoveState::gouge && verdict.witness.has_value();
  if (one.has_witness) one.witness = *verdict.witness;
  const Motion motion =
      input.options.law.of(*input.toolpath, event.worst_move).with(one.has_witness ? one.witness.turn : std::nullopt);
  const double t = one.has_witness ? one.witness.t : 1.0;
  one.pose = motion.is_defined() ? motion.at(t) : move.end;
  one.heads =
      motion.is_defined() ? BodyMotion(motion).at(t) : RigidTransform{rotation_to_axis(move.end.axis), move.end.tip};
  const CompiledTool& bare = input.tools[event.tool]->bare;
  one.at = one.has_witness ? one.witness.point : Vec3(one.pose.tip + one.pose.axis * bare.core.y());
  find_head(input, verdict.reason, one);
  return one;
}

}  // namespace

std::vector<PictureEvent> worst_events(const CheckedToolpath& input, std::size_t most) {
  const std::vector<std::size_t> numbers = finding_numbers(*input.result);
  struct Numbered {
    const Event* event;
    std::size_t number;
  };
  std::vector<Numbered> events;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Event& event = input.result->events[i];
    const bool has_tool = event.tool < input.tools.size() && input.tools[event.tool] != nullptr;
    if (has_tool && (event.state == MoveState::gouge || event.state == MoveState::buried))
      events.push_back({&event, numbers[i]});
  }
  const auto depth_of = [&](const Event& event) {
    return event.state == MoveState::buried ? -1.0 : input.result->verdicts[event.worst_move].depth_mm;
  };
  std::stable_sort(events.begin(), events.end(),
                   [&](const Numbered& a, const Numbered& b) { return depth_of(*a.event) > depth_of(*b.event); });
  const double apart_mm = 0.05 * scene_size(*input.scene);
  std::vector<PictureEvent> out;
  for (const Numbered& numbered : events) {
    const Event* const event = numbered.event;
    PictureEvent one = picture_event(input, *event);
    one.depth_mm = std::max(0.0, depth_of(*event));
    const bool is_reported = std::any_of(out.begin(), out.end(), [&](const PictureEvent& other) {
      return other.event.state == event->state && other.event.tool == event->tool && other.event.body == event->body &&
             (other.at - one.at).norm() < apart_mm;
    });
    if (is_reported || out.size() >= most) continue;
    one.rank = static_cast<int>(out.size()) + 1;
    one.number = numbered.number;
    out.push_back(one);
  }
  return out;
}

std::vector<GougeWitness> gouge_witnesses(const CheckedToolpath& input, std::size_t most) {
  std::vector<std::size_t> gouging;
  const MoveVerdicts& verdicts = input.result->verdicts;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].state == MoveState::gouge && verdicts[i].witness) gouging.push_back(i);
  }
  std::vector<GougeWitness> out;
  const std::size_t every = gouging.size() / std::max<std::size_t>(most, 1) + 1;
  for (std::size_t k = 0; k < gouging.size(); k += every) {
    const MoveVerdict& verdict = verdicts[gouging[k]];
    const Motion motion = input.options.law.of(*input.toolpath, gouging[k]);
    const double travel = motion.is_defined() ? path_length_mm(motion) : 0;
    // The width of a trace is about proportional to the square root of its depth.
    const double weight = std::max(travel, verdict.depth_mm) * std::sqrt(std::max(verdict.depth_mm, 0.0));
    out.push_back({verdict.witness->point, verdict.witness->normal, weight});
  }
  return out;
}

bool is_in_sight(const CheckedToolpath& input, const Vec3& point, const Vec3& toward, double clear_mm) {
  return std::ranges::none_of(input.prepared->obstacles(), [&](const PreparedObstacle& obstacle) {
    return is_hidden(obstacle.tree, point, toward, clear_mm);
  });
}

}  // namespace gouge
