#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "lib/tool/evaluate.h"
#include "tests/support/scatter.h"
#include "toolmodels/assembly.h"
#include "toolmodels/compile_tool.h"
#include "toolmodels/elements.h"
#include "toolmodels/unite.h"

// Random valid tools; a seed gives the same tool on every run. They are assemblies with cutters of every shape, with
// and without offset, and free profiles. The profiles have convex and concave arcs, fillets, undercuts, necks, hollow
// bottoms and steps a millionth of the tool's size. They also have corners on a grid, where distances tie exactly.

namespace gouge::test {

struct RandomTool {
  std::string name;  ///< kind and seed, for messages
  Profile profile;
};

/// Returns an element from p to q with solid on the left. It is straight for bulge 0, a convex arc of `4 atan(bulge)`
/// for a positive one, a concave arc for a negative one.
inline ProfileElement bulged(const Vec2& p, const Vec2& q, double bulge, Body body = Body::cutter) {
  if (!(std::abs(bulge) > 0)) return make_segment(body, p, q);
  const double half = 2 * std::atan(std::abs(bulge));
  const Vec2 chord = q - p;
  const double side = (bulge > 0 ? 1.0 : -1.0) / std::tan(half) / 2;
  const Vec2 center = 0.5 * (p + q) + side * Vec2(-chord.y(), chord.x());
  const double radius = 0.5 * ((p - center).norm() + (q - center).norm());
  return bulge > 0 ? make_convex_arc(body, p, q, center, radius) : make_concave_arc(body, p, q, center, radius);
}

/// Returns whether the elements keep a distance from each other, so that the contour certainly does not cross itself.
inline bool is_clear_of_itself(const Profile& profile) {
  constexpr int kSteps = 64;
  const std::vector<ProfileElement>& parts = profile.elements;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i)
    if (end_direction(parts[i]).dot(start_direction(parts[i + 1])) < -0.99) return false;
  const std::vector<BoundaryElement> elements = make_elements(profile);
  for (const ProfileElement& part : parts)
    for (int k = 0; k <= kSteps; ++k) {
      const Vec2 p = part.is_arc ? sample(part, kSteps)[static_cast<std::size_t>(k)]
                                 : Vec2(part.a + k / double{kSteps} * (part.b - part.a));
      const double reach = (part.is_arc ? part.radius_mm * sweep_rad(part) : (part.b - part.a).norm()) / kSteps;
      for (const BoundaryElement& e : elements) {
        const bool is_neighbour = e.a == part.a || e.b == part.a || e.a == part.b || e.b == part.b ||
                                  (e.kind == ElementKind::arc && part.is_arc && e.center == part.center);
        if (!is_neighbour && distance_to(e, p) <= reach) return false;
      }
    }
  return true;
}

struct FreeStyle {
  bool has_arcs = true, has_undercuts = true, is_hollow = true, is_on_grid = false;
  double smallest_step = 0.05;  ///< relative to the mean step
};

inline std::vector<Vec2> random_corners(Scatter& random, const FreeStyle& style) {
  const double scale = style.is_on_grid ? 8 : 8 * std::pow(10.0, random.in(-1.5, 1));
  const auto place = [&](double value) { return style.is_on_grid ? std::round(value) : value; };
  const auto step = [&] { return scale * std::pow(style.smallest_step, random.next() % 3 == 0 ? random.in(0, 1) : 0); };
  std::vector<Vec2> corners{{0, style.is_hollow ? place(scale * random.in(0.1, 0.6)) : 0}};
  if (style.is_hollow) corners.emplace_back(place(scale * random.in(0.3, 1)), 0);
  for (std::uint64_t count = 2 + random.next() % 9; count > 0; --count) {
    Vec2 next = corners.back();
    const std::uint64_t kind = random.next() % 4;
    const double down = style.has_undercuts && random.next() % 4 == 0 ? -0.6 : 1;
    if (kind != 0) next.y() += place(down * step() * random.in(0.2, 1.2));
    if (kind != 1) next.x() += place(step() * random.in(-1, 1.2));
    if (next.x() < 0.02 * scale) next.x() = place(scale * random.in(0.1, 1));
    if (style.is_on_grid) next.x() = std::max(1.0, next.x());
    if (next != corners.back()) corners.push_back(next);
  }
  corners.emplace_back(0, corners.back().y());
  return corners;
}

