#include "postproc/image/pixel_points.h"

#include <algorithm>
#include <array>
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
  constexpr int kSquare = 8;  // looked at only where it lies in the grid
  constexpr std::uint32_t kPlaces = kSquare * kSquare;
  static const auto places = [] {
    std::array<std::array<int, 2>, kPlaces> out{};
    for (std::uint32_t k = 0; k < kPlaces; ++k)
      out[k] = {static_cast<int>(even_bits(k)), static_cast<int>(even_bits(k >> 1))};
    return out;
  }();
  const auto side = std::bit_ceil(static_cast<std::uint32_t>((std::max({width, height, 1}) + kSquare - 1) / kSquare));
  const std::uint64_t squares = static_cast<std::uint64_t>(side) * side;
  for (std::uint64_t code = 0; code < squares; ++code) {
    const auto square = static_cast<std::uint32_t>(code);
    const int left = kSquare * static_cast<int>(even_bits(square));
    const int top = kSquare * static_cast<int>(even_bits(square >> 1));
    if (left >= width || top >= height) continue;
    for (const auto& [x, y] : places) {
      if (left + x < width && top + y < height) at(left + x, top + y);
    }
  }
}

}  // namespace

PixelPoints pixel_points(const SurfaceBuffer& buffer) {
  PixelPoints out;
  out.source.assign(buffer.z.size(), kNoFace);
  out.pixels.reserve(buffer.z.size() / 4 + 64);
  const View& view = buffer.view;
  const auto reach = static_cast<float>(4 * view.mm_per_pixel);
  const auto take = [&](std::size_t i, std::size_t lead) {
    if (buffer.face[i] == kNoFace) return;
    if (lead != i && buffer.face[lead] != kNoFace && std::abs(buffer.z[lead] - buffer.z[i]) < reach) {
      out.source[i] = out.source[lead];
      return;
    }
    out.source[i] = static_cast<std::uint32_t>(out.pixels.size());
    out.pixels.push_back(static_cast<std::uint32_t>(i));
  };
  for_each_along_curve((view.width + 1) / 2, (view.height + 1) / 2, [&](int column, int row) {
    const std::size_t lead = buffer.index(2 * column, 2 * row);
    for (int y = 2 * row; y < std::min(2 * row + 2, view.height); ++y) {
      for (int x = 2 * column; x < std::min(2 * column + 2, view.width); ++x) take(buffer.index(x, y), lead);
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
  points.reserve(seen.pixels.size());
  for (const std::uint32_t i : seen.pixels) points.push_back({buffer.point(i), scene.is_fixture(buffer.face[i])});
  return seen.spread(field.depth_at(points));
}

std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                     const SurfaceBuffer& buffer) {
  const PixelPoints seen = pixel_points(buffer);
  std::vector<OvercutField::Ray> rays;
  rays.reserve(seen.pixels.size());
  for (const std::uint32_t i : seen.pixels) {
    const std::uint32_t face = buffer.face[i];
    const Vec3 normal = scene.area_normal(face);
    const double length = normal.norm();
    rays.push_back({buffer.point(i), length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), scene.mesh_of(face)});
  }
  return seen.spread(field.at(rays));
}

}  // namespace gouge
