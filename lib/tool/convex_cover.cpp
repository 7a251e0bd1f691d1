#include "lib/tool/convex_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/tolerance.h"
#include "lib/geom/vec.h"
#include "lib/tool/rising_contour.h"

namespace gouge {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
// A contour of more than kMaxExact lines and arcs is covered by its chords. Each chord spans at most kMaxHeld elements.
// The tolerance grows until there are at most kMaxChords chords, if possible.
constexpr std::size_t kMaxExact = 64, kMaxChords = 256, kMaxHeld = 64;
constexpr double kMaxFill = 0.02;  // maximum height of a filled overhang, as a share of the tool's size
constexpr double kFinest = 1e-5;   // initial distance of the contour from its chords, as a share of the tool's size

Vec2 direction_at(const BoundaryElement& e, const Vec2& point) {
  if (e.kind == ElementKind::segment) return (e.b - e.a).normalized();
  const Vec2 out = (point - e.center).normalized();
  return e.is_reflex ? Vec2(out.y(), -out.x()) : Vec2(-out.y(), out.x());
}

bool is_rising(const BoundaryElement& e) {
  return direction_at(e, e.a).y() >= -Tolerance::kTangent && direction_at(e, e.b).y() >= -Tolerance::kTangent &&
         e.b.y() >= e.a.y();
}

/// Returns the maximum distance of a line or arc from the segment between two points.
double farthest_off(const BoundaryElement& e, const Vec2& from, const Vec2& to) {
  const Vec2 chord = to - from;
  const auto off = [&](const Vec2& p) {
    const double t = chord.squaredNorm() > 0 ? std::clamp(chord.dot(p - from) / chord.squaredNorm(), 0.0, 1.0) : 0;
    return (p - from - t * chord).norm();
  };
  const double rise = e.kind == ElementKind::arc ? (e.center + e.radius_mm * e.normal - 0.5 * (e.a + e.b)).norm() : 0.0;
  return std::max(off(e.a), off(e.b)) + rise;
}

/// Returns chords of a contour as segments. Their `radius_mm` is the maximum distance of the contour from them. Level
/// lines are copied, because steps begin and end pieces.
std::vector<BoundaryElement> chords_of(const std::vector<const BoundaryElement*>& curves, double max_off_mm) {
  std::vector<BoundaryElement> chords;
  for (std::size_t first = 0; first < curves.size();) {
    BoundaryElement chord = *curves[first];
    chord.kind = ElementKind::segment;
    chord.is_reflex = false;
    chord.radius_mm = farthest_off(*curves[first], chord.a, chord.b);
    const auto is_level = [](const BoundaryElement& e) { return !(std::abs(e.b.y() - e.a.y()) > 0); };
    std::size_t last = first + 1;
    for (; last < curves.size() && last < first + kMaxHeld; ++last) {
      if (is_level(*curves[first]) || is_level(*curves[last])) break;
      double off = 0;
      for (std::size_t k = first; k <= last && off <= max_off_mm; ++k)
        off = std::max(off, farthest_off(*curves[k], chord.a, curves[last]->b));
      if (off > max_off_mm) break;
      chord.b = curves[last]->b;
      chord.radius_mm = off;
    }
    chords.push_back(chord);
    first = last;
  }
  return chords;
}

/// Consecutive elements that fit in one piece.
struct Run {
  std::vector<const BoundaryElement*> elements;
  double arc_radius_mm = 0;
  std::size_t corners = 0;

