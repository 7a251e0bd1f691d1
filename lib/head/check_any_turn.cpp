#include <algorithm>
#include <utility>
#include <vector>

#include "lib/head/check_heads.h"

namespace gouge {

/// The search for one head over all positions of the rotary joints. A point of the head at a distance from the tip moves
/// by at most the turn times that distance. So a surface that is moved towards the head by as much, with the joints at
/// rest at the middle of a box, is at least as deep as the surface at any position in the box.
class HeadChecker::AnyTurn {
 public:
  AnyTurn(const HeadChecker& of, const HeadBody& head, const Motion& motion, const CheckOptions& options,
          MoveVerdict& verdict)
      : of_(of), head_(head), motion_(motion), options_(options), verdict_(verdict) {
    for (int k = 0; k < 8; ++k) far_mm_ = std::max(far_mm_, head.box.corner(static_cast<Box3::CornerType>(k)).norm());
  }

  /// Returns the maximum depth of all surfaces at all positions.
  double find() {
    double upper_mm = depth_upper_mm({});
    std::vector<Box> open{{}};
    double proved_mm = 0;
    while (!open.empty() && verdict_.state != MoveState::gouge) {
      const Box box = open.back();
      open.pop_back();
      if (++boxes_ > options_.turn_boxes) {
        verdict_.state = MoveState::not_certified;
        verdict_.reason = {Reason::Kind::turn_undecided, Body::head};
        verdict_.clearance_mm.reset();
        break;
      }
      if (!prove(box, proved_mm)) halve(box, open);
    }
    const bool is_proved = open.empty() && boxes_ <= options_.turn_boxes && verdict_.state != MoveState::gouge;
    if (is_proved) upper_mm = proved_mm;
    verdict_.depth_upper_mm = std::max(verdict_.depth_upper_mm, upper_mm);
    return upper_mm;
  }

  [[nodiscard]] std::uint64_t bounds() const { return bounds_; }

 private:
  /// Shares of the rotary joints' ways.
  struct Box {
    TurnShares low{0, 0}, high{1, 1};
  };

  static TurnShares middle_of(const Box& box) {
    return {0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1])};
  }

  [[nodiscard]] double reach_mm(const Box& box) const {
    return motion_.axis_path()->spread(box.low, box.high).frame_rad * far_mm_;
  }

  HeadResult search(const Group& group, const Box& box, double reach_mm) {
    const Motion resting = motion_.at_rest(middle_of(box));
    HeadResult found;
    of_.search_group(group, head_, {&resting, 1}, options_, {&found, 1}, reach_mm);
    bounds_ += found.bounds;
    return found;
  }

  double depth_upper_mm(const Box& box) { return search(of_.groups_.front(), box, reach_mm(box)).depth_upper_mm; }

  /// Proves a box. If it cannot, it looks for a gouge with the joints at the middle of the box.
  bool prove(const Box& box, double& proved_mm) {
    bool is_proved = true;
    for (const Group& group : of_.groups_) {
      const double upper_mm = search(group, box, reach_mm(box)).depth_upper_mm;
      const bool is_low = upper_mm <= group.tolerance_mm(options_) + options_.resolution_mm;
      is_proved = is_proved && is_low;
      if (is_low && !group.limit) proved_mm = std::max(proved_mm, upper_mm);
      if (is_low) continue;
      const HeadResult at_middle = search(group, box, 0);
      if (at_middle.depth_mm > group.tolerance_mm(options_))
        of_.join(at_middle, group, options_, motion_.at_rest(middle_of(box)), verdict_);
    }
    return is_proved;
  }

  /// Halves a box across the joint that turns farther.
  void halve(const Box& box, std::vector<Box>& open) const {
    const TurnShares middle = middle_of(box);
    const double by_first = motion_.axis_path()->spread({box.low[0], middle[1]}, {box.high[0], middle[1]}).frame_rad;
    const double by_second = motion_.axis_path()->spread({middle[0], box.low[1]}, {middle[0], box.high[1]}).frame_rad;
    const std::size_t k = by_first >= by_second ? 0 : 1;
    Box first = box, second = box;
    first.high[k] = second.low[k] = middle[k];
    open.push_back(second);
    open.push_back(first);
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
