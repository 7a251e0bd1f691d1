#pragma once

#include <vector>

#include "toolmodels/profile.h"

namespace gouge::detail {

/// A piece of boundary as a radius over the height: it rises strictly in z from a to b.
struct EnvelopeCurve {
  Body body = Body::cutter;
  bool is_arc = false;
  bool is_concave = false;  ///< the left half of its circle; else the right half
  Vec2 a = Vec2::Zero(), b = Vec2::Zero();
  Vec2 center = Vec2::Zero();
  double radius_mm = 0;

  [[nodiscard]] ProfileElement element(const Vec2& from, const Vec2& to) const;
};

/// Radius at height z, which must lie between the ends (rounding apart).
[[nodiscard]] double radius_at(const EnvelopeCurve& curve, double z_mm);

/// Where two curves cross or touch, at heights both have; none where they coincide.
[[nodiscard]] std::vector<Vec2> crossings(const EnvelopeCurve& c, const EnvelopeCurve& d, double slack_mm);

/// The curves whose envelope is the body grown by `growth_mm`: its elements moved out, and arcs about its
/// corners.
void add_curves(const Profile& profile, double growth_mm, std::vector<EnvelopeCurve>& curves);

}  // namespace gouge::detail
