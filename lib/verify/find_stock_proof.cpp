#include "lib/verify/find_stock_proof.h"

#include <algorithm>
#include <array>
#include <optional>

#include "lib/verify/coaxial_cut.h"
#include "lib/verify/separation.h"
#include "lib/verify/witness_check.h"

namespace gouge {

namespace {

// Blocks narrower than this share of the body's radius are proved by themselves.
constexpr double kCoaxialWidth = 0.25;

class StockFinder {
 public:
  /// `has_coaxial`: it tries coaxial cuts. They save most steps where tools follow earlier cuts, and cost time elsewhere.
  StockFinder(const StockProofQuestion& question, CutSearch& search, bool has_coaxial, std::uint64_t max_tries,
              std::string& steps)
      : question_(question),
        has_coaxial_(has_coaxial),
        depth_mm_(question.depth_mm + 0.9 * kProofSlack_mm),  // the rest is a margin for the rounding of other machines
        separation_(question.body, question.depth_mm + kProofSlack_mm),
        search_(search),
        left_(max_tries),
        steps_(steps) {}

  /// `chords`: null until the block is small enough to be in a cutter.
  bool prove(const SpaceBlock& block, const ProofTime& time, const ChordList* chords, bool may_be_beside, int level) {
    if (left_ == 0 || level > kMaxNestedCuts) return false;
    --left_;
    const SurfacePatch patch = block_patch(block);
    separation_.look_at(patch, time.span);
    if (const auto kind = kind_that_holds(patch, time)) {
      steps_.push_back(static_cast<char>(*kind));
      return true;
    }
    if (question_.stock.is_beside(block, may_be_beside)) {
      steps_.push_back(step_of(StockStep::beside_stock));
      return true;
    }
    switch (try_coaxial(block, time)) {
      case Coaxial::proved:
        return true;
      case Coaxial::in_part_of_time:
        return prove_times(block, time, chords, may_be_beside, level);
      case Coaxial::in_part_of_height:
        return prove_blocks(block, upright_arm(block, time), time, chords, may_be_beside, level);
      case Coaxial::no:
        break;
    }
    ChordList left;
    bool is_late = false;
    std::optional<std::size_t> arm;
    if (patch.radius_mm <= search_.largest_mm()) {
      if (chords == nullptr) {
        left = search_.near(block, patch.radius_mm, question_.end_of(time).move);
        chords = &left;
      }
      ChordList fewer;
      if (const auto cut = search_.find(block, patch.radius_mm, *chords, question_.start_of(time), fewer)) {
        add(*cut, StockStep::named_cut, StockStep::same_cut);
        return true;
      }
      arm = search_.arm_to_cut();
      is_late = is_removed_late(block, patch.radius_mm, time, *chords);
      if (is_hopeless(patch, time, is_late)) return false;
      left = std::move(fewer);
      chords = &left;
    }
    if (is_late || prefers_time(patch, time)) return prove_times(block, time, chords, may_be_beside, level);
    return prove_blocks(block, arm.value_or(block.longest()), time, chords, may_be_beside, level);
  }

 private:
  enum class Coaxial : std::uint8_t { no, in_part_of_time, in_part_of_height, proved };

  /// Returns the arm that is most along the tool axis.
  static std::size_t upright_arm(const SpaceBlock& block, const ProofTime& time) {
    std::size_t best = 0;
    const auto lean = [&](std::size_t k) { return std::abs(block.arms[k].normalized().dot(time.span.middle.axis)); };
    for (std::size_t k = 1; k < 3; ++k)
      if (lean(k) > lean(best)) best = k;
    return best;
  }

