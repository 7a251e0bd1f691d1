#include "lib/stock/clear_groups.h"

#include <algorithm>

#include "lib/base/tolerance.h"
#include "lib/path/path_info.h"

namespace gouge {

namespace {

constexpr std::size_t kQuarters = 4;
// A piece is divided in a group while its radius exceeds the slack of the group by this factor; smaller pieces are left
// to the quarters.
constexpr double kSpaceFirst = 2;
// Pieces of a group for each of its moves, after which the rest is left to its quarters.
constexpr std::size_t kPiecesPerMove = 2;

/// Bounds of all places of a tool during some moves.
struct GroupPlace {
  Vec3 low, high, axis;
  double cone_rad = 0;
};

GroupPlace place_of(const Motion& motion, const Departure& departure) {
  GroupPlace place;
  place.axis = motion.at(0.5).axis;
  place.cone_rad =
      std::max(motion.turn_rad(0, 0.5), motion.turn_rad(0.5, 1)) + departure.axis_rad + Tolerance::kExactDirection;
  place.low = place.high = motion.start().tip;
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s) {
    const MotionSegment& segment = motion.segments()[s];
    const Vec3 sag = Vec3::Constant(motion.rates(segment.t0, segment.t1, s).tip_sag_mm + departure.tip_mm);
    for (const double t : {segment.t0, segment.t1}) {
      const Vec3 tip = motion.tip_at(t, s);
      place.low = place.low.cwiseMin(tip - sag);
      place.high = place.high.cwiseMax(tip + sag);
    }
  }
  return place;
}

GroupPlace together(const std::vector<GroupPlace>& places, std::size_t first, std::size_t last) {
  GroupPlace all = places[first];
  Vec3 axis = Vec3::Zero();
  for (std::size_t k = first; k < last; ++k) {
    all.low = all.low.cwiseMin(places[k].low);
    all.high = all.high.cwiseMax(places[k].high);
    axis += places[k].axis;
  }
  if (axis.norm() > Tolerance::kNoSide) all.axis = axis.normalized();
  for (std::size_t k = first; k < last; ++k) {
    all.cone_rad = std::max(all.cone_rad, angle_between_rad(all.axis, places[k].axis) + places[k].cone_rad);
  }
  return all;
}

class Groups {
 public:
  Groups(const StockQuestion& question, const MoveRange& range) : q_(question), range_(range) {
    for (std::size_t m = range.first; m < range.last; ++m) {
      const Motion motion = q_.history.motion_of(m);
      places_.push_back(place_of(motion, q_.history.departure_from(motion)));
    }
  }

  std::vector<OpenMove> run() {
    prove(0, places_.size(), deep_pieces(q_.body, q_.options.tolerance_mm));
    return std::move(open_);
  }

 private:
  void prove(std::size_t first, std::size_t last, std::vector<ToolPiece> pieces) {
    if (last - first == 1) {
      open_.push_back({range_.first + first, std::move(pieces)});
      return;
    }
    // Sectors lie in the frame of this group alone; cylinders are the same about the axis of every part of it.
    const std::vector<ToolPiece> rest = whole_cylinders(not_free(first, last, std::move(pieces)));
    if (rest.empty()) return;
    const std::size_t quarter = std::max<std::size_t>(1, (last - first + kQuarters - 1) / kQuarters);
    for (std::size_t k = first; k < last; k += quarter) prove(k, std::min(last, k + quarter), rest);
  }

  std::vector<ToolPiece> not_free(std::size_t first, std::size_t last, std::vector<ToolPiece> waiting) {
    const GroupPlace place = together(places_, first, last);
    const std::size_t before = range_.first + first, max_pieces = kPiecesPerMove * (last - first);
    std::vector<ToolPiece> rest;
    const double tips = 0.5 * (place.high - place.low).norm();
    std::size_t examined = 0;
    while (!waiting.empty()) {
      const ToolPiece piece = waiting.back();
      waiting.pop_back();
      const double slack = tips + place.cone_rad * piece.reach_mm();
      if (is_free(piece, place, slack, before)) continue;
      const bool is_small = piece.ball_mm() < kSpaceFirst * slack || piece.ball_mm() < q_.options.tolerance_mm;
      if (is_small || ++examined > max_pieces) {
        rest.push_back(piece);
        continue;
      }
      divide_piece(piece, division_of(piece), q_.body, q_.options.tolerance_mm, waiting);
    }
    return rest;
  }

  static Division division_of(const ToolPiece& piece) {
    if (!piece.is_cylinder()) return longest_extent(piece);
    return piece.height_mm() > piece.r_mm ? Division::height : Division::boxes;
  }

  bool is_free(const ToolPiece& piece, const GroupPlace& place, double slack, std::size_t before) {
    const Vec3 tip = 0.5 * (place.low + place.high), x = place.axis.unitOrthogonal(), y = place.axis.cross(x);
    const PieceDiscs in_tool = discs_of(piece);
    SweptPiece swept;
    swept.slack_mm = slack;
    swept.count = in_tool.count;
    for (std::size_t k = 0; k < in_tool.count; ++k) {
      const Vec3& p = in_tool.discs[k].center;
      const Vec3 at = tip + p.x() * x + p.y() * y + p.z() * place.axis;
      swept.at0[k] = swept.at1[k] = {at, place.axis, in_tool.discs[k].radius_mm};
    }
    return q_.history.is_removed_by_hint(swept, before, hint_) ||
           q_.stock.is_clear_of(swept.start(), slack - q_.options.resolution_mm) ||
           q_.history.find_removal(swept, before, hint_);
  }

  const StockQuestion& q_;
  MoveRange range_;
  std::vector<GroupPlace> places_;
  std::vector<OpenMove> open_;
  CutMove hint_;
};

}  // namespace

std::vector<OpenMove> moves_not_clear(const StockQuestion& question, const MoveRange& range) {
  return Groups(question, range).run();
}

}  // namespace gouge
