#include "postproc/image/surface_buffer.h"

#include <algorithm>
#include <cmath>

#include "lib/base/parallel.h"

namespace gouge {
namespace {

constexpr int kBandRows = 32;

struct RowRange {
  int first = 0, last = -1;  // inclusive
};

RowRange rows_of(const Vec3& a, const Vec3& b, const Vec3& c, int height) {
  const double low = std::min({a.y(), b.y(), c.y()});
  const double high = std::max({a.y(), b.y(), c.y()});
  if (!(high >= 0) || !(low <= height)) return {};
  return {std::max(0, static_cast<int>(std::floor(low - 0.5))),
          std::min(height - 1, static_cast<int>(std::ceil(high - 0.5)))};
}

double cross(const Vec3& a, const Vec3& b, double x, double y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

void draw_face(SurfaceBuffer& buffer, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t face,
               const RowRange& rows) {
  const double area = cross(a, b, c.x(), c.y());
  if (!(std::abs(area) > 0)) return;  // seen edge on
  // Barycentric coordinates are linear along a row; each bounds the row from one side. The slack closes the
  // hair-line gaps that rounding would leave between neighbours.
  constexpr double kSlack = 1e-9;
  const double du = -(c.y() - b.y()) / area;
  const double dv = -(a.y() - c.y()) / area;
  for (int y = rows.first; y <= rows.last; ++y) {
    const double u0 = cross(b, c, 0.5, y + 0.5) / area;
    const double v0 = cross(c, a, 0.5, y + 0.5) / area;
    double low = 0;
    double high = buffer.view.width - 1;
    const auto bound = [&](double at_zero, double slope) {  // keeps at_zero + slope x >= -slack
      if (slope > 0)
        low = std::max(low, (-kSlack - at_zero) / slope);
      else if (slope < 0)
        high = std::min(high, (-kSlack - at_zero) / slope);
      else if (at_zero < -kSlack)
        high = -1;
    };
    bound(u0, du);
    bound(v0, dv);
    bound(1 - u0 - v0, -du - dv);
    if (!(low <= high)) continue;
    const int last = static_cast<int>(std::floor(high));
    for (int x = static_cast<int>(std::ceil(low)); x <= last; ++x) {
      const double u = u0 + du * x;
      const double v = v0 + dv * x;
      const auto z = static_cast<float>(u * a.z() + v * b.z() + (1 - u - v) * c.z());
      const std::size_t i = buffer.index(x, y);
      if (z > buffer.z[i]) {
        buffer.z[i] = z;
        buffer.face[i] = face;
      }
    }
  }
}

}  // namespace

SurfaceBuffer draw_surface(const std::vector<Vec3>& vertices, const std::vector<FaceCorners>& faces, const View& view) {
  SurfaceBuffer buffer;
  buffer.view = view;
  const std::size_t pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  buffer.z.assign(pixels, std::numeric_limits<float>::lowest());
  buffer.face.assign(pixels, kNoFace);
  std::vector<Vec3> projected(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) projected[i] = view.project(vertices[i]);
  const std::size_t bands = static_cast<std::size_t>((view.height + kBandRows - 1) / kBandRows);
  std::vector<std::vector<std::uint32_t>> band_faces(bands);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const RowRange rows = rows_of(projected[faces[f][0]], projected[faces[f][1]], projected[faces[f][2]], view.height);
    for (int band = rows.first / kBandRows; band * kBandRows <= rows.last; ++band) {
      band_faces[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(f));
    }
  }
  for_each_chunk(bands, 1, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t band = first; band < last; ++band) {
      const int top = static_cast<int>(band) * kBandRows;
      for (const std::uint32_t f : band_faces[band]) {
        const Vec3& a = projected[faces[f][0]];
        const Vec3& b = projected[faces[f][1]];
        const Vec3& c = projected[faces[f][2]];
        RowRange rows = rows_of(a, b, c, view.height);
        rows.first = std::max(rows.first, top);
        rows.last = std::min(rows.last, top + kBandRows - 1);
        draw_face(buffer, a, b, c, f, rows);
      }
    }
  });
  return buffer;
}

SurfaceBuffer draw_surface(const PictureScene& scene, const View& view) {
  std::vector<FaceCorners> faces;
  faces.reserve(scene.faces.size());
  for (const PictureScene::Face& face : scene.faces) faces.push_back(face.corners);
  return draw_surface(scene.vertices, faces, view);
}

void NormalsAt::begin(std::uint32_t face) {
  face_ = face;
  const std::array<std::uint32_t, 3>& corners = scene_.faces[face].corners;
  const Vec3 a = view_.project(scene_.vertices[corners[0]]);
  const Vec3 b = view_.project(scene_.vertices[corners[1]]);
  const Vec3 c = view_.project(scene_.vertices[corners[2]]);
  const double area = cross(a, b, c.x(), c.y());
  u_ = cross(b, c, 0.5, 0.5) / area;
  u_right_ = (b.y() - c.y()) / area;
  u_down_ = (c.x() - b.x()) / area;
  v_ = cross(c, a, 0.5, 0.5) / area;
  v_right_ = (c.y() - a.y()) / area;
  v_down_ = (a.x() - c.x()) / area;
}

Vec3 NormalsAt::operator()(std::uint32_t face, int x, int y) {
  if (face != face_) begin(face);
  const double u = std::clamp(u_ + x * u_right_ + y * u_down_, 0.0, 1.0);
  const double v = std::clamp(v_ + x * v_right_ + y * v_down_, 0.0, 1.0);
  const std::array<Eigen::Vector3f, 3>& normals = scene_.faces[face].normals;
  Vec3 normal = u * normals[0].cast<double>() + v * normals[1].cast<double>() + (1 - u - v) * normals[2].cast<double>();
  const double length = normal.norm();
  if (!(length > 0)) return view_.toward;
  normal /= length;
  return normal.dot(view_.toward) < 0 ? Vec3(-normal) : normal;
}

Vec3 normal_at(const PictureScene& scene, const SurfaceBuffer& buffer, int x, int y) {
  return NormalsAt(scene, buffer.view)(buffer.face[buffer.index(x, y)], x, y);
}

bool is_visible(const SurfaceBuffer& buffer, const Vec3& point_part, double slack_mm) {
  const Vec3 p = buffer.view.project(point_part);
  if (!(p.x() >= 0 && p.y() >= 0 && p.x() < buffer.view.width && p.y() < buffer.view.height)) return false;
  const std::size_t i = buffer.index(static_cast<int>(p.x()), static_cast<int>(p.y()));
  return buffer.face[i] == kNoFace || p.z() + slack_mm >= static_cast<double>(buffer.z[i]);
}

}  // namespace gouge