  /// Tries whether a cutter contains all of the body that counts, at the heights of a block that is about as wide.
  Coaxial try_coaxial(const SpaceBlock& block, const ProofTime& time) {
    const std::size_t upright = upright_arm(block, time);
    const double width = std::min(block.arms[(upright + 1) % 3].norm(), block.arms[(upright + 2) % 3].norm());
    if (!has_coaxial_ || width < kCoaxialWidth * question_.body.largest_radius_mm()) return Coaxial::no;
    const bool may_cut_height = block.arms[upright].norm() > question_.resolution_mm;
    const std::optional<Pose> pose = pose_at_block(block, time);
    if (!pose) return may_cut_height ? Coaxial::in_part_of_height : Coaxial::no;
    const double height = (block.center - pose->tip).dot(pose->axis);
    const auto on_axis = [&](const Pose& at) { return Vec3(at.tip + height * at.axis); };
    const SpaceBlock section = block.section(upright);
    const TimeSpan instant = at_rest(*pose);
    Coaxial best = Coaxial::no;
    for (const FoundCut& found : search_.along(on_axis(time.first->start().middle()), on_axis(*pose),
                                               on_axis((time.last - 1)->end().middle()), question_.start_of(time))) {
      const auto holds = [&](const SpaceBlock& of, const TimeSpan& span) {
        return is_deep_part_within({question_.body, depth_mm_, of, span}, *found.cutter, found.poses,
                                   question_.resolution_mm);
      };
      if (holds(block, time.span)) {
        add(found.cut, StockStep::coaxial_cut, StockStep::same_coaxial_cut);
        return Coaxial::proved;
      }
      if (may_cut_height && holds(section, time.span)) best = Coaxial::in_part_of_height;
      if (best == Coaxial::no && (!time.is_one() || follows(found, time, height)) && holds(section, instant))
        best = Coaxial::in_part_of_time;
    }
    return best;
  }

  /// Returns whether the tool axis stays near the plane in which the axis of a cutter moves, at a height.
  [[nodiscard]] bool follows(const FoundCut& cut, const ProofTime& time, double height_mm) const {
    if (time.span.path_mm < question_.resolution_mm) return false;
    const Vec3 across = cut.way - cut.way.dot(cut.at.axis) * cut.at.axis;
    return std::ranges::all_of(std::array{time.first->start(), (time.last - 1)->end()}, [&](const PoseBounds& bounds) {
      const Pose pose = bounds.middle();
      const Vec3 from = pose.tip + height_mm * pose.axis - cut.at.tip;
      Vec3 off = from - from.dot(cut.at.axis) * cut.at.axis;
      if (across.squaredNorm() > 0) off -= off.dot(across) / across.squaredNorm() * across;
      return off.norm() < 2 * question_.resolution_mm + time.first->sag_mm();
    });
  }

  /// Returns a pose of the time at which the middle of the block is at a height of the body; nothing: it looks for none.
  [[nodiscard]] std::optional<Pose> pose_at_block(const SpaceBlock& block, const ProofTime& time) const {
    for (const Pose& pose : {time.span.middle, time.first->start().middle(), (time.last - 1)->end().middle()}) {
      const double height = (block.center - pose.tip).dot(pose.axis);
      if (height >= question_.body.low_mm() && height <= question_.body.high_mm()) return pose;
    }
    return std::nullopt;
  }

  static TimeSpan at_rest(const Pose& pose) {
    TimeSpan instant;
    instant.middle = pose;
    instant.poses = {{Bounds3(pose.tip), Bounds3(pose.axis)}};
    return instant;
  }

  bool prove_times(const SpaceBlock& block, const ProofTime& time, const ChordList* chords, bool may_be_beside,
                   int level) {
    steps_.push_back(kCutTime);
    return for_halves(time,
                      [&](const ProofTime& half) { return prove(block, half, chords, may_be_beside, level + 1); });
  }

  bool prove_blocks(const SpaceBlock& block, std::size_t arm, const ProofTime& time, const ChordList* chords,
                    bool may_be_beside, int level) {
    steps_.push_back(static_cast<char>(step_of(StockStep::cut_first) + static_cast<char>(arm)));
    return std::ranges::all_of(
        block.halves(arm), [&](const SpaceBlock& half) { return prove(half, time, chords, may_be_beside, level + 1); });
  }

  std::optional<ProofKind> kind_that_holds(const SurfacePatch& patch, const ProofTime& time) {
    using enum ProofKind;
    const auto holds = [&](ProofKind kind) { return separation_.holds(kind, depth_mm_); };
    if (holds(center_plane)) return center_plane;
    if (question_.body.is_stepped() && holds(center_ring)) return center_ring;
    if (patch.radius_mm + time.span.path_mm < depth_mm_ + 0.01 && holds(exit_point)) return exit_point;
    return std::nullopt;
  }

