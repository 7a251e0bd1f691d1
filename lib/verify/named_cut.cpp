#include "lib/verify/named_cut.h"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "lib/verify/certificate_text.h"
#include "lib/verify/claimed_pieces.h"
#include "lib/verify/contour_radii.h"

namespace gouge {

bool is_by(const NamedCut& cut, std::size_t last, const LatestInstant& latest) {
  if (cut.program != last) return cut.program < last;
  if (cut.move != latest.move) return cut.move < latest.move;
  return std::tuple(std::size_t{cut.piece}, cut.share()) <= std::tuple(latest.piece, latest.share);
}

void append_cut(const NamedCut& cut, std::string& steps) {
  for (const std::uint64_t value : {cut.program, cut.move, cut.piece, cut.level, cut.first, cut.last - cut.first})
    put_number(steps, value);
}

std::optional<NamedCut> take_cut(std::string_view& steps) {
  NamedCut cut;
  for (std::uint64_t* value : {&cut.program, &cut.move, &cut.piece, &cut.level, &cut.first, &cut.last}) {
    const auto number = take_number(steps);
    if (!number) return std::nullopt;
    *value = *number;
  }
  if (cut.level > kMaxCutLevel || cut.first > 1ULL << cut.level || cut.last > (1ULL << cut.level) - cut.first)
    return std::nullopt;
  cut.last += cut.first;
  return cut;
}

bool is_straight(const MotionPiece& piece) {
  constexpr double kStraight_mm = 1e-10, kSteadyAxis = 1e-13;
  return piece.sag_mm() <= kStraight_mm && length(piece.end().axis - piece.start().axis).sup() <= kSteadyAxis;
}

CutPrograms::CutPrograms(const std::vector<ClaimedProgram>& programs) {
  for (const ClaimedProgram& program : programs) programs_.push_back(std::make_unique<const ProgramCuts>(program));
}

const ToolContour* CutPrograms::cutter_of(const NamedCut& cut) const {
  if (cut.program >= programs_.size()) return nullptr;
  const ProgramCuts& program = *programs_[cut.program];
  if (cut.move >= program.path().moves.size() || !program.cuts(cut.move)) return nullptr;
  const CutterForms& forms = *program.forms_of(cut.move);
  return forms.cutting.is_closed() ? &forms.cutting : nullptr;
}

std::optional<CutPoses> CutPrograms::poses_of(const NamedCut& cut) const {
  const auto pieces = claimed_pieces(programs_[cut.program]->scene(), cut.move);
  if (!pieces || cut.piece >= pieces->size()) return std::nullopt;
  const MotionPiece& piece = (*pieces)[cut.piece];
  if (cut.first != cut.last && !is_straight(piece)) return std::nullopt;
  const PoseBounds first = pose_at_place(piece, cut.level, cut.first);
  return CutPoses{first, cut.first == cut.last ? first : pose_at_place(piece, cut.level, cut.last)};
}

PoseBounds pose_at_place(const MotionPiece& piece, std::uint64_t level, std::uint64_t place) {
  if (place == 1ULL << level) return piece.end();
  MotionPiece at = piece;
  for (; place != 0; --level) {
    const std::uint64_t half = 1ULL << (level - 1);
    if (place == half) return at.halves()[0].end();
    at = at.halves()[place > half ? 1 : 0];
    if (place > half) place -= half;
  }
  return at.start();
}

double share_on_way(const Vec3& point, const Vec3& way, const Vec3& axis) {
  const Vec3 across = way - way.dot(axis) * axis;
  const double square = across.squaredNorm();
  return square > 0 ? std::clamp(point.dot(across) / square, 0.0, 1.0) : 0.0;
}

Bounds heights_between(const SpaceBlock& block, const CutPoses& poses) {
  const Bounds3& axis = poses.first.axis;
  Bounds half(0);
  for (const Vec3& arm : block.arms) half += CGAL::abs(dot(Bounds3(arm), axis));
  const Bounds first = dot(Bounds3(block.center) - poses.first.tip, axis),
               last = dot(Bounds3(block.center) - poses.last.tip, axis);
  const Bounds both = hull(first, last);
  return {(both - half).inf(), (both + half).sup()};
}

// A cylinder that is smaller by s = wider / sqrt(2) on each side is within `wider` of all points.
bool has_cylinder(const ToolContour& cutter, double radius_mm, const Bounds& heights, double wider_mm) {
  constexpr double kRounding_mm = 1e-9;  // of a straight cut
  const Bounds shrink(std::max(0.0, wider_mm - kRounding_mm) * (1 - 1e-9) / std::numbers::sqrt2);
  double low = (Bounds(heights.inf()) + shrink).inf(), high = (Bounds(heights.sup()) - shrink).sup();
  if (low > high) low = high = 0.5 * (heights.inf() + heights.sup());
  const double free_mm = free_radius_mm(cutter, low, high);
  return free_mm > 0 && (Bounds(radius_mm) - shrink).sup() <= free_mm;
}

// What a cylinder passes on a straight line is convex, and so is the distance from it. So the corners suffice.
bool is_within_cutter(const ToolContour& cutter, const CutPoses& poses, const SpaceBlock& block, double wider_mm) {
  const Bounds3 &axis = poses.first.axis, way = poses.last.tip - poses.first.tip;
  double radius = 0;
  for (const Vec3& corner : block.corners()) {
    const Bounds3 from = Bounds3(corner) - poses.first.tip;
    const Bounds share(share_on_way(from.middle(), way.middle(), axis.middle()));
    radius = std::max(radius, length(cross(from - share * way, axis)).sup());
  }
  return has_cylinder(cutter, radius, heights_between(block, poses), wider_mm);
}

}  // namespace gouge
