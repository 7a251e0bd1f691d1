#include "postproc/image/shade.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/parallel.h"
#include "postproc/image/walk_line.h"

namespace gouge {
namespace {

struct Offset {
  int x, y;
};

// Two rings of neighbours, in pixels of a supersampled picture.
constexpr std::array<Offset, 16> kNeighbours{{{6, 0},
                                              {4, 4},
                                              {0, 6},
                                              {-4, 4},
                                              {-6, 0},
                                              {-4, -4},
                                              {0, -6},
                                              {4, -4},
                                              {20, 8},
                                              {8, 20},
                                              {-8, 20},
                                              {-20, 8},
                                              {-20, -8},
                                              {-8, -20},
                                              {8, -20},
                                              {20, -8}}};
constexpr double kOcclusionReach = 40;  // pixels

// How much of the sky over a pixel its surroundings hide, 0 to 1: corners and grooves get their depth from
// it. Lengths in pixels, directions as the view sees them.
double occlusion(const SurfaceBuffer& buffer, const Vec3& normal, int x, int y) {
  const View& view = buffer.view;
  const Vec3 n(normal.dot(view.right), -normal.dot(view.up), normal.dot(view.toward));
  const double per_mm = 1 / view.mm_per_pixel;
  const auto z = static_cast<double>(buffer.z[buffer.index(x, y)]);
  double hidden = 0;
  for (const Offset& o : kNeighbours) {
    const int nx = x + o.x;
    const int ny = y + o.y;
    if (nx < 0 || ny < 0 || nx >= view.width || ny >= view.height) continue;
    const std::size_t i = buffer.index(nx, ny);
    if (buffer.face[i] == kNoFace) continue;
    const Vec3 d(o.x, o.y, (static_cast<double>(buffer.z[i]) - z) * per_mm);
    const double rise = d.dot(n);
    if (!(rise > 0)) continue;
    const double length = d.norm();
    if (length > kOcclusionReach) continue;
    hidden += std::max(0.0, rise / length - 0.12) * (1 - length / kOcclusionReach);
  }
  return std::min(1.0, hidden / 5);
}

void put(Raster& raster, int x, int y, const Colour& colour, double light) {
  std::uint8_t* pixel = raster.pixel(x, y);
  const std::array<unsigned char, 3> parts{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) {
    pixel[k] = static_cast<std::uint8_t>(std::lround(std::clamp(parts[k] * light, 0.0, 255.0)));
  }
}

void draw_edge(Raster& raster, const SurfaceBuffer& buffer, const Vec3& a, const Vec3& b) {
  const double slack = 2.5 * buffer.view.mm_per_pixel;
  walk_two_wide(a, b, raster.width, raster.height, [&](const Vec3& p, int x, int y) {
    if (p.z() + slack < static_cast<double>(buffer.z[buffer.index(x, y)])) return;
    blend_pixel(raster, x, y, {40, 48, 58, 1}, 0.28);
  });
}

}  // namespace

double light_on(const View& view, const Vec3& normal) {
  const Vec3 key = (-0.45 * view.right + 0.75 * view.up + 0.75 * view.toward).normalized();
  const Vec3 fill = (0.8 * view.right + 0.1 * view.up + 0.6 * view.toward).normalized();
  return 0.44 + 0.50 * std::max(0.0, normal.dot(key)) + 0.16 * std::max(0.0, normal.dot(fill));
}

void blend_pixel(Raster& raster, int x, int y, const Colour& colour, double opacity) {
  std::uint8_t* pixel = raster.pixel(x, y);
  const std::array<unsigned char, 3> parts{colour.r, colour.g, colour.b};
  for (std::size_t k = 0; k < 3; ++k) {
    pixel[k] = static_cast<std::uint8_t>(std::lround(pixel[k] * (1 - opacity) + parts[k] * opacity));
  }
}

Raster shade(const PictureScene& scene, const SurfaceBuffer& buffer, const std::vector<float>& depth_mm,
             const ColourScale& scale) {
  Raster raster(buffer.view.width, buffer.view.height, 255, 255, 255);
  const auto rows = static_cast<std::size_t>(buffer.view.height);
  for_each_chunk(rows, 16, 0, [&](std::size_t first, std::size_t last) {
    for (int y = static_cast<int>(first); y < static_cast<int>(last); ++y) {
      for (int x = 0; x < buffer.view.width; ++x) {
        const std::size_t i = buffer.index(x, y);
        if (buffer.face[i] == kNoFace) continue;
        const Vec3 normal = normal_at(scene, buffer, x, y);
        const double shadow = 1 - 0.55 * occlusion(buffer, normal, x, y);
        const double light = light_on(buffer.view, normal) * shadow;
        if (!depth_mm.empty() && depth_mm[i] > 0) {
          // Less contrast, so that a colour can be compared with the bar wherever it lies.
          put(raster, x, y, scale.at(static_cast<double>(depth_mm[i])), 0.55 + 0.42 * light);
        } else {
          const bool is_fixture = scene.faces[buffer.face[i]].is_fixture;
          put(raster, x, y, is_fixture ? kFixtureGrey : kPartGrey, 0.12 + 0.97 * light);
        }
      }
    }
  });
  for (const PictureScene::Edge& edge : scene.edges) {
    draw_edge(raster, buffer, buffer.view.project(scene.vertices[edge.a]), buffer.view.project(scene.vertices[edge.b]));
  }
  return raster;
}

}  // namespace gouge
