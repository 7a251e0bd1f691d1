#include "lib/field/field_instants.h"

#include <algorithm>
#include <cmath>

#include "lib/motion/motion_law.h"

namespace gouge {
namespace {

class Picker {
 public:
  Picker(const CheckedToolpath& input, std::size_t most,
         const std::function<std::size_t(const Motion&, std::size_t)>& wanted)
      : input_(input), max_(most), wanted_(wanted) {
    const MoveVerdicts& verdicts = input.result->verdicts;
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      const std::size_t tool = input.toolpath->moves[i].tool;
      const bool has_variants = tool < input.tools.size() && input.tools[tool] != nullptr;
      if (verdicts[i].state == MoveState::gouge && has_variants) gouging_.push_back(i);
    }
  }

  std::vector<FieldInstants> pick() {
    // If there would be too many instants, each move gets fewer. The worst instant of a move always stays.
    for (double detail = 1; detail > 0.01; detail *= 0.5) {
      clear();
      for (std::size_t k = 0; k < gouging_.size() && count_ <= max_; ++k) add(gouging_[k], detail);
      if (count_ <= max_) return std::move(picked_);
    }
    add_worst_only();
    return std::move(picked_);
  }

 private:
  void clear() {
    picked_.clear();
    count_ = 0;
  }

  // If there are still too many gouging moves, only the worst of each group of neighbours is used.
  void add_worst_only() {
    clear();
    const MoveVerdicts& verdicts = input_.result->verdicts;
    const std::size_t group = gouging_.size() / std::max<std::size_t>(max_ / 2, 1) + 1;
    for (std::size_t first = 0; first < gouging_.size(); first += group) {
      // Depths are accurate to the resolution. Equal depths leave the picked moves evenly spread.
      const double equal = input_.options.resolution_mm;
      std::size_t worst = gouging_[first];
      for (std::size_t k = first; k < std::min(first + group, gouging_.size()); ++k) {
        if (verdicts[gouging_[k]].depth_mm > verdicts[worst].depth_mm + equal) worst = gouging_[k];
      }
      add(worst, 0);
    }
  }

  void add(std::size_t index, double detail) {
    const Motion motion = input_.options.law.of(*input_.toolpath, index);
    if (!motion.is_defined()) return;
    const MoveVerdict& verdict = input_.result->verdicts[index];
    FieldInstants one{index, {}};
    if (verdict.witness) one.t.push_back(verdict.witness->t);
    if (!motion.is_alone()) {
      const auto whole = static_cast<double>(wanted_(motion, index));
      const std::size_t steps = std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(whole * detail)));
      for (std::size_t k = detail < 0.1 ? steps : 0; k <= steps; ++k)
        one.t.push_back(static_cast<double>(k) / static_cast<double>(steps));
    }
    count_ += one.t.size();
    picked_.push_back(std::move(one));
  }

  const CheckedToolpath& input_;
  std::size_t max_;
  const std::function<std::size_t(const Motion&, std::size_t)>& wanted_;
  std::vector<std::size_t> gouging_;
  std::vector<FieldInstants> picked_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<FieldInstants> pick_instants(
    const CheckedToolpath& input, std::size_t most,
    const std::function<std::size_t(const Motion& motion, std::size_t move)>& wanted) {
  return Picker(input, most, wanted).pick();
}

std::vector<Motion> shown_motions(const Motion& motion, const Boxed<Witness>& witness) {
  std::vector<Motion> all{motion.alone()};
  if (auto other = motion.other())
    all.push_back(*std::move(other));
  else if (witness && witness->turn)
    all.push_back(motion.with(witness->turn));
  return all;
}

double path_length_mm(const Motion& motion) {
  double length = 0;
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s)
    length += motion.path_length_mm(motion.segments()[s].t0, motion.segments()[s].t1, s);
  return length;
}

}  // namespace gouge
