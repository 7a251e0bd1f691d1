#include "lib/stock/cut_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/check/reach.h"
#include "lib/path/run_kind.h"
#include "lib/tool/evaluate.h"

namespace gouge {

namespace {

// A span of a tree has no path longer than this many diameters, so that its box is not mostly empty.
constexpr double kSpanDiameters = 2;
// A move whose motions differ by more is not known.
constexpr double kMaxDeparture_rad = 0.5;
// A point that is nearer than this to a place of a tool counts as touched.
constexpr double kNearest_mm = 1e-6;

/// Halves [a, b] until `value` minus the longest way is positive in every part, or a value is negative. Returns whether a
/// value is, or cannot be excluded.
template <typename Value, typename Way>
bool may_reach(double a, double b, const Value& value, const Way& way) {
  const double middle = 0.5 * (a + b), distance = value(middle);
  if (distance < 0) return true;
  const double longest = std::max(way(a, middle), way(middle, b)) + Tolerance::kRounding_mm;
  if (distance >= longest) return false;
  if (longest < kNearest_mm) return true;
  return may_reach(a, middle, value, way) || may_reach(middle, b, value, way);
}

/// Describes the discs at the start of a piece's interval for the search of a tree.
SoughtPiece sought_of(const SweptPiece& piece, double grow_mm) {
  SoughtPiece sought;
  sought.grow_mm = grow_mm;
  sought.disc_mm = std::numeric_limits<double>::max();
  for (const Disc& disc : piece.start()) {
    sought.middle += disc.center / static_cast<double>(piece.count);
    sought.disc_mm = std::min(sought.disc_mm, disc.radius_mm);
  }
  sought.half = piece.start().front().center - sought.middle;
  return sought;
}

/// A span contains the piece at the start of its interval. At the end of it the cutter may be in the next span.
CutWindow about(const MotionSpan& span) {
  const double more = static_cast<double>(span.t1) - static_cast<double>(span.t0);
  return {std::max(0.0, span.from() - more), std::min(1.0, span.until() + more)};
}

/// Bounds from below how far the points of a body are along a unit direction during a span. A point at (r, z) of the tool
/// is at least z cos(a) - r sin(a) above the tip, where a is the angle of the axis to the direction. This changes by at
/// most |(r, z)| for each radian. Over the solid it is least at an end of an element or on the circle of a convex arc.
double lowest_mm(const MotionSpan& span, const CompiledTool& body, const Vec3& up) {
  double tip = 0, cosine = 0, length2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double of = up[static_cast<int>(k)], axis = static_cast<double>(span.axis[k]);
    tip += std::min(of * static_cast<double>(span.low[k]), of * static_cast<double>(span.high[k]));
    cosine += of * axis;
    length2 += axis * axis;
  }
  cosine = std::clamp(cosine / std::sqrt(length2), -1.0, 1.0);
  const Vec2 along(-std::sqrt(1 - cosine * cosine), cosine);
  double least = std::numeric_limits<double>::max(), reach = 0;
  for (const BoundaryElement& e : body.elements) {
    least = std::min({least, along.dot(e.a), along.dot(e.b)});
    reach = std::max({reach, e.a.norm(), e.b.norm()});
    if (e.kind != ElementKind::arc || e.is_reflex) continue;
    least = std::min(least, along.dot(e.center) - e.radius_mm);
    reach = std::max(reach, e.center.norm() + e.radius_mm);
  }
  const double slack = static_cast<double>(span.cone_rad) + Tolerance::kSingleSum;
  return tip + least - slack * reach - Tolerance::kRounding_mm;
}

ToolCylinder cylinder_of(const CompiledTool& tool) { return {tool.r_max_mm, tool.z_min_mm, tool.z_max_mm}; }

/// Bounds the distance of the points of a cylinder from the tip.
double reach_of(const ToolCylinder& cylinder) {
  return Vec2(cylinder.radius_mm, std::max(std::abs(cylinder.z_lo_mm), std::abs(cylinder.z_hi_mm))).norm();
}

}  // namespace

