#include "postproc/image/material_left.h"

#include <algorithm>
#include <cmath>

namespace gouge {
namespace {

// Distance of a piece from the surface that hides it, in pixels.
constexpr double kHiddenPixels = 3;

}  // namespace

bool shows_material_left(const CheckResult& result) { return result.excess && !result.excess->patches.empty(); }

void add_material_left(const CheckResult& result, LengthUnit unit, ColourScale& scale) {
  if (!shows_material_left(result)) return;
  double highest = 0;
  for (const LeftPatch& patch : result.excess->patches) highest = std::max(highest, patch.height_mm);
  const ColourScale left = make_colour_scale(result.excess->asked_mm, highest, unit);
  scale.left_low_mm = left.low_mm;
  scale.left_high_mm = left.high_mm;
}

void add_material_left(const CheckResult& result, const SurfaceBuffer& buffer, std::vector<float>& depth_mm) {
  if (!shows_material_left(result)) return;
  const std::vector<LeftPatch>& patches = result.excess->patches;
  std::vector<Vec3> vertices;
  std::vector<FaceCorners> faces;
  for (const LeftPatch& patch : patches) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), patch.corners.begin(), patch.corners.end());
    faces.push_back({first, first + 1, first + 2});
  }
  const SurfaceBuffer drawn = draw_surface(vertices, faces, buffer.view);
  if (depth_mm.empty()) depth_mm.assign(buffer.z.size(), 0.0F);
  const auto near = static_cast<float>(kHiddenPixels * buffer.view.mm_per_pixel);
  for (std::size_t i = 0; i < depth_mm.size(); ++i) {
    const bool is_seen = drawn.face[i] != kNoFace && buffer.face[i] != kNoFace && drawn.z[i] > buffer.z[i] - near;
    if (is_seen && !(depth_mm[i] > 0)) depth_mm[i] = -static_cast<float>(patches[drawn.face[i]].height_mm);
  }
}

std::vector<GougeWitness> material_witnesses(const CheckResult& result, std::size_t most) {
  std::vector<GougeWitness> all;
  if (!shows_material_left(result)) return all;
  const std::vector<LeftPatch>& patches = result.excess->patches;
  const std::size_t step = patches.size() / most + 1;
  for (std::size_t k = 0; k < patches.size(); k += step) {
    const std::array<Vec3, 3>& c = patches[k].corners;
    const Vec3 across = (c[1] - c[0]).cross(c[2] - c[0]);
    if (across.norm() > 0) all.push_back({(c[0] + c[1] + c[2]) / 3, across.normalized(), across.norm()});
  }
  return all;
}

}  // namespace gouge
