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

std::vector<PixelPoint> pixel_points(const SurfaceBuffer& buffer) {
  std::vector<PixelPoint> points;
  points.reserve(buffer.z.size() / 4 + 64);
  const View& view = buffer.view;
  const auto reach = static_cast<float>(4 * view.mm_per_pixel);
  for_each_along_curve((view.width + 1) / 2, (view.height + 1) / 2, [&](int column, int row) {
    const std::size_t lead = buffer.index(2 * column, 2 * row);
    const float z = buffer.z[lead];
    const bool has_lead = buffer.face[lead] != kNoFace;
    std::uint8_t covers = 0;  // what the lead stands for
    std::array<PixelPoint, 4> alone;
    std::size_t more = 0;
    for (int k = 0; k < 4; ++k) {
      const int x = 2 * column + k % 2, y = 2 * row + k / 2;
      if (x >= view.width || y >= view.height) continue;
      const std::size_t i = buffer.index(x, y);
      if (buffer.face[i] == kNoFace) continue;
      const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(k));
      if (has_lead && (k == 0 || std::abs(z - buffer.z[i]) < reach))
        covers = static_cast<std::uint8_t>(covers | bit);
      else
        alone[more++] = {x, y, bit};
    }
    if (covers != 0) points.push_back({2 * column, 2 * row, covers});
    points.insert(points.end(), alone.begin(), alone.begin() + static_cast<std::ptrdiff_t>(more));
  });
  return points;
}

std::vector<float> spread(const SurfaceBuffer& buffer, const std::vector<PixelPoint>& points,
                          const std::vector<float>& values) {
  std::vector<float> out;
  for (std::size_t p = 0; p < points.size(); ++p) {
    if (!(values[p] > 0)) continue;
    if (out.empty()) out.resize(buffer.z.size(), 0.0F);
    const PixelPoint& point = points[p];
    for (int k = 0; k < 4; ++k) {
      if ((point.covers >> k & 1) != 0) out[buffer.index(point.x / 2 * 2 + k % 2, point.y / 2 * 2 + k / 2)] = values[p];
    }
  }
  return out;
}

std::vector<float> depth_on_pixels(const DepthField& field, const PictureScene& scene, const SurfaceBuffer& buffer) {
  if (field.is_empty()) return {};
  const std::vector<PixelPoint> seen = pixel_points(buffer);
  std::vector<FieldPoint> points;
  points.reserve(seen.size());
  for (const PixelPoint& p : seen)
    points.push_back({buffer.point(p.x, p.y), scene.is_fixture(buffer.face[buffer.index(p.x, p.y)])});
  return spread(buffer, seen, field.depth_at(points));
}

std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                     const SurfaceBuffer& buffer) {
  const std::vector<PixelPoint> seen = pixel_points(buffer);
  std::vector<OvercutField::Ray> rays;
  rays.reserve(seen.size());
  for (const PixelPoint& p : seen) {
    const std::uint32_t face = buffer.face[buffer.index(p.x, p.y)];
    const Vec3 normal = scene.area_normal(face);
    const double length = normal.norm();
    rays.push_back(
        {buffer.point(p.x, p.y), length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), scene.mesh_of(face)});
  }
  return spread(buffer, seen, field.at(rays));
}

}  // namespace gouge