CutHistory::CutHistory(const Toolpath& path, const MotionLaw& law, const std::vector<StockTool>& tools,
                       const StockOptions& options, const CutHistory* earlier, std::span<const StockHead> heads)
    : path_(path),
      law_(law),
      tools_(tools),
      earlier_(earlier),
      heads_(heads),
      resolution_mm_(options.resolution_mm),
      tube_{options.tube.tip_mm, options.tube.axis_rad},
      of_tool_(tools.size()) {
  std::vector<std::vector<MotionSpan>> spans(tools.size());
  is_known_.reserve(path.moves.size());
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const std::optional<Motion> motion = known_motion(i);
    is_known_.push_back(motion.has_value());
    if (!motion) {
      add_unknown(i);
      continue;
    }
    const CompiledTool& bare = tool_of(i).tool->bare;
    const Departure departure = departure_from(*motion);
    if (departure.tip_mm > tube_.tip_mm || departure.axis_rad > tube_.axis_rad) {
      departures_.resize(path.moves.size(), tube_);
      departures_[i] = departure;
    }
    append_spans(*motion, departure, static_cast<std::uint32_t>(i), kSpanDiameters * 2 * bare.r_max_mm,
                 spans[path.moves[i].tool]);
  }
  for (std::size_t k = 0; k < tools.size(); ++k) {
    if (tools[k].tool == nullptr) continue;
    OfTool& of = of_tool_[k];
    of.pieces = convex_pieces(tools[k].tool->bare);
    of.bodies = contour_hulls(tools[k].tool->bare);
    of.cutter = {0, tools[k].tool->bare.z_max_mm, tools[k].tool->bare.z_min_mm};
    for (const ConvexPiece& piece : of.pieces) {
      of.cutter.radius_mm = std::max(of.cutter.radius_mm, piece.r_max_mm);
      of.cutter.z_lo_mm = std::min(of.cutter.z_lo_mm, piece.z_lo_mm);
      of.cutter.z_hi_mm = std::max(of.cutter.z_hi_mm, piece.z_hi_mm);
    }
    of.cutter_reach_mm = reach_of(of.cutter);
    of.reach_mm = reach_of(cylinder_of(tools[k].tool->bare));
    of.tree = std::make_unique<const MotionTree>(std::move(spans[k]));
  }
}

std::optional<Motion> CutHistory::known_motion(std::size_t i) const {
  const Move& move = path_.moves[i];
  if (!move.not_checked_reason.empty() || move.tool == kNone || move.tool >= tools_.size() ||
      tools_[move.tool].tool == nullptr)
    return std::nullopt;
  Motion motion = motion_of(i);
  if (!motion.is_defined() || !motion.is_within(kFarthest_mm)) return std::nullopt;
  if (!(departure_from(motion).axis_rad < kMaxDeparture_rad)) return std::nullopt;
  return motion;
}

Motion CutHistory::motion_of(std::size_t move) const {
  if (std::optional<Motion> link = law_.link_of(path_, move)) return *std::move(link);
  return law_.of(path_, move);
}

// The motion is taken to stay within the box of both positions, grown by the length of the tool.
void CutHistory::add_unknown(std::size_t i) {
  const Move& move = path_.moves[i];
  double reach = std::numeric_limits<double>::infinity();
  if (move.tool != kNone && move.tool < tools_.size() && tools_[move.tool].tool != nullptr) {
    const CompiledTool& bare = tools_[move.tool].tool->bare;
    reach = std::max(bare.z_max_mm, -bare.z_min_mm) + bare.r_max_mm;
    for (const StockHead& head : heads_) reach = std::max(reach, head.reach_mm());
  }
  const Vec3 from = i > 0 ? path_.moves[i - 1].end.tip : move.end.tip;
  unknown_.push_back({i, Vec3(from.cwiseMin(move.end.tip) - Vec3::Constant(reach)),
                      Vec3(from.cwiseMax(move.end.tip) + Vec3::Constant(reach))});
}

