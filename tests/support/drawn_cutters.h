#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/scatter.h"
#include "toolmodels/cutter.h"

// Free profiles of any number of points: traced cutters, and cutters of many teeth.

namespace gouge::test {

struct Drawn {
  std::string name;
  std::vector<ProfilePoint> points;
};

inline ProfilePoint at(double r, double z) { return {ProfilePoint::SegmentShape::straight, r, z}; }

// Returns a ball of 10 mm and its flank, as traced by a measuring machine.
inline Drawn traced(std::size_t count, double noise_mm) {
  Drawn drawn{"traced", {}};
  Scatter random(3);
  for (std::size_t i = 0; i < count; ++i) {
    const double along = 27.8 * static_cast<double>(i) / static_cast<double>(count - 1);
    const double angle = std::min(along / 5, std::numbers::pi / 2);
    const double off = i == 0 ? 0 : random.in(-noise_mm, noise_mm);
    drawn.points.push_back(at((5 + off) * std::sin(angle), 5 - (5 + off) * std::cos(angle) + along - 5 * angle));
  }
  return drawn;
}

inline Drawn toothed(const std::string& name, std::size_t count, double inner, double outer, double pitch) {
  Drawn drawn{name, {at(0, 0)}};
  for (std::size_t i = 1; i < count; ++i)
    drawn.points.push_back(at(i % 2 == 1 ? outer : inner, pitch * static_cast<double>(i)));
  return drawn;
}

// Returns rings that overhang one another: the profile has two radii at one height.
inline Drawn hooked(std::size_t count) {
  Drawn drawn{"hooked", {at(0, 0), at(4, 0)}};
  for (std::size_t i = 0; drawn.points.size() + 4 <= count; ++i) {
    const double z = static_cast<double>(i);
    for (const Vec2& p : {Vec2(8, z + 0.1), Vec2(8.5, z + 0.6), Vec2(4.5, z + 0.3), Vec2(4.3, z + 0.8)})
      drawn.points.push_back(at(p.x(), p.y()));
  }
  return drawn;
}

inline Drawn scalloped(std::size_t count) {
  Drawn drawn{"scalloped", {at(0, 0)}};
  for (std::size_t i = 1; i < count; ++i) {
    const auto shape = i % 3 == 0 ? ProfilePoint::SegmentShape::convex : ProfilePoint::SegmentShape::concave;
    drawn.points.push_back(at(5, 0.2 * static_cast<double>(i)));
    if (i > 1) drawn.points.back().shape = shape, drawn.points.back().radius_mm = 0.3;
  }
  return drawn;
}

inline Drawn random_teeth(std::size_t count) {
  Drawn drawn{"random", {at(0, 0)}};
  Scatter random(7);
  for (std::size_t i = 1; i < count; ++i) drawn.points.push_back(at(random.in(2, 8), 0.05 * static_cast<double>(i)));
  return drawn;
}

inline std::vector<Drawn> drawn_cutters(std::size_t count) {
  return {traced(count, 0),
          traced(count, 0.003),
          toothed("rougher", count, 4.4, 5, 0.75),
          toothed("zigzag", count, 3, 8, 0.3),
          hooked(count),
          scalloped(count),
          random_teeth(count)};
}

inline Profile profile_of(const Drawn& drawn) {
  const Result<Profile> profile = make_cutter_profile(ProfileCutter{drawn.points});
  EXPECT_TRUE(profile.has_value()) << drawn.name << ": " << (profile ? "" : profile.error().message);
  return profile ? *profile : Profile{};
}

}  // namespace gouge::test