/// Rounds a corner by an arc that touches both sides, if there is room for it.
inline void fillet(Scatter& random, const Vec2& before, const Vec2& corner, const Vec2& after, Vec2& a, Vec2& b,
                   double& bulge) {
  const Vec2 in = corner - before, out = after - corner;
  const Vec2 u = in.normalized(), v = out.normalized();
  const double turn = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
  const double trim = random.in(0.05, 0.4) * std::min(in.norm(), out.norm());
  a = corner - trim * u;
  b = corner + trim * v;
  bulge = std::tan(turn / 4);
}

inline Profile random_outline(Scatter& random, const FreeStyle& style) {
  const std::vector<Vec2> corners = random_corners(random, style);
  Profile profile;
  const auto body_at = [&](std::size_t i) {
    return 2 * i < corners.size() ? Body::cutter : (4 * i < 3 * corners.size() ? Body::shank : Body::holder);
  };
  Vec2 from = corners.front();
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const bool is_last = i + 2 == corners.size();
    Vec2 a = corners[i + 1], b = corners[i + 1];
    double rounding = 0;
    const std::uint64_t kind = style.has_arcs ? random.next() % 4 : 0;
    if (kind == 1 && !is_last) fillet(random, from, corners[i + 1], corners[i + 2], a, b, rounding);
    const double bulge = kind == 2 ? random.in(-0.7, 1.2) : kind == 3 ? random.in(-0.05, 0.05) : 0;
    profile.elements.push_back(bulged(from, a, bulge, body_at(i)));
    if (std::abs(rounding) > 0) profile.elements.push_back(bulged(a, b, rounding, body_at(i)));
    from = b;
  }
  return profile;
}

inline Profile random_free_profile(Scatter& random, const FreeStyle& style) {
  for (;;) {
    const Profile profile = random_outline(random, style);
    if (verify_profile(profile).empty() && is_clear_of_itself(profile)) return profile;
  }
}

/// Returns a staircase of cylinders with steps down to a millionth of the size. It has no arcs and cannot cross itself.
inline Profile random_staircase(Scatter& random) {
  Profile profile;
  Vec2 at(0, 0);
  const auto go_to = [&](const Vec2& to) {
    profile.elements.push_back(make_segment(Body::cutter, at, to));
    at = to;
  };
  go_to({random.in(1, 20), 0});
  for (std::uint64_t count = 2 + random.next() % 6; count > 0; --count) {
    go_to({at.x(), at.y() + 10 * std::pow(10.0, random.in(-6, 1))});
    const double step = 10 * std::pow(10.0, random.in(-6, 0));
    go_to({random.next() % 2 == 0 && step < 0.5 * at.x() ? at.x() - step : at.x() + step, at.y()});
  }
  go_to({at.x(), at.y() + random.in(1, 50)});
  go_to({0, at.y()});
  return profile;
}

inline std::vector<ToolSegment> random_segments(Scatter& random, std::uint64_t most) {
  std::vector<ToolSegment> list;
  for (std::uint64_t k = random.next() % (most + 1); k > 0; --k) {
    const double lower = random.in(1, 40);
    const double upper = random.next() % 2 == 0 ? lower : random.in(1, 40);
    list.push_back({lower, upper, random.in(0.5, 40)});
  }
  return list;
}