bool CutHistory::is_cutting(std::size_t move) const { return removes_stock(path_.moves[move]) && tool_of(move).cuts; }

bool CutHistory::is_straight_with_fixed_axis(std::size_t move) const {
  const Move& of = path_.moves[move];
  return of.has_start && law_.is_divisible(of) && of.curve_kind == CurveKind::none &&
         (path_.start_of(move).axis - of.end.axis).squaredNorm() <
             Tolerance::kExactDirection * Tolerance::kExactDirection;
}

bool CutHistory::covers(std::size_t move, const CutWindow& window, const SweptPiece& piece) const {
  // A point that is deep enough in the cutter on its motion is in the cutter wherever it departs to.
  const OfTool& of = of_tool_[path_.moves[move].tool];
  const CoverMargin margin{piece.slack_mm + departure_of(move).at_mm(of.cutter_reach_mm), resolution_mm_};
  const std::vector<ConvexPiece>& pieces = of.pieces;
  if (is_straight_with_fixed_axis(move)) {
    const Pose &from = path_.start_of(move), &to = path_.moves[move].end;
    const Vec3 way = to.tip - from.tip;
    return is_covered_by({Vec3(from.tip + window.from * way), Vec3((window.until - window.from) * way), to.axis},
                         pieces, piece, margin);
  }
  return is_covered_by(motion_of(move), window, pieces, piece, margin);
}

bool CutHistory::is_removed_by(std::size_t move, double until, const SweptPiece& piece) const {
  return is_known(move) && is_cutting(move) && covers(move, {0, until}, piece);
}

// The value of a convex piece changes by at most the way of a point in its frame. At the instant at which a cutter with a
// fixed axis contains the discs together, or on average, it contains their middle; a cutter that turns contains all of
// them at one instant.
bool CutHistory::may_cover(const MotionSpan& span, const SweptPiece& piece, const Vec3& middle) const {
  const CoverMargin margin{piece.slack_mm, resolution_mm_};
  const Vec3 low(span.low[0], span.low[1], span.low[2]), high(span.high[0], span.high[1], span.high[2]);
  const Vec3 tip = 0.5 * (low + high), axis = Vec3(span.axis[0], span.axis[1], span.axis[2]).normalized();
  const double half = 0.5 * (high - low).norm();
  const bool is_fixed = is_straight_with_fixed_axis(span.move);
  const Disc alone{middle};
  const std::span<const Disc> discs = is_fixed ? std::span(&alone, 1) : piece.start();
  const std::vector<ConvexPiece>& pieces = of_tool_[path_.moves[span.move].tool].pieces;
  return std::any_of(pieces.begin(), pieces.end(), [&](const ConvexPiece& one) {
    const double wanted = margin.largest_value(one);
    return std::all_of(discs.begin(), discs.end(), [&](const Disc& disc) {
      const double far = (disc.center - tip).norm() + disc.radius_mm + half;
      const double slack = half + static_cast<double>(span.cone_rad) * far + Tolerance::kSingleSum * (1 + far);
      return one.value({disc.center, disc.normal, 0}, tip, axis) <= wanted + slack;
    });
  });
}

bool CutHistory::is_removed(const SweptPiece& piece, std::size_t before, CutMove& hint) const {
  return is_removed_by_hint(piece, before, hint) || find_removal(piece, before, hint);
}

bool CutHistory::is_removed_by_hint(const SweptPiece& piece, std::size_t before, const CutMove& hint) const {
  const bool is_before = hint && (hint.program != this || hint.move < before);
  return is_before && hint.program->is_removed_by(hint.move, 1, piece);
}

bool CutHistory::find_removal(const SweptPiece& piece, std::size_t before, CutMove& hint) const {
  if (removes(piece, before, hint)) return true;
  for (const CutHistory* program = earlier_; program != nullptr; program = program->earlier_)
    if (program->removes(piece, program->size(), hint)) return true;
  return false;
}

