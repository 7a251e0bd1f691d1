#include "lib/check/check_any_turn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "lib/base/best_first_search.h"
#include "lib/base/tolerance.h"
#include "lib/check/check_motions.h"
#include "lib/check/turn_box.h"

namespace gouge {
namespace {

bool is_proved_clean(const MoveVerdict& verdict) {
  return verdict.state == MoveState::clean || verdict.state == MoveState::near_miss;
}

/// Returns the tool that is swept over the spread of a box; null: no level of tilt covers it, or the sweep failed.
const ToolVariants* swept_tool(const Motion& motion, const ToolVariants& tool, const TurnShares& low,
                               const TurnShares& high) {
  const std::optional<std::size_t> level = level_of_tilt(motion.axis_path()->spread(low, high).axis_rad);
  return level && tool.tilted ? tool.tilted->at(*level) : nullptr;
}

/// Options of the check of a swept tool, whose depth only bounds that of the tool.
CheckOptions swept_options(const CheckOptions& options) {
  constexpr double kSweptGap_mm = 0.005;
  CheckOptions swept = options;
  swept.near_miss_mm = 0;
  swept.gouge_gap_mm = std::max({options.gouge_gap_mm, options.resolution_mm, kSweptGap_mm});
  return swept;
}

class AnyTurnSearch : public BestFirstSearch<AnyTurnSearch, TurnBox> {
 public:
  AnyTurnSearch(const Motion& motion, MoveKind kind, const ToolVariants& tool, const PreparedScene& scene,
                const CheckOptions& options, MoveVerdict& verdict, std::uint64_t& bounds)
      : motion_(motion),
        kind_(kind),
        tool_(tool),
        scene_(scene),
        options_(options),
        verdict_(verdict),
        bounds_(bounds),
        swept_(swept_options(options)),
        exact_(options) {
    exact_.near_miss_mm = 0;
  }

  /// `whole`: the verdict on the swept tool for the whole box; none: no sweep covers it.
  void find(const std::optional<MoveVerdict>& whole) {
    TurnBox box;
    examine(box, whole);
    const double upper_mm = run();
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, upper_mm);
    if (verdict_.state == MoveState::gouge || verdict_.state == MoveState::not_certified || is_decided()) return;
    verdict_.state = MoveState::not_certified;
    verdict_.clearance_mm.reset();
    verdict_.reason = {Reason::Kind::turn_undecided};
  }

  static constexpr bool kDescends = false;

  [[nodiscard]] double threshold_mm() const { return turn_threshold_mm(verdict_, options_); }
  [[nodiscard]] bool is_exhausted() const {
    return boxes_ >= options_.turn_boxes || bounds_ >= options_.budget_per_move;
  }

  void split(const TurnBox& box) {
    for (const TurnBox& half : halves_of(box, motion_, &TurnSpread::axis_rad)) examine(half, swept_verdict(half));
  }

 private:
  [[nodiscard]] std::optional<MoveVerdict> swept_verdict(const TurnBox& box) {
    const ToolVariants* const swept = swept_tool(motion_, tool_, box.low, box.high);
    if (swept == nullptr) return std::nullopt;
    return checked(motion_.at_rest(box.middle()), *swept, swept_);
  }

  /// Takes the proof of a box from the verdict on the swept tool. Without a proof it looks for a witness at the middle of
  /// the box, and offers the box.
  void examine(TurnBox box, const std::optional<MoveVerdict>& swept) {
    ++boxes_;
    box.upper_mm = std::numeric_limits<double>::infinity();
    if (swept) {
      if (is_proved_clean(*swept)) return prune(swept->depth_upper_mm);
      if (swept->state == MoveState::not_checked) return refuse(swept->reason);
      // A limit that is stricter than the tolerance may be exceeded at a smaller depth.
      const double open_mm = options_.tolerance_mm + 2 * options_.resolution_mm;
      box.upper_mm = std::max(swept->depth_upper_mm, open_mm);
    }
    if (!(verdict_.state == MoveState::gouge && options_.gouge_gap_mm >= kAnyGap_mm))
      take(checked(motion_.at_rest(box.middle()), tool_, exact_));
    offer(box);
  }

  void refuse(const Reason& reason) {
    if (verdict_.state != MoveState::gouge) verdict_ = not_checked(reason);
    boxes_ = options_.turn_boxes;
  }