  [[nodiscard]] bool takes(const BoundaryElement& e) const {
    if (elements.empty()) return true;
    const BoundaryElement& last = *elements.back();
    const bool is_concave = [](const BoundaryElement& x) { return x.kind == ElementKind::arc && x.is_reflex; }(e);
    if (is_concave || (last.kind == ElementKind::arc && last.is_reflex)) return false;
    if (corners + 3 >= CoverPiece::kMaxChain) return false;
    if ((last.b - e.a).squaredNorm() > 0) return false;  // there is a step between them
    const double turn = cross(direction_at(last, last.b), direction_at(e, e.a));
    const bool has_arc = arc_radius_mm > 0 || e.kind == ElementKind::arc;
    if (has_arc && std::abs(turn) > Tolerance::kTangent) return false;
    if (has_arc && corners > 0 && arc_radius_mm <= 0) return false;  // sharp corners cannot become round
    if (e.kind == ElementKind::arc && arc_radius_mm > 0 &&
        std::abs(e.radius_mm - arc_radius_mm) > Tolerance::kRounding_mm)
      return false;
    return turn >= -Tolerance::kTangent;
  }

  void add(const BoundaryElement& e) {
    if (e.kind == ElementKind::arc && !e.is_reflex) arc_radius_mm = e.radius_mm;
    const bool is_arc = e.kind == ElementKind::arc;
    const bool is_after_line = !elements.empty() && elements.back()->kind != ElementKind::arc;
    const bool is_sharp =
        is_after_line && !is_arc && cross(direction_at(*elements.back(), e.a), direction_at(e, e.a)) > 0;
    if (is_sharp || is_arc) ++corners;
    elements.push_back(&e);
  }
};

class CoverMaker {
 public:
  explicit CoverMaker(const CompiledTool& tool) : tool_(tool) {
    cover_.size_mm = std::sqrt(tool.r_max_mm * tool.r_max_mm +
                               std::max(tool.z_min_mm * tool.z_min_mm, tool.z_max_mm * tool.z_max_mm));
    for (const BoundaryElement& e : tool.elements) {
      if (e.kind != ElementKind::vertex) curves_.push_back(&e);
    }
  }

  ConvexCover make() {
    bool is_stack = std::all_of(curves_.begin(), curves_.end(), [](const auto* e) { return is_rising(*e); });
    if (!is_stack) is_stack = take_filled();
    if (curves_.size() > kMaxExact) take_chords();
    if (is_stack) {
      add_runs();
    } else {
      add_cylinders();
    }
    for (std::size_t i = 0; i < cover_.pieces.size(); ++i) {
      CoverPiece& piece = cover_.pieces[i];
      piece.r_below_mm = i > 0 ? end_radius_[i - 1] : 0;
      piece.r_above_mm = i + 1 < cover_.pieces.size() ? start_radius_[i + 1] : 0;
      if (is_closed_[i]) piece.r_closed_mm = piece.r_below_mm;
      if (is_stack) set_feet(piece);
    }
    return std::move(cover_);
  }

 private:
  [[nodiscard]] bool is_level(const Vec2& a, const Vec2& b) const {
    return b.y() - a.y() <= Tolerance::kFewRoundings * cover_.size_mm;
  }

  // Takes the contour with its low overhangs filled. The bounds of a cover hold for every solid within it.
  bool take_filled() {
    std::optional<std::vector<BoundaryElement>> filled = fill_overhangs(tool_.elements, kMaxFill * cover_.size_mm);
    if (!filled || !std::ranges::all_of(*filled, [](const BoundaryElement& e) { return is_rising(e); })) return false;
    filled_ = std::move(*filled);
    curves_.clear();
    for (const BoundaryElement& e : filled_) curves_.push_back(&e);
    return true;
  }

  // A bound for the chord also holds for points within its radius, because distances change no faster than positions.
  void take_chords() {
    double off = kFinest * cover_.size_mm;
    for (chords_ = chords_of(curves_, off); chords_.size() > kMaxChords && off < cover_.size_mm; off *= 2)
      chords_ = chords_of(curves_, 2 * off);
    curves_.clear();
    for (const BoundaryElement& chord : chords_) curves_.push_back(&chord);
  }

  void add_runs() {
    Run run;
    for (const BoundaryElement* e : curves_) {
      // A face that looks up only ends a piece; a face that looks down begins the next one.
      const bool is_top = is_level(e->a, e->b) && e->b.x() < e->a.x();
      if (is_top || !run.takes(*e)) {
        add(run);
        run = Run{};
      }
      if (!is_top) run.add(*e);
    }
    add(run);
  }