bool CutHistory::removes(const SweptPiece& piece, std::size_t before, CutMove& hint) const {
  const SoughtPiece sought = sought_of(piece, resolution_mm_ - piece.slack_mm);
  for (const OfTool& of : of_tool_) {
    if (of.tree == nullptr || of.pieces.empty()) continue;
    std::size_t last = kNone;  // the spans of a straight move often follow each other
    const bool is_found =
        of.tree->find(sought, of.cutter, static_cast<std::uint32_t>(before), [&](const MotionSpan& s) {
          if (!is_cutting(s.move) || !may_cover(s, piece, sought.middle)) return false;
          const bool is_whole = is_straight_with_fixed_axis(s.move);
          if (is_whole && s.move == last) return false;
          last = s.move;
          return covers(s.move, is_whole ? CutWindow{} : about(s), piece);
        });
    if (!is_found) continue;
    hint = {this, last};
    return true;
  }
  return false;
}

bool CutHistory::reaches(std::size_t move, const CompiledTool& body, double t0, double t1, std::uint32_t segment,
                         const Vec3& point, double within_mm) const {
  const MovePlaces places = places_of(move, segment);
  const double within = within_mm + departure_of(move).at_mm(of_tool_[path_.moves[move].tool].reach_mm);
  return may_reach(
      t0, t1, [&](double t) { return signed_distance_mm(body, places.at(t), point) - within; },
      [&](double a, double b) { return places.way_mm(a, b, point); });
}

bool CutHistory::is_missed_by(std::size_t move, double until, const Vec3& point) const {
  const Motion motion = motion_of(move);
  for (std::uint32_t s = 0; s < motion.segments().size(); ++s) {
    const MotionSegment& segment = motion.segments()[s];
    if (segment.t0 > until) break;
    if (reaches(move, tool_of(move).tool->cutting, segment.t0, std::min(segment.t1, until), s, point)) return false;
  }
  return true;
}

CutMove CutHistory::unknown_near(const Vec3& point, std::size_t before, double within_mm) const {
  if (earlier_ != nullptr) {
    if (const CutMove unknown = earlier_->unknown_near(point, earlier_->size(), within_mm)) return unknown;
  }
  for (const Unknown& unknown : unknown_) {
    if (unknown.move >= before) break;
    if ((point.array() + within_mm >= unknown.low.array()).all() &&
        (point.array() - within_mm <= unknown.high.array()).all())
      return {this, unknown.move};
  }
  return {};
}

bool CutHistory::meets(const MotionSpan& span, const CutBall& ball) const {
  const ToolVariants& tool = *tool_of(span.move).tool;
  const auto reach = [&](const CompiledTool& body) {
    return reaches(span.move, body, span.from(), span.until(), span.segment, ball.center, ball.radius_mm);
  };
  if (ball.up.isZero(0)) return reach(tool.bare);
  // A body that stays above the plane of the ball does not meet what is left of it.
  const double plane_mm = ball.up.dot(ball.center) + ball.height_mm;
  for (const CompiledTool* body : {&tool.cutting, &tool.non_cutting}) {
    if (!body->elements.empty() && !(lowest_mm(span, *body, ball.up) > plane_mm) && reach(*body)) return true;
  }
  return false;
}

bool CutHistory::meets(const StockHead& head, const MotionSpan& span, const CutBall& ball) const {
  const double plane_mm = ball.up.dot(ball.center) + ball.height_mm;
  if (!ball.up.isZero(0) && lowest_mm(span, head.around(), ball.up) > plane_mm) return false;
  // Where the tool may depart, the head departs farther than the tool does.
  const double beyond = std::max(0.0, head.reach_mm() - of_tool_[path_.moves[span.move].tool].reach_mm);
  const double within = ball.radius_mm + departure_of(span.move).axis_rad * beyond;
  if (!reaches(span.move, head.around(), span.from(), span.until(), span.segment, ball.center, within)) return false;
  const Motion motion = motion_of(span.move);
  if (!has_known_turn(motion) || !departure_of(span.move).is_none()) return true;
  const BodyMotion moving(motion);
  return may_reach(
      span.from(), span.until(),
      [&](double t) { return head.signed_distance_mm(moving.at(t).inverse().point(ball.center)) - ball.radius_mm; },
      [&](double a, double b) {
        const MotionRates rates = moving.rates(a, b, span.segment);
        const double far = (ball.center - motion.tip_at(a, span.segment)).norm() + rates.tip_path_mm;
        return rates.tip_path_mm + rates.turn_rad * far;
      });
}

