#include "tests/bench/sphere_cover.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace gouge::bench {
namespace {

constexpr double kMargin_mm = 1e-4;  // far above single precision at 100 mm

/// Radius of the piece at height z; straight between the queried heights.
double outline(const ConvexPiece& piece, double z) {
  const Vec2 &low = piece.contour[piece.contour.size() - 3], &high = piece.contour[piece.contour.size() - 2];
  const Vec2 along = (high - low).normalized();
  const Vec2 on = low + piece.rounding_mm * Vec2(along.y(), -along.x());
  return on.x() + (z - on.y()) * along.x() / along.y();
}

/// Spheres on the axis that cover the piece from z_mm to top_mm, standing out by `bulge_mm` at the bottom and
/// a tenth of the height more above.
void cover_along_axis(const std::function<double(double)>& radius, double z_mm, double top_mm, double bulge_mm,
                      std::vector<CoverSphere>& spheres) {
  const double bottom = z_mm;
  while (z_mm < top_mm) {
    const double bulge = bulge_mm + 0.1 * (z_mm - bottom);
    const double low = radius(z_mm);
    const double height = 2 * std::sqrt(2 * low * bulge + bulge * bulge);
    const double next = std::min(top_mm, z_mm + height);
    const double middle = 0.5 * (z_mm + next);
    const double wide = std::max(low, radius(next));
    const double half = middle - z_mm;
    spheres.push_back({Vec3(0, 0, middle), std::sqrt(wide * wide + half * half) + kMargin_mm});
    z_mm = next;
  }
}

/// Spheres on the corner's ring that cover its tube.
void cover_ring(double ring_mm, double tube_mm, double bulge_mm, std::vector<CoverSphere>& spheres) {
  const double reach = tube_mm + bulge_mm;
  // The tube is widest on its outside: there neighbours must meet at the outer radius.
  const double outer = ring_mm + tube_mm;
  const double cosine = (ring_mm * ring_mm + outer * outer - reach * reach) / (2 * ring_mm * outer);
  const auto count = static_cast<int>(std::ceil(std::numbers::pi / std::acos(std::clamp(cosine, -1.0, 1.0))));
  for (int k = 0; k < count; ++k) {
    const double turn = 2 * std::numbers::pi * k / count;
    spheres.push_back({Vec3(ring_mm * std::cos(turn), ring_mm * std::sin(turn), tube_mm), reach + kMargin_mm});
  }
}

/// Spheres in a triangular lattice that cover the disc of the radius from z = 0 to z = height_mm.
void cover_disc(double radius_mm, double height_mm, double bulge_mm, std::vector<CoverSphere>& spheres) {
  const double ball = height_mm / 2 + bulge_mm;
  const double patch = std::sqrt(ball * ball - height_mm * height_mm / 4);
  const double step = patch * std::numbers::sqrt3;
  const int reach = static_cast<int>(std::ceil((radius_mm + patch) / (1.5 * patch))) + 1;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -2 * reach; column <= 2 * reach; ++column) {
      const double x = step * (column + 0.5 * (row & 1)), y = 1.5 * patch * row;
      if (std::sqrt(x * x + y * y) > radius_mm + patch) continue;
      spheres.push_back({Vec3(x, y, height_mm / 2), ball + kMargin_mm});
    }
  }
}

/// The first sphere on the axis begins where the corner ends; being this tall, in radii of the tool, it
/// stands out below the bottom by less than the sag of a leaning tool's middle.
constexpr double kFirstSlice = 3;

void cover_flat_bottom(const ConvexPiece& piece, double bulge_mm, double disc_bulge_mm,
                       std::vector<CoverSphere>& spheres) {
  const double tube = piece.rounding_mm, ring = piece.contour[1].x(), radius = ring + tube;
  const double half = 0.5 * kFirstSlice * radius;
  cover_ring(ring, tube, bulge_mm, spheres);
  cover_disc(ring, tube, disc_bulge_mm, spheres);
  spheres.push_back({Vec3(0, 0, tube + half), std::sqrt(radius * radius + half * half) + kMargin_mm});
  cover_along_axis([radius](double) { return radius; }, tube + 2 * half, piece.contour[2].y(), 2, spheres);
}

void cover_pointed(const ConvexPiece& piece, double bulge_mm, double top_mm, std::vector<CoverSphere>& spheres) {
  const double r = piece.rounding_mm;
  spheres.push_back({Vec3(0, 0, r), r + kMargin_mm});
  const bool is_cone = piece.contour.size() > 2;
  const auto radius = [&](double z) { return is_cone ? outline(piece, z) : r; };
  double start = r;
  if (is_cone) {
    const Vec2 along = (piece.contour[1] - piece.contour[0]).normalized();
    start = r - r * along.x();
  }
  cover_along_axis(radius, start, top_mm, bulge_mm, spheres);
}

}  // namespace

SphereCover cover_tool(const BenchTool& tool, double bulge_mm, double disc_bulge_mm) {
  SphereCover cover;
  cover.bulge_mm = bulge_mm;
  const double z0 = tool.holder.contour[1].y(), z1 = tool.holder.contour[2].y();
  const double wide = tool.holder.contour[1].x();
  if (tool.lower.contour[0].x() < 1e-9 && tool.lower.contour.size() == 4) {
    cover_flat_bottom(tool.lower, bulge_mm, disc_bulge_mm, cover.lower);
  } else {
    cover_pointed(tool.lower, bulge_mm, z0, cover.lower);
  }
  cover_along_axis([wide](double) { return wide; }, z0, z1, 2, cover.holder);
  return cover;
}

double uncovered_mm(const BenchTool& tool, const SphereCover& cover) {
  constexpr int kTurns = 72, kRadii = 24;
  std::vector<CoverSphere> spheres = cover.lower;
  spheres.insert(spheres.end(), cover.holder.begin(), cover.holder.end());
  double worst = -std::numeric_limits<double>::infinity();
  const Pose upright;
  for (double z = 0; z <= tool.variants.bare.z_max_mm; z += z < 3 ? 0.1 : 0.3) {
    for (int i = 0; i <= kRadii * (z < 3 ? 4 : 1); ++i) {
      const double r = tool.variants.bare.r_max_mm * i / (kRadii * (z < 3 ? 4 : 1));
      for (int k = 0; k < kTurns; ++k) {
        const double turn = 2 * std::numbers::pi * k / kTurns;
        const Vec3 p(r * std::cos(turn), r * std::sin(turn), z);
        const bool is_inside = sample_piece(tool.lower, upright, p).distance_mm <= 0 ||
                               sample_piece(tool.holder, upright, p).distance_mm <= 0;
        if (!is_inside) continue;
        double least = std::numeric_limits<double>::infinity();
        for (const CoverSphere& s : spheres) least = std::min(least, (p - s.center).norm() - s.radius_mm);
        worst = std::max(worst, least);
      }
    }
  }
  return worst;
}

}  // namespace gouge::bench
