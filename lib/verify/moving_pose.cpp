#include "lib/verify/moving_pose.h"

#include <algorithm>
#include <cmath>

#include "lib/path/run_kind.h"

namespace gouge {
namespace {

constexpr double kAxisRounding = 4e-16;  // error of a component of a unit vector that was written in doubles
constexpr double kMaxPieces = 4096;

PoseBounds bounds_of(const Pose& pose) { return {Bounds3(pose.tip), widened(Bounds3(pose.axis), kAxisRounding)}; }

Bounds3 midway(const Bounds3& a, const Bounds3& b) { return Bounds(0.5) * (a + b); }
PoseBounds midway(const PoseBounds& a, const PoseBounds& b) {
  return {midway(a.tip, b.tip), direction_of(a.axis + b.axis)};
}

/// Returns a bound of the angle between two unit vectors. From the chord: asin x <= x + (pi / 2 - 1) x^3.
double largest_angle(const Bounds3& a, const Bounds3& b) {
  const Bounds c = length(b - a);
  return (c + Bounds(0.1428) * c * c * c).sup();
}

/// Returns the axis at a share of a great circle. If both ends almost agree, it returns all axes between them.
Bounds3 axis_at(const PoseBounds& from, const PoseBounds& to, const Bounds& share) {
  const Bounds3 sum = from.axis + to.axis, difference = to.axis - from.axis;
  if (length(difference).sup() < 1e-7) return widened(hull(from.axis, to.axis), 1e-14);
  // With m the middle and h half the angle: a(s) = cos((2 s - 1) h) m + sin((2 s - 1) h) n, where n has the direction
  // of the difference.
  const double half = std::atan2(length(difference).sup(), length(sum).sup());
  const Bounds h = widened(Bounds(half), 1e-13);
  const SineCosine at = sine_cosine((Bounds(2) * share - Bounds(1)) * h);
  return at.cosine * direction_of(sum) + at.sine * direction_of(difference);
}

/// The pose of the joints is that of the file: their angles give its axis, and the tip follows by construction.
bool is_pose_of_file(const PoseBounds& a, const PoseBounds& b) {
  constexpr double kNear_mm = 1e-6, kNearAxis = 1e-8;
  return length(a.tip - b.tip).sup() < kNear_mm && length(a.axis - b.axis).sup() < kNearAxis;
}

bool is_finite(const Pose& pose) { return pose.tip.allFinite() && pose.axis.allFinite(); }

bool is_finite(const PathSpline& spline) {
  return std::ranges::all_of(spline.pieces, [](const SplinePiece& piece) {
    return std::isfinite(piece.u0) && std::isfinite(piece.u1) &&
           std::ranges::all_of(piece.control, [](const Vec3& v) { return v.allFinite(); });
  });
}

}  // namespace

MotionPiece::MotionPiece(const PoseBounds& from, const PoseBounds& to) : ends_{from, to} { bound_chord(); }

// A curve whose second derivative is at most M over a unit of time is within M / 8 of its chord.
void MotionPiece::bound_chord() {
  const Bounds angle(largest_angle(ends_[0].axis, ends_[1].axis));
  bend_ = (angle * angle / Bounds(8)).sup();
  Bounds second(0);
  if (const Turn* t = std::get_if<Turn>(&curve_)) {
    const Bounds turned(t->angle), radius(std::max(t->radius[0].sup(), t->radius[1].sup()));
    second = turned * (radius * turned + Bounds(2) * CGAL::abs(t->radius[1] - t->radius[0]));
  } else if (const Bezier* p = std::get_if<Bezier>(&curve_)) {
    const auto bulge = [&](std::size_t k) { return length((*p)[k] - Bounds(2) * (*p)[k + 1] + (*p)[k + 2]); };
    second = Bounds(6) * Bounds(std::max(bulge(0).sup(), bulge(1).sup()));
  }
  sag_ = (second / Bounds(8)).sup();
  if (!chain_) return;
  bend_ = (chain_->axis_acceleration() / Bounds(8) + Bounds(chain_->slack)).sup();
  if (chain_->moves_tip) sag_ = (chain_->tip_acceleration() / Bounds(8) + Bounds(chain_->slack_mm)).sup();
}

std::array<MotionPiece, 2> MotionPiece::halves() const {
  PoseBounds middle = midway(ends_[0], ends_[1]);
  std::array<MotionPiece, 2> both{*this, *this};
  if (const Turn* t = std::get_if<Turn>(&curve_)) {
    Turn first = *t, second = *t;
    first.radial[1] = second.radial[0] = direction_of(t->radial[0] + t->radial[1]);
    first.radius[1] = second.radius[0] = Bounds(0.5) * (t->radius[0] + t->radius[1]);
    first.height[1] = second.height[0] = Bounds(0.5) * (t->height[0] + t->height[1]);
    first.rest[1] = second.rest[0] = midway(t->rest[0], t->rest[1]);
    first.angle = second.angle = 0.5 * t->angle;
    middle.tip = first.tip(1);
    both[0].curve_ = first;
    both[1].curve_ = second;
  } else if (const Bezier* p = std::get_if<Bezier>(&curve_)) {
    const Bounds3 ab = midway((*p)[0], (*p)[1]), bc = midway((*p)[1], (*p)[2]), cd = midway((*p)[2], (*p)[3]);
    const Bounds3 abc = midway(ab, bc), bcd = midway(bc, cd);
    middle.tip = midway(abc, bcd);
    both[0].curve_ = Bezier{(*p)[0], ab, abc, middle.tip};
    both[1].curve_ = Bezier{middle.tip, bcd, cd, (*p)[3]};
  }
  if (chain_) {
    const std::array<ChainSpan, 2> spans = chain_->halves();
    both[0].chain_ = spans[0];
    both[1].chain_ = spans[1];
    const PoseBounds pose = spans[0].pose(1);
    middle = {chain_->moves_tip ? pose.tip : middle.tip, pose.axis};
  }
  both[0].ends_[1] = both[1].ends_[0] = middle;
  for (MotionPiece& half : both) half.bound_chord();
  return both;
}

std::optional<std::vector<MotionPiece>> MotionPiece::along_arc(const PoseBounds& from, const PoseBounds& to,
                                                               const PathArc& arc) {
  const double quarters = std::ceil(std::abs(arc.sweep_rad) / 1.5);
  if (!(quarters <= kMaxPieces) || !arc.center.allFinite() || !arc.axis.allFinite()) return std::nullopt;
  const auto count = static_cast<std::size_t>(std::max(1.0, quarters));
  Turn turn;
  turn.center = Bounds3(arc.center);
  turn.axis = Bounds3(arc.axis);
  const Bounds3 a = from.tip - turn.center, b = to.tip - turn.center;
  const Bounds h0 = dot(a, turn.axis), h1 = dot(b, turn.axis);
  const Bounds3 out = a - h0 * turn.axis;
  const Bounds r0 = length(out), r1 = length(b - h1 * turn.axis);
  if (!(r0.inf() > 1e-9)) return std::nullopt;
  const Bounds step = Bounds(arc.sweep_rad) / Bounds(static_cast<double>(count));
  const SineCosine by = sine_cosine(step);
  std::vector<Bounds3> radial{direction_of(out)};
  for (std::size_t k = 0; k < count; ++k)
    radial.push_back(by.cosine * radial.back() + by.sine * cross(turn.axis, radial.back()));
  const Bounds3 rest = to.tip - (turn.center + r1 * radial.back() + h1 * turn.axis);
  turn.angle = CGAL::abs(step).sup();
  std::vector<MotionPiece> pieces;
  PoseBounds last = from;
  for (std::size_t k = 0; k < count; ++k) {
    for (const std::size_t end : {0U, 1U}) {
      const Bounds share = Bounds(static_cast<double>(k + end)) / Bounds(static_cast<double>(count));
      turn.radial[end] = radial[k + end];
      turn.radius[end] = r0 + share * (r1 - r0);
      turn.height[end] = h0 + share * (h1 - h0);
      turn.rest[end] = share * rest;
    }
    PoseBounds next = to;
    if (k + 1 < count) {
      const Bounds share = Bounds(static_cast<double>(k + 1)) / Bounds(static_cast<double>(count));
      next = {turn.tip(1), axis_at(from, to, share)};
    }
    MotionPiece piece(last, next);
    piece.curve_ = turn;
    piece.bound_chord();
    pieces.push_back(piece);
    last = next;
  }
  return pieces;
}

std::vector<MotionPiece> MotionPiece::along_spline(const PoseBounds& from, const PoseBounds& to,
                                                   const PathSpline& spline) {
  std::vector<MotionPiece> pieces;
  for (std::size_t k = 0; k < spline.pieces.size(); ++k) {
    Bezier control;
    for (std::size_t i = 0; i < 4; ++i) control[i] = Bounds3(spline.pieces[k].control[i]);
    if (k == 0) control[0] = from.tip;
    if (k + 1 == spline.pieces.size()) control[3] = to.tip;
    const Bounds u0(spline.pieces[k].u0), u1(spline.pieces[k].u1);
    MotionPiece piece({control[0], k == 0 ? from.axis : axis_at(from, to, u0)},
                      {control[3], k + 1 == spline.pieces.size() ? to.axis : axis_at(from, to, u1)});
    piece.curve_ = control;
    piece.bound_chord();
    pieces.push_back(piece);
  }
  return pieces;
}

// Makes the pieces of a rapid on which all axes move at the same speed until each of them arrives.
std::vector<MotionPiece> MotionPiece::dogleg(const Pose& from, const Pose& to) {
  const Vec3 way = to.tip - from.tip;
  const double longest = way.cwiseAbs().maxCoeff();
  std::vector<Bounds> breaks{Bounds(0)};
  std::vector<double> lengths{std::abs(way.x()), std::abs(way.y()), std::abs(way.z())};
  std::sort(lengths.begin(), lengths.end());
  for (const double one : lengths)
    if (one > 0 && Bounds(one / longest).sup() > breaks.back().sup()) breaks.push_back(Bounds(one) / Bounds(longest));
  const PoseBounds first = bounds_of(from), end = bounds_of(to);
  std::vector<MotionPiece> pieces;
  PoseBounds last = first;
  for (std::size_t k = 1; k < breaks.size(); ++k) {
    PoseBounds next = end;
    if (k + 1 < breaks.size()) {
      next.axis = axis_at(first, end, breaks[k]);
      for (int c = 0; c < 3; ++c) {
        const Bounds gone = breaks[k] * Bounds(longest), most(std::abs(way[c]));
        const Bounds path(std::min(gone.inf(), most.inf()), std::min(gone.sup(), most.sup()));
        next.tip.v[static_cast<std::size_t>(c)] = Bounds(from.tip[c]) + (way[c] < 0 ? -path : path);
      }
    }
    pieces.push_back(MotionPiece(last, next));
    last = next;
  }
  if (pieces.empty()) pieces.push_back(MotionPiece(first, end));
  return pieces;
}

std::optional<std::vector<MotionPiece>> MotionPiece::along_curve(const Toolpath& path, const Move& move,
                                                                 const PoseBounds& from, const PoseBounds& to) {
  if (move.curve_kind == CurveKind::arc) {
    if (move.curve >= path.arcs.size()) return std::nullopt;
    return along_arc(from, to, path.arcs[move.curve]);
  }
  if (move.curve >= path.splines.size() || path.splines[move.curve].pieces.empty()) return std::nullopt;
  if (!is_finite(path.splines[move.curve])) return std::nullopt;
  return along_spline(from, to, path.splines[move.curve]);
}

void MotionPiece::run_by(const ChainSpan& span) {
  chain_ = span;
  for (const std::size_t end : {0U, 1U}) {
    const PoseBounds pose = span.pose(end);
    ends_[end].axis = pose.axis;
    if (span.moves_tip) ends_[end].tip = pose.tip;
  }
  bound_chord();
}

std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t index, bool is_dogleg) {
  const Move& move = path.moves[index];
  const bool has_path_here = move.has_start || move.is_linked;
  if (!is_finite(move.end) || (has_path_here && (index == 0 || !is_finite(path.start_of(index))))) return std::nullopt;
  const PoseBounds end = bounds_of(move.end);  // only after the test for finite numbers, because intervals need numbers
  if (!has_path_here) return std::vector<MotionPiece>{MotionPiece(end, end)};
  const Pose& start = path.start_of(index);
  const PoseBounds from = bounds_of(start);
  if (!(length(from.axis + end.axis).inf() > 1e-6)) return std::nullopt;
  if (move.has_start && move.curve_kind != CurveKind::none) return MotionPiece::along_curve(path, move, from, end);
  if (move.has_start && runs_rapid(move) && is_dogleg) return MotionPiece::dogleg(start, move.end);
  return std::vector<MotionPiece>{MotionPiece(from, end)};
}

