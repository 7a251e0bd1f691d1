#include "postproc/image/pixel_points.h"

#include <cmath>

namespace gouge {

PixelPoints pixel_points(const SurfaceBuffer& buffer) {
  PixelPoints out;
  out.source.assign(buffer.z.size(), kNoFace);
  const View& view = buffer.view;
  const auto reach = static_cast<float>(4 * view.mm_per_pixel);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const std::size_t i = buffer.index(x, y);
      if (buffer.face[i] == kNoFace) continue;
      const std::size_t lead = buffer.index(x - x % 2, y - y % 2);
      if (lead != i && buffer.face[lead] != kNoFace && std::abs(buffer.z[lead] - buffer.z[i]) < reach) {
        out.source[i] = out.source[lead];
        continue;
      }
      out.source[i] = static_cast<std::uint32_t>(out.points.size());
      out.points.push_back({buffer.point(x, y), buffer.face[i]});
    }
  }
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
  for (const PixelPoints::Point& p : seen.points) points.push_back({p.at, scene.faces[p.face].is_fixture});
  return seen.spread(field.depth_at(points));
}

std::vector<float> overcut_on_pixels(const OvercutField& field, const PictureScene& scene,
                                     const SurfaceBuffer& buffer) {
  const PixelPoints seen = pixel_points(buffer);
  std::vector<OvercutField::Ray> rays;
  rays.reserve(seen.points.size());
  for (const PixelPoints::Point& p : seen.points) {
    const PictureScene::Face& face = scene.faces[p.face];
    const Vec3& a = scene.vertices[face.corners[0]];
    const Vec3 normal = (scene.vertices[face.corners[1]] - a).cross(scene.vertices[face.corners[2]] - a);
    const double length = normal.norm();
    rays.push_back({p.at, length > 0 ? Vec3(-normal / length) : Vec3(-Vec3::UnitZ()), face.mesh});
  }
  return seen.spread(field.at(rays));
}

}  // namespace gouge