bool CutHistory::is_untouched(const Vec3& point, std::size_t before, CutMove& hint) const {
  return is_untouched(CutBall{point}, before, hint);
}

bool CutHistory::is_untouched(const CutBall& ball, std::size_t before, CutMove& hint) const {
  if (unknown_near(ball.center, before, ball.radius_mm)) return false;
  const bool is_before = hint && (hint.program != this || hint.move < before);
  if (is_before && ball.up.isZero(0) && hint.program->is_straight_with_fixed_axis(hint.move) &&
      hint.program->reaches(hint.move, hint.program->tool_of(hint.move).tool->bare, 0, 1, 0, ball.center,
                            ball.radius_mm))
    return false;
  if (touches(ball, before, hint)) return false;
  for (const CutHistory* program = earlier_; program != nullptr; program = program->earlier_)
    if (program->touches(ball, program->size(), hint)) return false;
  return true;
}

bool CutHistory::touches(const CutBall& ball, std::size_t before, CutMove& hint) const {
  for (std::size_t k = 0; k < of_tool_.size(); ++k) {
    if (of_tool_[k].tree == nullptr) continue;
    const auto is_touched = [&](const MotionSpan& s) {
      const bool does = meets(s, ball);
      if (does) hint = {this, s.move};
      return does;
    };
    for (const BodyHulls& body : of_tool_[k].bodies) {
      if (of_tool_[k].tree->find({ball.center, Vec3::Zero(), 0, ball.radius_mm}, body.around,
                                 static_cast<std::uint32_t>(before), is_touched))
        return true;
    }
    for (const StockHead& head : heads_) {
      const auto is_touched_by_head = [&](const MotionSpan& s) { return meets(head, s, ball); };
      if (of_tool_[k].tree->find({ball.center, Vec3::Zero(), 0, ball.radius_mm}, head.cylinder(),
                                 static_cast<std::uint32_t>(before), is_touched_by_head))
        return true;
    }
  }
  return false;
}

std::optional<PassedBy> CutHistory::nearest_cut(const Vec3& point, std::size_t before, double within_mm) const {
  std::optional<PassedBy> nearest;
  constexpr double kGrowth = 4;
  for (double reach = resolution_mm_; !nearest && reach < kGrowth * within_mm; reach *= kGrowth) {
    add_nearest(point, before, reach, nearest);
    for (const CutHistory* program = earlier_; program != nullptr; program = program->earlier_)
      program->add_nearest(point, program->size(), reach, nearest);
  }
  return nearest;
}

void CutHistory::add_nearest(const Vec3& point, std::size_t before, double reach_mm,
                             std::optional<PassedBy>& nearest) const {
  for (std::size_t k = 0; k < of_tool_.size(); ++k) {
    if (of_tool_[k].tree == nullptr) continue;
    of_tool_[k].tree->find(
        {point, Vec3::Zero(), 0, reach_mm}, cylinder_of(tools_[k].tool->cutting), static_cast<std::uint32_t>(before),
        [&](const MotionSpan& s) {
          if (!is_cutting(s.move)) return false;
          const double at = nearest_distance_mm(motion_of(s.move), s, tools_[k].tool->cutting, point);
          if (at > reach_mm) return false;
          const bool is_equal = nearest && !(nearest->distance_mm < at) && !(at < nearest->distance_mm);
          const bool is_nearer = !nearest || at < nearest->distance_mm;
          if (is_nearer || (is_equal && nearest->cut.program == this && s.move < nearest->cut.move))
            nearest = PassedBy{at, {this, s.move}};
          return false;
        });
  }
}

}  // namespace gouge