std::optional<std::vector<MotionPiece>> motion_pieces(const Toolpath& path, std::size_t index,
                                                      const ChainMotion& chain) {
  const Move& move = path.moves[index];
  if (index == 0 || !is_finite(move.end) || !is_finite(path.start_of(index))) return std::nullopt;
  if (chain.joints->chain.size() != kChainJoints) return std::nullopt;
  const Pose& start = path.start_of(index);
  const PoseBounds from = bounds_of(start), end = bounds_of(move.end);
  const auto v0 = chain_values(*chain.joints, chain.from, start.tip),
             v1 = chain_values(*chain.joints, chain.to, move.end.tip);
  if (!v0 || !v1) return std::nullopt;
  std::optional<std::vector<MotionPiece>> pieces = std::vector<MotionPiece>{MotionPiece(from, end)};
  if (move.curve_kind == CurveKind::none && chain.run != ClaimedRun::rotary) {
    const auto spans = chain_spans(*chain.joints, chain.run, *v0, *v1);
    if (!spans) return std::nullopt;
    pieces->resize(spans->size(), pieces->front());
    for (std::size_t k = 0; k < spans->size(); ++k) (*pieces)[k].run_by((*spans)[k]);
  } else {
    if (move.curve_kind != CurveKind::none) pieces = MotionPiece::along_curve(path, move, from, end);
    if (!pieces) return std::nullopt;
    const auto share = [&](std::size_t k) {
      if (k == 0) return Bounds(0);
      if (move.curve_kind == CurveKind::spline) return Bounds(path.splines[move.curve].pieces[k - 1].u1);
      return Bounds(static_cast<double>(k)) / Bounds(static_cast<double>(pieces->size()));
    };
    for (std::size_t k = 0; k < pieces->size(); ++k) {
      const std::array<ChainValues, 2> values{values_at(*v0, *v1, share(k)), values_at(*v0, *v1, share(k + 1))};
      (*pieces)[k].run_by({chain.joints, values, false, 0, 0});
    }
  }
  // At its ends the tool is where the file states it, which is the pose of its joints but for rounding.
  PoseBounds &first = pieces->front().ends_[0], &last = pieces->back().ends_[1];
  if (!is_pose_of_file(first, from) || !is_pose_of_file(last, end)) return std::nullopt;
  first = {hull(first.tip, from.tip), hull(first.axis, from.axis)};
  last = {hull(last.tip, end.tip), hull(last.axis, end.axis)};
  return pieces;
}