  void take(MoveVerdict&& at_middle) {
    if (at_middle.state != MoveState::gouge) return;
    const bool is_deeper = verdict_.state != MoveState::gouge || at_middle.depth_mm > verdict_.depth_mm;
    if (!is_deeper) return;
    const double upper_mm = std::max(verdict_.depth_upper_mm, at_middle.depth_mm);
    verdict_ = std::move(at_middle);
    verdict_.depth_upper_mm = upper_mm;
  }

  [[nodiscard]] MoveVerdict checked(const Motion& motion, const ToolVariants& tool, const CheckOptions& options) {
    MoveVerdict verdict;
    std::uint64_t spent = 0;
    check_motions({&motion, 1}, {&kind_, 1}, tool, scene_, options, {&verdict, 1}, {&spent, 1});
    bounds_ += spent;
    return verdict;
  }

  const Motion& motion_;
  MoveKind kind_;
  const ToolVariants& tool_;
  const PreparedScene& scene_;
  const CheckOptions& options_;
  MoveVerdict& verdict_;
  std::uint64_t& bounds_;
  CheckOptions swept_, exact_;
  std::uint64_t boxes_ = 0;
};

/// Returns how far the tool reaches from its tip, in all its variants.
double farthest_mm(const ToolVariants& tool) {
  double reach = 0;
  for (const CompiledTool* form : {&tool.bare, &tool.against_part, &tool.against_fixture})
    reach = std::max(reach, Vec2(form->r_max_mm, std::max(std::abs(form->z_min_mm), std::abs(form->z_max_mm))).norm());
  return reach;
}

/// Returns whether the joints move only by the rounding of their angles, so that the motion itself shows all poses.
bool is_at_rest(const Motion& motion, const ToolVariants& tool) {
  return motion.axis_path()->spread({0, 0}, {1, 1}).axis_rad * farthest_mm(tool) <= Tolerance::kRounding_mm;
}

/// Moves whose whole boxes are swept by the same tool.
struct SweptGroup {
  std::vector<std::size_t> moves;
  std::vector<Motion> motions;
  std::vector<MoveKind> kinds;
};

}  // namespace

void check_any_turns(std::span<const Motion> motions, std::span<const MoveKind> kinds, const ToolVariants& tool,
                     const PreparedScene& scene, const CheckOptions& options, std::span<MoveVerdict> verdicts,
                     std::span<std::uint64_t> bounds) {
  constexpr TurnShares kLow{0, 0}, kHigh{1, 1}, kMiddle{0.5, 0.5};
  std::map<std::size_t, SweptGroup> groups;  // by the level of tilt
  std::vector<std::pair<std::size_t, std::optional<MoveVerdict>>> open;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    if (!motions[m].is_any() || verdicts[m].state == MoveState::not_checked) continue;
    if (is_at_rest(motions[m], tool)) continue;
    const std::optional<std::size_t> level = level_of_tilt(motions[m].axis_path()->spread(kLow, kHigh).axis_rad);
    if (!level || swept_tool(motions[m], tool, kLow, kHigh) == nullptr) {
      open.emplace_back(m, std::nullopt);
      continue;
    }
    SweptGroup& group = groups[*level];
    group.moves.push_back(m);
    group.motions.push_back(motions[m].at_rest(kMiddle));
    group.kinds.push_back(kinds[m]);
  }
  for (const auto& [level, group] : groups) {
    std::vector<MoveVerdict> found(group.moves.size());
    std::vector<std::uint64_t> spent(group.moves.size(), 0);
    check_motions(group.motions, group.kinds, *tool.tilted->at(level), scene, swept_options(options), found, spent);
    for (std::size_t k = 0; k < group.moves.size(); ++k) {
      const std::size_t m = group.moves[k];
      bounds[m] += spent[k];
      if (is_proved_clean(found[k]))
        verdicts[m].depth_upper_mm = std::max(verdicts[m].depth_upper_mm, found[k].depth_upper_mm);
      else
        open.emplace_back(m, std::move(found[k]));
    }
  }
  for (const auto& [m, whole] : open)
    AnyTurnSearch(motions[m], kinds[m], tool, scene, options, verdicts[m], bounds[m]).find(whole);
}

}  // namespace gouge
