#include "postproc/image/pixel_points.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gouge {

namespace {

// Every second bit of a number, side by side.
std::uint32_t even_bits(std::uint32_t code) {
  code &= 0x55555555U;
  code = (code | (code >> 1)) & 0x33333333U;
  code = (code | (code >> 2)) & 0x0F0F0F0FU;
  code = (code | (code >> 4)) & 0x00FF00FFU;
  return (code | (code >> 8)) & 0x0000FFFFU;
}

// Calls `at(x, y)` for every place of a grid, along Morton's curve: neighbours in the list are neighbours in the grid.
template <class At>
void for_each_along_curve(int width, int height, At&& at) {
  const auto side = std::bit_ceil(static_cast<std::uint32_t>(std::max({width, height, 1})));
  constexpr std::uint32_t kSquare = 8;  // looked at only where it lies in the grid
  const std::uint32_t step = std::min(side, kSquare) * std::min(side, kSquare);
  const std::uint64_t codes = static_cast<std::uint64_t>(side) * side;
  for (std::uint64_t code = 0; code < codes; code += step) {
    const auto first = static_cast<std::uint32_t>(code);
    if (static_cast<int>(even_bits(first)) >= width || static_cast<int>(even_bits(first >> 1)) >= height) continue;
    for (std::uint32_t k = first; k < first + step; ++k) {
      const auto x = static_cast<int>(even_bits(k)), y = static_cast<int>(even_bits(k >> 1));
      if (x < width && y < height) at(x, y);
    }
  }
}

}  // namespace

PixelPoints pixel_points(const SurfaceBuffer& buffer) {
  PixelPoints out;
  out.source.assign(buffer.z.size(), kNoFace);
  const View& view = buffer.view;
  const auto reach = static_cast<float>(4 * view.mm_per_pixel);
  const auto take = [&](int x, int y, std::size_t lead) {
    const std::size_t i = buffer.index(x, y);
    if (buffer.face[i] == kNoFace) return;
    if (lead != i && buffer.face[lead] != kNoFace && std::abs(buffer.z[lead] - buffer.z[i]) < reach) {
      out.source[i] = out.source[lead];
      return;
    }
    out.source[i] = static_cast<std::uint32_t>(out.points.size());
    out.points.push_back({buffer.point(x, y), buffer.face[i]});
  };
  for_each_along_curve((view.width + 1) / 2, (view.height + 1) / 2, [&](int column, int row) {
    const std::size_t lead = buffer.index(2 * column, 2 * row);
    for (int y = 2 * row; y < std::min(2 * row + 2, view.height); ++y) {
      for (int x = 2 * column; x < std::min(2 * column + 2, view.width); ++x) take(x, y, lead);
    }
  });
  return out;
}

std::vector<float> PixelPoints::spread(const std::vector<float>& values) const {
  std::vector<float> out(source.size(), 0.0F);
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (source[i] != kNoFace) out[i] = values[source[i]];
  }
  return out;
}

std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene, const SurfaceBuffer& buffer) {
  if (field.is_empty()) return std::vector<float>(buffer.z.size(), 0.0F);
  const PixelPoints seen = pixel_points(buffer);
  std::vector<FieldPoint> points;
  points.reserve(seen.points.size());
  for (const PixelPoints::Point& p : seen.points) points.push_back({p.at, scene.is_fixture(p.face)});
  return seen.spread(field.depth_at(points));
}

std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                     const SurfaceBuffer& buffer) {
  const PixelPoints seen = pixel_points(buffer);
  std::vector<OvercutField::Ray> rays;
  rays.reserve(seen.points.size());
  for (const PixelPoints::Point& p : seen.points) {
    const auto [a, b, c] = scene.corners(p.face);
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    rays.push_back({p.at, length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), scene.mesh_of(p.face)});
  }
  return seen.spread(field.at(rays));
}

}  // namespace gouge
