#include <algorithm>
#include <utility>
#include <vector>

#include "lib/check/turn_box.h"
#include "lib/head/check_heads.h"

namespace gouge {

/// The search for one head over all positions of the rotary joints. A point of the head at a distance from the tip moves
/// by at most the turn times that distance. So a surface that is moved towards the head by as much, with the joints at
/// rest at the middle of a box, is at least as deep as the surface at any position in the box.
class HeadChecker::AnyTurn : public BestFirstSearch<HeadChecker::AnyTurn, TurnBox> {
 public:
  AnyTurn(const HeadChecker& of, const HeadBody& head, const Motion& motion, const CheckOptions& options,
          MoveVerdict& verdict)
      : of_(of), head_(head), motion_(motion), options_(options), verdict_(verdict) {
    for (int k = 0; k < 8; ++k) far_mm_ = std::max(far_mm_, head.box.corner(static_cast<Box3::CornerType>(k)).norm());
  }

  /// Returns the maximum depth of all surfaces at all positions.
  double find() {
    examine({});
    const double upper_mm = run();
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, upper_mm);
    if (verdict_.state == MoveState::gouge || is_decided()) return upper_mm;
    verdict_.state = MoveState::not_certified;
    verdict_.reason = {Reason::Kind::turn_undecided, Body::head};
    verdict_.clearance_mm.reset();
    return upper_mm;
  }

  static constexpr bool kDescends = false;

  [[nodiscard]] double threshold_mm() const { return turn_threshold_mm(verdict_, options_); }
  [[nodiscard]] bool is_exhausted() const { return boxes_ >= options_.turn_boxes; }

  void split(const TurnBox& box) {
    for (const TurnBox& half : halves_of(box, motion_, &TurnSpread::frame_rad)) examine(half);
  }

  [[nodiscard]] std::uint64_t bounds() const { return bounds_; }

 private:
  [[nodiscard]] double reach_mm(const TurnBox& box) const {
    return motion_.axis_path()->spread(box.low, box.high).frame_rad * far_mm_;
  }

  HeadResult search(const Group& group, const Motion& resting, double reach_mm) {
    HeadResult found;
    of_.search_group(group, head_, {&resting, 1}, options_, {&found, 1}, reach_mm);
    bounds_ += found.bounds;
    return found;
  }

  /// Proves a box. If it cannot, it looks for a gouge with the joints at the middle of the box, and offers the box.
  void examine(TurnBox box) {
    ++boxes_;
    const Motion resting = motion_.at_rest(box.middle());
    bool is_proved = true;
    for (const Group& group : of_.groups_) {
      const double upper_mm = search(group, resting, reach_mm(box)).depth_upper_mm;
      if (!group.limit) box.upper_mm = upper_mm;
      if (upper_mm <= group.tolerance_mm(options_) + options_.resolution_mm) continue;
      is_proved = false;
      const HeadResult at_middle = search(group, resting, 0);
      if (at_middle.depth_mm > group.tolerance_mm(options_)) of_.join(at_middle, group, options_, resting, verdict_);
    }
    if (is_proved) return prune(box.upper_mm);
    // A limit that is stricter than the tolerance may be exceeded at a smaller depth.
    box.upper_mm = std::max(box.upper_mm, options_.tolerance_mm + 2 * options_.resolution_mm);
    offer(box);
  }

  const HeadChecker& of_;
  const HeadBody& head_;
  const Motion& motion_;
  const CheckOptions& options_;
  MoveVerdict& verdict_;
  double far_mm_ = 0;
  std::uint64_t bounds_ = 0, boxes_ = 0;
};

std::uint64_t HeadChecker::check_any_turn(const Motion& motion, const CheckOptions& options, MoveVerdict& verdict,
                                          std::vector<double>& uppers_mm) const {
  std::uint64_t bounds = 0;
  for (std::size_t h = 0; h < heads_.size(); ++h) {
    AnyTurn search(*this, heads_[h], motion, options, verdict);
    uppers_mm[h] = std::max(uppers_mm[h], search.find());
    bounds += search.bounds();
  }
  return bounds;
}

}  // namespace gouge
