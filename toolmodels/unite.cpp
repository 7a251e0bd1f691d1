#include "toolmodels/unite.h"

#include <algorithm>
#include <cmath>

#include "lib/base/tolerance.h"
#include "lib/tool/evaluate.h"
#include "toolmodels/arrangement.h"
#include "toolmodels/offset_curves.h"
#include "toolmodels/trace_regions.h"

namespace gouge {
namespace {

constexpr double kNudge = 3e-10;  // additional growth, relative to the size, that breaks a tie too small to be seen

// A body in the form from which its distances are computed.
struct Solid {
  CompiledTool tool;
  double growth_mm = 0;
};

bool continues(const ProfileElement& p, const ProfileElement& q, double slack) {
  if (p.body != q.body || p.is_arc != q.is_arc) return false;
  if (p.is_arc)
    return p.is_concave == q.is_concave && (p.center - q.center).norm() <= slack &&
           std::abs(p.radius_mm - q.radius_mm) <= slack;
  const Vec2 along = start_direction(p);
  const Vec2 beyond = q.b - p.a;
  return along.dot(start_direction(q)) > 0 && std::abs(along.x() * beyond.y() - along.y() * beyond.x()) <= slack;
}

Profile merge_neighbours(const std::vector<ProfileElement>& elements, double slack) {
  Profile merged;
  for (const ProfileElement& e : elements) {
    if (!merged.elements.empty() && continues(merged.elements.back(), e, slack))
      merged.elements.back().b = e.b;
    else
      merged.elements.push_back(e);
  }
  return merged;
}

// Returns whether a point is inside one of the offset bodies by more than rounding.
bool is_covered(const Vec2& q, const std::vector<Solid>& solids, double slack) {
  return std::any_of(solids.begin(), solids.end(), [&](const Solid& solid) {
    return evaluate_by_stretches(solid.tool, q.x(), q.y()).signed_distance_mm < solid.growth_mm - slack;
  });
}

std::optional<Profile> try_unite(const std::vector<OffsetBody>& bodies, double size, double nudge) {
  std::vector<ProfileElement> curves;
  std::vector<Solid> solids;
  for (const OffsetBody& body : bodies) {
    if (body.profile->elements.empty()) continue;
    const double growth = body.growth_mm > 0 ? body.growth_mm + nudge : 0;
    const std::vector<ProfileElement> more = detail::offset_curves(*body.profile, growth);
    curves.insert(curves.end(), more.begin(), more.end());
    solids.push_back({make_contour_solid(*body.profile), growth});
  }
  detail::Arrangement arrangement = detail::arrange(curves, Tolerance::kConstruction * size);
  std::erase_if(arrangement.pieces, [&](const detail::CurvePiece& piece) {
    return is_covered(detail::middle(piece.curve), solids, 10 * Tolerance::kConstruction * size);
  });
  const auto contour = detail::outer_contour(arrangement);
  if (!contour) return std::nullopt;
  return merge_neighbours(*contour, Tolerance::kFewRoundings * size);
}

}  // namespace

Result<Profile> unite(const std::vector<OffsetBody>& bodies) {
  double size = 0;
  for (const OffsetBody& body : bodies)
    if (!body.profile->elements.empty()) size = std::max(size, size_of(*body.profile) + body.growth_mm);
  if (!(size > 0)) return Profile{};
  for (int attempt = 0; attempt < 4; ++attempt)
    if (std::optional<Profile> made = try_unite(bodies, size, attempt * kNudge * size)) return *std::move(made);
  return make_error(
      "tool-not-closed",
      "its bodies do not join to one contour from the tip to the top; let each begin where the one below ends");
}

}  // namespace gouge
