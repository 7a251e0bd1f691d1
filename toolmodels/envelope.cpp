#include "toolmodels/envelope.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "toolmodels/envelope_curve.h"

namespace gouge {
namespace {

using detail::EnvelopeCurve;

constexpr double kSameHeight = 1e-10;  // of the size: heights closer than this are one break
constexpr double kSameRadius = 1e-12;  // of the size: curves closer than this coincide
constexpr double kNoStep = 1e-9;       // of the size: a jump smaller than this is rounding

struct Crossing {
  std::size_t i, j;
  Vec2 point;
};

struct Piece {
  std::size_t curve;
  double z0, z1;
};

class Envelope {
 public:
  explicit Envelope(std::vector<EnvelopeCurve> curves) : curves_(std::move(curves)) {
    for (const EnvelopeCurve& c : curves_)
      size_ = std::max({size_, c.a.cwiseAbs().maxCoeff(), c.b.cwiseAbs().maxCoeff()});
  }

  Profile contour() {
    if (curves_.empty()) return {};
    find_breaks();
    find_pieces();
    return join_pieces();
  }

 private:
  void add_breaks(std::vector<double> heights) {
    std::sort(heights.begin(), heights.end());
    for (const double z : heights) {
      const auto at = std::lower_bound(breaks_.begin(), breaks_.end(), z);
      const bool is_known = (at != breaks_.end() && *at - z <= kSameHeight * size_) ||
                            (at != breaks_.begin() && z - *std::prev(at) <= kSameHeight * size_);
      if (!is_known) breaks_.insert(at, z);
    }
  }

  // Curve ends first, so that given corners keep their exact heights.
  void find_breaks() {
    std::vector<double> heights;
    for (const EnvelopeCurve& c : curves_) heights.insert(heights.end(), {c.a.y(), c.b.y()});
    add_breaks(heights);
    heights.clear();
    for (std::size_t i = 0; i < curves_.size(); ++i)
      for (std::size_t j = i + 1; j < curves_.size(); ++j)
        for (const Vec2& point : detail::crossings(curves_[i], curves_[j], kSameHeight * size_)) {
          crossings_.push_back({i, j, point});
          heights.push_back(point.y());
        }
    add_breaks(heights);
  }

  std::optional<std::size_t> outermost(double z0, double z1, std::optional<std::size_t> previous) const {
    const double z = 0.5 * (z0 + z1);
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (z < curves_[i].a.y() || z > curves_[i].b.y()) continue;
      if (!best || radius_at(curves_[i], z) > radius_at(curves_[*best], z) + kSameRadius * size_) best = i;
    }
    if (best && previous && z >= curves_[*previous].a.y() && z <= curves_[*previous].b.y() &&
        radius_at(curves_[*previous], z) >= radius_at(curves_[*best], z) - kSameRadius * size_)
      return previous;
    return best;
  }

  void find_pieces() {
    std::optional<std::size_t> previous;
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
      const std::optional<std::size_t> best = outermost(breaks_[k], breaks_[k + 1], previous);
      if (best && best == previous)
        pieces_.back().z1 = breaks_[k + 1];
      else if (best)
        pieces_.push_back({*best, breaks_[k], breaks_[k + 1]});
      previous = best;
    }
  }

  Vec2 start_of(const Piece& p) const {
    const EnvelopeCurve& c = curves_[p.curve];
    return {std::abs(p.z0 - c.a.y()) <= kSameHeight * size_ ? c.a.x() : radius_at(c, p.z0), p.z0};
  }
  Vec2 end_of(const Piece& p) const {
    const EnvelopeCurve& c = curves_[p.curve];
    return {std::abs(p.z1 - c.b.y()) <= kSameHeight * size_ ? c.b.x() : radius_at(c, p.z1), p.z1};
  }

  // Where the radius follows from the height badly (near the pole of an arc) the crossing itself is exact.
  std::optional<Vec2> crossing_of(const Piece& p, const Piece& q) const {
    const auto [i, j] = std::minmax(p.curve, q.curve);
    for (const Crossing& c : crossings_)
      if (c.i == i && c.j == j && std::abs(c.point.y() - p.z1) <= kSameHeight * size_) return c.point;
    return std::nullopt;
  }

  void add_joint(const Piece& p, const Piece& q) {
    Vec2 end = end_of(p);
    Vec2 start = start_of(q);
    if (const std::optional<Vec2> crossing = crossing_of(p, q))
      end = start = *crossing;
    else if (std::abs(end.x() - start.x()) <= kNoStep * size_) {
      const bool is_start_given = std::abs(q.z0 - curves_[q.curve].a.y()) <= 0;
      (is_start_given ? end : start) = is_start_given ? start : end;
    }
    profile_.elements.back().b = end;
    if (end != start)
      profile_.elements.push_back(
          make_segment(curves_[end.x() > start.x() ? p.curve : q.curve].body, end, start));
    profile_.elements.push_back(curves_[q.curve].element(start, start));
  }

  Profile join_pieces() {
    const Vec2 tip = start_of(pieces_.front());
    const Vec2 top = end_of(pieces_.back());
    if (tip.x() > 0)
      profile_.elements.push_back(make_segment(curves_[pieces_.front().curve].body, Vec2(0, tip.y()), tip));
    profile_.elements.push_back(curves_[pieces_.front().curve].element(tip, tip));
    for (std::size_t k = 0; k + 1 < pieces_.size(); ++k) add_joint(pieces_[k], pieces_[k + 1]);
    profile_.elements.back().b = top;
    if (top.x() > 0)
      profile_.elements.push_back(make_segment(curves_[pieces_.back().curve].body, top, Vec2(0, top.y())));
    return std::move(profile_);
  }

  std::vector<EnvelopeCurve> curves_;
  std::vector<double> breaks_;
  std::vector<Crossing> crossings_;
  std::vector<Piece> pieces_;
  Profile profile_;
  double size_ = 0;
};

bool continues(const ProfileElement& p, const ProfileElement& q, double slack) {
  if (p.body != q.body || p.is_arc != q.is_arc) return false;
  if (p.is_arc)
    return p.is_concave == q.is_concave && (p.center - q.center).norm() <= slack &&
           std::abs(p.radius_mm - q.radius_mm) <= slack;
  const Vec2 along = start_direction(p);
  const Vec2 beyond = q.b - p.a;
  return along.dot(start_direction(q)) > 0 &&
         std::abs(along.x() * beyond.y() - along.y() * beyond.x()) <= slack;
}

Profile merge_neighbours(const Profile& profile) {
  const double slack = kSameRadius * size_of(profile);
  Profile merged;
  for (const ProfileElement& e : profile.elements) {
    if (!merged.elements.empty() && continues(merged.elements.back(), e, slack))
      merged.elements.back().b = e.b;
    else
      merged.elements.push_back(e);
  }
  return merged;
}

}  // namespace

Profile unite(const std::vector<GrownBody>& bodies) {
  std::vector<EnvelopeCurve> curves;
  for (const GrownBody& body : bodies) detail::add_curves(*body.profile, body.growth_mm, curves);
  return merge_neighbours(Envelope(std::move(curves)).contour());
}

}  // namespace gouge