namespace {

Vec3 axis_at(const Vec3& a, const Vec3& b, double t) {
  const Vec3 sum = a + b, difference = b - a;
  const double half = std::atan2(difference.norm(), sum.norm());
  if (half < 1e-9) return ((1 - t) * a + t * b).normalized();
  const double turned = (2 * t - 1) * half;
  return (std::cos(turned) * sum.normalized() + std::sin(turned) * difference.normalized()).normalized();
}

Vec3 tip_on_arc(const PathArc& arc, const Vec3& from, const Vec3& to, double t) {
  const auto at = [&](double share) {
    const Vec3 a = from - arc.center, b = to - arc.center;
    const double h0 = a.dot(arc.axis), h1 = b.dot(arc.axis);
    const Vec3 out = a - h0 * arc.axis, e1 = out.normalized(), e2 = arc.axis.cross(e1);
    const double r = out.norm() + share * ((b - h1 * arc.axis).norm() - out.norm()), turned = share * arc.sweep_rad;
    return Vec3(arc.center + r * (std::cos(turned) * e1 + std::sin(turned) * e2) + (h0 + share * (h1 - h0)) * arc.axis);
  };
  return at(t) + t * (to - at(1));
}

Vec3 tip_of_dogleg(const Vec3& from, const Vec3& to, double t) {
  const Vec3 way = to - from;
  const double gone = t * way.cwiseAbs().maxCoeff();
  Vec3 tip = from;
  for (int k = 0; k < 3; ++k) tip[k] += std::copysign(std::min(std::abs(way[k]), gone), way[k]);
  return tip;
}

}  // namespace

Pose pose_at(const Toolpath& path, std::size_t index, double t, bool is_dogleg) {
  const Move& move = path.moves[index];
  if (!move.has_start || t >= 1) return move.end;
  const Pose& start = path.start_of(index);
  if (t <= 0) return start;
  Pose pose{(1 - t) * start.tip + t * move.end.tip, axis_at(start.axis, move.end.axis, t)};
  if (move.curve_kind == CurveKind::arc) {
    pose.tip = tip_on_arc(path.arcs[move.curve], start.tip, move.end.tip, t);
  } else if (move.curve_kind == CurveKind::spline) {
    const std::vector<SplinePiece>& pieces = path.splines[move.curve].pieces;
    const auto at = std::find_if(pieces.begin(), pieces.end() - 1, [&](const SplinePiece& p) { return t <= p.u1; });
    SplinePiece piece = *at;
    if (at == pieces.begin()) piece.control[0] = start.tip;
    if (at == pieces.end() - 1) piece.control[3] = move.end.tip;
    pose.tip = piece.at(t);
  } else if (runs_rapid(move) && is_dogleg) {
    pose.tip = tip_of_dogleg(start.tip, move.end.tip, t);
  }
  return pose;
}

}  // namespace gouge