  /// Returns whether a cut in the time of the proof contains the block, so that it is gone in a part of that time.
  bool is_removed_late(const SpaceBlock& block, double radius_mm, const ProofTime& time, const ChordList& chords) {
    const LatestInstant start = question_.start_of(time), end = question_.end_of(time);
    const std::size_t last = question_.cuts.size() - 1;
    const bool has_late = std::ranges::any_of(chords, [&](const CutChord* chord) {
      NamedCut stop = chord->start;
      ++stop.last;
      return !is_by(stop, last, start) && is_by(chord->start, last, end);
    });
    ChordList unused;
    return has_late && search_.find(block, radius_mm, chords, end, unused).has_value();
  }

  /// A block within the resolution that is neither removed nor outside of the body stays so, unless it is so in a part of
  /// the time.
  [[nodiscard]] bool is_hopeless(const SurfacePatch& patch, const ProofTime& time, bool is_late) const {
    constexpr double kShare = 0.2;
    return !is_late && patch.radius_mm < kShare * question_.resolution_mm &&
           time.span.path_mm + time.span.swing * (patch.center - time.span.middle.tip).norm() <
               kShare * question_.resolution_mm;
  }

  /// Returns whether a part of the time has more prospects than a part of the block. What the body contains at an instant
  /// must be removed, whatever the time.
  [[nodiscard]] bool prefers_time(const SurfacePatch& patch, const ProofTime& time) const {
    const double moves =
        time.span.path_mm + ((patch.center - time.span.middle.tip).norm() + patch.radius_mm) * time.span.swing;
    const double small = 0.1 * question_.resolution_mm;
    if (patch.radius_mm < small) return true;
    if (moves < small) return false;
    if (is_in_body(patch.center, time)) return false;
    double vague = 0;
    if (time.span.poses.size() == 1)
      for (const Bounds& tip : time.span.poses[0].tip.v) vague = std::max(vague, tip.sup() - tip.inf());
    return separation_.time_loss_mm() + 0.1 * moves + vague > separation_.patch_loss_mm() + 0.2 * patch.radius_mm;
  }

  /// Returns whether a point is deeper in the body than the proof permits, at some instants.
  [[nodiscard]] bool is_in_body(const Vec3& point, const ProofTime& time) const {
    constexpr std::ptrdiff_t kLooks = 8;
    const auto is_inside = [&](const PoseBounds& bounds) {
      return question_.body.nearest(in_tool(bounds.middle(), point)).signed_distance_mm < -depth_mm_;
    };
    const std::ptrdiff_t count = time.last - time.first, step = (count + kLooks - 1) / kLooks;
    for (std::ptrdiff_t k = 0; k < count; k += step)
      if (is_inside(time.first[k].start())) return true;
    return is_inside((time.last - 1)->end()) ||
           question_.body.nearest(in_tool(time.span.middle, point)).signed_distance_mm < -depth_mm_;
  }

  void add(const NamedCut& cut, StockStep named, StockStep same) {
    const bool is_same = last_ && *last_ == cut;
    steps_.push_back(step_of(is_same ? same : named));
    if (!is_same) append_cut(cut, steps_);
    last_ = cut;
  }

  const StockProofQuestion& question_;
  bool has_coaxial_;
  double depth_mm_;
  Separation separation_;
  CutSearch& search_;
  std::uint64_t left_;
  std::string& steps_;
  std::optional<NamedCut> last_;
};

}  // namespace

bool find_stock_proof(const StockProofQuestion& question, CutSearch& search, std::uint64_t max_tries,
                      std::string& steps) {
  if (question.is_empty()) return true;
  const std::size_t before = steps.size();
  for (const bool has_coaxial : {true, false}) {
    search.forget();
    StockFinder finder(question, search, has_coaxial, max_tries, steps);
    if (finder.prove(question.whole_block(), question.whole_time(), nullptr, true, 0)) return true;
    steps.resize(before);
  }
  return false;
}

}  // namespace gouge