  static Vec2 inner(const BoundaryElement& e, const Vec2& end, double by) {
    if (e.kind == ElementKind::arc && !e.is_reflex) return e.center;
    const Vec2 direction = (e.b - e.a).normalized();
    return end - by * Vec2(direction.y(), -direction.x());
  }

  // A concave arc is represented by its chord, which lies outside of it.
  static Vec2 length_at(const BoundaryElement& e, const Vec2& point) {
    return e.kind == ElementKind::arc && e.is_reflex ? Vec2((e.b - e.a).normalized()) : direction_at(e, point);
  }

  void add(const Run& run) {
    if (run.elements.empty() || is_level(run.elements.front()->a, run.elements.back()->b)) return;
    CoverPiece piece;
    const BoundaryElement& first = *run.elements.front();
    const bool has_face = is_level(first.a, first.b);
    const BoundaryElement& last = *run.elements.back();
    const double rounding = run.arc_radius_mm;
    const double far = 4 * cover_.size_mm;
    const auto push = [&piece](const Vec2& p) { piece.chain.push_back(p); };
    push(inner(first, first.a, rounding) - far * length_at(first, first.a));
    for (std::size_t k = 0; k < run.elements.size(); ++k) {
      const BoundaryElement& e = *run.elements[k];
      const bool is_arc = e.kind == ElementKind::arc && !e.is_reflex;
      if (is_arc) push(e.center);
      if (is_arc || k == 0 || run.elements[k - 1]->kind == ElementKind::arc) continue;
      if (cross(direction_at(*run.elements[k - 1], e.a), direction_at(e, e.a)) > 0) push(inner(e, e.a, rounding));
    }
    push(inner(last, last.b, rounding) + far * length_at(last, last.b));
    straighten(piece.chain);
    piece.radius_mm = rounding + Tolerance::kRounding_mm;
    double outside = 0;
    for (const BoundaryElement* e : run.elements) outside = std::max(outside, farthest_out(piece, *e));
    if (outside > 0) piece.radius_mm += outside + Tolerance::kRounding_mm;
    piece.z_lo_mm = piece.foot_lo_mm = first.a.y();
    piece.z_hi_mm = piece.foot_hi_mm = last.b.y();
    keep(piece, has_face ? first.b.x() : first.a.x(), last.b.x(), has_face && outside <= Tolerance::kRounding_mm);
  }

  // Removes points until every line has a direction and the chain turns left everywhere. Points that are too close give
  // a direction that is only noise; halved arcs give one centre twice. Material outside of the shortened chain is added
  // to the radius.
  void straighten(std::vector<Vec2>& chain) const {
    for (std::size_t k = 1; k + 1 < chain.size();) {
      const Vec2 in = chain[k] - chain[k - 1], out = chain[k + 1] - chain[k];
      const bool is_line =
          out.norm() > Tolerance::kTangent * cover_.size_mm && out.y() >= -Tolerance::kTangent * out.norm();
      if (is_line && cross(in.normalized(), out.normalized()) >= -Tolerance::kSameDirection) {
        ++k;
      } else {
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(k));
        k = 1;
      }
    }
  }

  void keep(const CoverPiece& piece, double start_radius, double end_radius, bool is_closed) {
    cover_.pieces.push_back(piece);
    start_radius_.push_back(start_radius);
    end_radius_.push_back(end_radius);
    is_closed_.push_back(is_closed);
  }