// Returns a cutter with random dimensions that are often valid. make_body_profiles refuses the others.
inline Cutter random_cutter(Scatter& random) {
  const double d = random.in(0.5, 40), length = random.in(0.8 * d, 60 + d);
  const double corner = random.in(0, d / 2);
  const auto part = [&](double low, double high) { return d * random.in(low, high); };
  switch (random.next() % 18) {
    case 0:
      return FlatCutter{d, length};
    case 1:
      return BallCutter{d, length};
    case 2:
      return BullNoseCutter{d, corner, length};
    case 3:
      return TaperedCutter{d, corner, random.in(-8, 40), length};
    case 4:
      return TaperedCutter{d, d / 2, random.in(0.1, 20), length};
    case 5:
      return DrillCutter{d, random.in(60, 179), length};
    case 6:
      return ChamferCutter{d, part(0, 0.9), random.in(10, 80), random.next() % 2 == 0 ? 0 : length};
    case 7:
      return LollipopCutter{d, part(0.2, 0.95), random.next() % 2 == 0 ? 0 : part(0.6, 3)};
    case 8:
      return TSlotCutter{d, part(0, 0.1), part(0, 0.1), part(0.2, 1)};
    case 9:
      return SlittingSawCutter{d, part(0.01, 0.2), random.next() % 2 == 0 ? 0 : part(0.1, 0.6), part(0.02, 0.2)};
    case 10:
      return DovetailCutter{d, part(0, 0.05), random.in(5, 40), part(0.1, 0.5)};
    case 11:
      return BarrelCutter{d, part(1, 40), part(0, 0.2), random.in(0, 15), part(0.2, 1), part(1, 2)};
    case 12:
      return OvalCutter{d, part(0.02, 0.4), part(0.6, 20), length};
    case 13:
      return LensCutter{d, part(0.6, 10), part(0.01, 0.3), length};
    case 14: {
      const bool is_hollow = random.next() % 2 == 0;
      return FaceMillCutter{d,
                            part(0, 0.05),
                            random.in(5, 60),
                            part(1.05, 1.5),
                            is_hollow ? part(0.2, 0.8) : 0,
                            is_hollow ? part(0.05, 0.3) : 0,
                            length};
    }
    case 15:
      return RadiusCutter{d, part(0, 0.3), part(0.1, 0.6), random.next() % 2 == 0 ? 0 : part(2.3, 3), length};
    default:
      return AptCutter{d, 0.4 * corner, 0, 0, random.in(0, 50), random.in(-8, 30), length};
  }
}

/// Returns the union of the bodies, each offset by at most its value in `most`; nothing if they do not make one tool.
inline std::optional<Profile> united(Scatter& random, const std::vector<const Profile*>& bodies,
                                     const std::vector<double>& most) {
  std::vector<OffsetBody> offset;
  for (std::size_t i = 0; i < bodies.size(); ++i) offset.push_back({bodies[i], random.in(0, 1) * most[i]});
  Result<Profile> all = unite(offset);
  if (!all) return std::nullopt;
  return std::move(all.value());
}

inline Profile random_assembly_profile(Scatter& random) {
  for (;;) {
    ToolAssembly tool;
    tool.cutter = random_cutter(random);
    tool.shank = random_segments(random, 3);
    tool.holder = random_segments(random, 4);
    const Result<BodyProfiles> bodies = make_body_profiles(tool);
    if (!bodies) continue;
    const double grows = random.next() % 2 == 0 ? 1 : 0;
    const auto& [cutter, shank, holder] = *bodies;
    if (auto all = united(random, {&cutter, &shank, &holder}, {grows, 2 * grows, 5 * grows})) return *all;
  }
}

// Returns the contour of an offset profile. Its undercuts may close and its hollows may fill, but it stays one contour.
inline Profile random_offset_profile(Scatter& random) {
  for (;;) {
    const bool is_free = random.next() % 2 == 0;
    const Profile bare = random_free_profile(random, {true, is_free, is_free, false, 0.05});
    if (auto all = united(random, {&bare}, {0.2 * size_of(bare)})) return *all;
  }
}

inline RandomTool random_tool(std::uint64_t seed) {
  Scatter random(0x70015ull + 1000003 * seed);
  const std::string number = " " + std::to_string(seed);
  switch (seed % 8) {
    case 0:
    case 1:
      return {"assembly" + number, random_assembly_profile(random)};
    case 2:
      return {"free, grown" + number, random_offset_profile(random)};
    case 3:
      return {"free" + number, random_free_profile(random, {})};
    case 4:
      return {"free, one radius at a height" + number, random_free_profile(random, {true, false, false, false, 0.05})};
    case 5:
      return {"free on a grid" + number,
              random_free_profile(random, {random.next() % 2 == 0, true, random.next() % 2 == 0, true, 0.2})};
    case 6:
      return {"free with small steps" + number,
              random_free_profile(random, {true, true, random.next() % 2 == 0, false, 1e-3})};
    default:
      return {"staircase" + number, random_staircase(random)};
  }
}

}  // namespace gouge::test
