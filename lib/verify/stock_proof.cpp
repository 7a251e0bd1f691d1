#include "lib/verify/stock_proof.h"

#include <algorithm>
#include <optional>

#include "lib/verify/coaxial_cut.h"
#include "lib/verify/separation.h"

namespace gouge {

// No point of a body is deeper in it than its largest radius: that is a way out across the axis.
bool StockProofQuestion::is_empty() const {
  return body.empty() || depth_mm >= body.largest_radius_mm() || (stock.low().array() > stock.high().array()).any();
}

SpaceBlock StockProofQuestion::whole_block() const {
  const Vec3 axis = pieces.front().start().middle().axis;
  const Vec3 way = pieces.back().end().tip.middle() - pieces.front().start().tip.middle();
  return block_around(stock.low(), stock.high(), frame_along(axis, way));
}

ProofTime StockProofQuestion::whole_time() const { return {pieces.data(), pieces.data() + pieces.size(), 0}; }

LatestInstant StockProofQuestion::start_of(const ProofTime& time) const {
  const PieceOfMove& piece = of_piece[time.piece];
  return {piece.move, piece.index, time.from};
}

LatestInstant StockProofQuestion::end_of(const ProofTime& time) const {
  const PieceOfMove& piece = of_piece[time.last_piece()];
  return {piece.move, piece.index, time.until};
}

namespace {

class StockFollower {
 public:
  StockFollower(const StockProofQuestion& question, std::string_view& steps, ProofFault& fault)
      : question_(question),
        separation_(question.body, question.depth_mm + kProofSlack_mm),
        steps_(steps),
        fault_(fault) {}

  bool follow(const SpaceBlock& block, const ProofTime& time, int level) {
    if (steps_.empty()) return fails(block, time, "the proof ends too early");
    const char step = steps_.front();
    steps_.remove_prefix(1);
    if (level > kMaxNestedCuts) return fails(block, time, "the proof cuts too finely");
    if (step == kCutTime)
      return for_halves(time, [&](const ProofTime& half) { return follow(block, half, level + 1); });
    if (step >= step_of(StockStep::cut_first) && step <= step_of(StockStep::cut_third))
      return std::ranges::all_of(block.halves(static_cast<std::size_t>(step - step_of(StockStep::cut_first))),
                                 [&](const SpaceBlock& half) { return follow(half, time, level + 1); });
    if (step == step_of(StockStep::beside_stock)) return follow_beside(block, time);
    if (step == step_of(StockStep::named_cut)) return take_named(block, time) && follow_cut(block, time);
    if (step == step_of(StockStep::same_cut)) return follow_cut(block, time);
    if (step == step_of(StockStep::coaxial_cut)) return take_named(block, time) && follow_coaxial(block, time);
    if (step == step_of(StockStep::same_coaxial_cut)) return follow_coaxial(block, time);
    return follow_plane(static_cast<ProofKind>(step), block, time);
  }

 private:
  bool follow_plane(ProofKind kind, const SpaceBlock& block, const ProofTime& time) {
    if (kind != ProofKind::center_plane && kind != ProofKind::center_ring && kind != ProofKind::exit_point)
      return fails(block, time, "the proof has a step that is none");
    const SurfacePatch patch = block_patch(block);
    separation_.look_at(patch, time.span);
    return separation_.holds(kind, question_.depth_mm + kProofSlack_mm) ||
           fails(block, time, "what the proof names does not keep the tool and a block of the stock apart");
  }

  bool follow_beside(const SpaceBlock& block, const ProofTime& time) {
    bool may_be_outside = true;
    return question_.stock.is_beside(block, may_be_outside) ||
           fails(block, time, "a block that the proof places outside of the stock is not proved to be there");
  }

  bool take_named(const SpaceBlock& block, const ProofTime& time) {
    const auto cut = take_cut(steps_);
    cutter_ = cut ? question_.cuts.cutter_of(*cut) : nullptr;
    if (cutter_ != nullptr) poses_ = question_.cuts.poses_of(*cut);
    if (cutter_ == nullptr || !poses_) return fails(block, time, "the proof names a cut that is none");
    cut_ = *cut;
    return true;
  }

  bool follow_cut(const SpaceBlock& block, const ProofTime& time) {
    return is_earlier(block, time) &&
           (is_within_cutter(*cutter_, *poses_, block, question_.resolution_mm) ||
            fails(block, time, "the cutter that the proof names does not contain a block of the stock"));
  }

  bool follow_coaxial(const SpaceBlock& block, const ProofTime& time) {
    const DeepPart part{question_.body, question_.depth_mm + kProofSlack_mm, block, time.span};
    return is_earlier(block, time) && (is_deep_part_within(part, *cutter_, *poses_, question_.resolution_mm) ||
                                       fails(block, time, "the cutter that the proof names does not contain the body"));
  }

  bool is_earlier(const SpaceBlock& block, const ProofTime& time) {
    if (cutter_ == nullptr || !poses_) return fails(block, time, "the proof names no cut");
    return is_by(cut_, question_.cuts.size() - 1, question_.start_of(time)) ||
           fails(block, time, "the proof names a cut that comes later");
  }

  bool fails(const SpaceBlock& block, const ProofTime& time, const char* what) {
    fault_ = {time.piece, block.center, what};
    return false;
  }

  const StockProofQuestion& question_;
  Separation separation_;
  std::string_view& steps_;
  ProofFault& fault_;
  NamedCut cut_;
  const ToolContour* cutter_ = nullptr;
  std::optional<CutPoses> poses_;
};

}  // namespace

bool follow_stock_proof(const StockProofQuestion& question, std::string_view steps, ProofFault& fault) {
  if (!question.is_empty() &&
      !StockFollower(question, steps, fault).follow(question.whole_block(), question.whole_time(), 0))
    return false;
  if (steps.empty()) return true;
  fault = {0, Vec3::Zero(), "its proof goes on after its end"};
  return false;
}

}  // namespace gouge