  // Covers a contour that turns back in height: one cylinder for each interval of heights between two corners.
  void add_cylinders() {
    std::vector<double> heights{tool_.z_min_mm, tool_.z_max_mm};
    for (const BoundaryElement* e : curves_) {
      heights.insert(heights.end(), {e->a.y(), e->b.y()});
      if (e->kind == ElementKind::arc)
        heights.insert(heights.end(), {e->center.y() - e->radius_mm, e->center.y() + e->radius_mm});
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
      const double low = std::max(heights[k], tool_.z_min_mm);
      const double high = std::min(heights[k + 1], tool_.z_max_mm);
      if (high - low <= Tolerance::kNoDirection * cover_.size_mm) continue;
      double radius = 0;
      for (const BoundaryElement* e : curves_) {
        if (top_of(*e) <= low || bottom_of(*e) >= high) continue;
        radius = std::max(radius, widest(*e));
      }
      CoverPiece piece;
      piece.z_lo_mm = piece.foot_lo_mm = low;
      piece.z_hi_mm = piece.foot_hi_mm = high;
      piece.chain = {{radius, low - 4 * cover_.size_mm}, {radius, high + 4 * cover_.size_mm}};
      piece.radius_mm = Tolerance::kRounding_mm;
      keep(piece, radius, radius, false);
    }
  }

  static double top_of(const BoundaryElement& e) {
    return e.kind == ElementKind::arc ? e.center.y() + e.radius_mm : std::max(e.a.y(), e.b.y()) + e.radius_mm;
  }
  static double bottom_of(const BoundaryElement& e) {
    return e.kind == ElementKind::arc ? e.center.y() - e.radius_mm : std::min(e.a.y(), e.b.y()) - e.radius_mm;
  }
  static double widest(const BoundaryElement& e) {
    const double ends = std::max(e.a.x(), e.b.x());
    return e.kind == ElementKind::arc ? std::max(ends, e.center.x() + e.radius_mm) : ends + e.radius_mm;
  }

  /// Returns an upper bound of f over an element.
  static double farthest_out(const CoverPiece& piece, const BoundaryElement& e) {
    const double ends = std::max(cover_distance(piece, e.a), cover_distance(piece, e.b));
    if (e.kind == ElementKind::segment) return ends + e.radius_mm;
    if (e.is_reflex) return ends;
    const double all_round = cover_distance(piece, e.center) + e.radius_mm;
    return std::max(ends, all_round);
  }

  // Sets the range of valid feet. Closest points on the piece's continuation are valid up to the first element outside
  // of it.
  void set_feet(CoverPiece& piece) const {
    piece.foot_lo_mm = -kEndless;
    piece.foot_hi_mm = kEndless;
    const double slack = Tolerance::kNoDirection * cover_.size_mm;
    for (const BoundaryElement* e : curves_) {
      if (farthest_out(piece, *e) <= 0) continue;
      if (e->b.y() <= piece.z_lo_mm + slack) piece.foot_lo_mm = std::max(piece.foot_lo_mm, e->b.y());
      if (e->a.y() >= piece.z_hi_mm - slack) piece.foot_hi_mm = std::min(piece.foot_hi_mm, e->a.y());
    }
  }

  const CompiledTool& tool_;
  std::vector<const BoundaryElement*> curves_;
  std::vector<BoundaryElement> chords_;  // in place of the tool's elements, if there are many
  std::vector<BoundaryElement> filled_;  // in place of the tool's elements, if they turn back by little
  std::vector<double> start_radius_, end_radius_;
  std::vector<bool> is_closed_;
  ConvexCover cover_;
};

}  // namespace

ConvexCover make_convex_cover(const CompiledTool& tool) {
  if (tool.elements.empty()) return {};
  return CoverMaker(tool).make();
}

double cover_distance(const CoverPiece& piece, const Vec2& q) {
  double inside = -kEndless, outside2 = kEndless;
  for (std::size_t k = 0; k + 1 < piece.chain.size(); ++k) {
    const Vec2 direction = piece.chain[k + 1] - piece.chain[k];
    const double length = direction.norm();
    const Vec2 along = direction / length;
    const Vec2 from = q - piece.chain[k];
    inside = std::max(inside, from.x() * along.y() - from.y() * along.x());
    const double t = std::clamp(from.dot(along), 0.0, length);
    outside2 = std::min(outside2, (from - t * along).squaredNorm());
  }
  return (inside > 0 ? std::sqrt(outside2) : inside) - piece.radius_mm;
}

}  // namespace gouge
