#include "postproc/image/surface_buffer.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/base/instruction_sets.h"
#include "lib/base/parallel.h"
#include "lib/base/tolerance.h"

namespace gouge {
namespace {

constexpr int kBandRows = 16;  // so many rows of a large picture fit into the cache of a core

struct RowRange {
  int first = 0, last = -1;  // both inclusive
};

// Returns the rows whose middles a face reaches. There are none if no middle of a pixel lies between its sides, as for
// most faces that are smaller than a pixel.
RowRange rows_of(const Vec3& a, const Vec3& b, const Vec3& c, int height) {
  constexpr double kSlack = 1e-6;  // in pixels: more than the slack of draw_face
  const double low = std::min({a.y(), b.y(), c.y()}) - kSlack - 0.5;
  const double high = std::max({a.y(), b.y(), c.y()}) + kSlack - 0.5;
  if (!(high >= 0) || !(low <= height)) return {};
  const double left = std::min({a.x(), b.x(), c.x()}) - kSlack - 0.5;
  const double right = std::max({a.x(), b.x(), c.x()}) + kSlack - 0.5;
  if (std::ceil(left) > right) return {};
  return {std::max(0, static_cast<int>(std::ceil(low))), std::min(height - 1, static_cast<int>(std::floor(high)))};
}

double cross(const Vec3& a, const Vec3& b, double x, double y) {
  return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
}

constexpr int kLanes = 8;

// Draws the pixels from `low` to before `high` of a row. The depth is `at` for k = 0, and `step` more for each next
// pixel.
inline void draw_run(float* z, std::uint32_t* faces, double at, double step, std::int32_t low, std::int32_t high,
                     std::size_t count, std::uint32_t face) {
  for (std::size_t k = 0; k < count; ++k) {
    const auto place = static_cast<std::int32_t>(k);
    const auto here = static_cast<float>(at + step * static_cast<double>(place));
    const bool is_nearer = (place >= low) & (place < high) & (here > z[k]);
    z[k] = is_nearer ? here : z[k];
    faces[k] = is_nearer ? face : faces[k];
  }
}

/// A bound that one side of a face sets for a row of pixels. `per_row` is its change from row to row.
struct SideBound {
  double bound = 0, per_row = 0;
};

GOUGE_WIDE void draw_face(SurfaceBuffer& buffer, const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t face,
                          const RowRange& rows) {
  const double area = cross(a, b, c.x(), c.y());
  if (!(std::abs(area) > 0)) return;  // the face is seen edge on
  // Barycentric coordinates are linear, so each bounds a row from one side. The slack closes the fine gaps that
  // rounding would leave between neighbours.
  constexpr double kSlack = Tolerance::kRounding;
  const double per_area = 1 / area, y0 = rows.first + 0.5;
  const double du = -(c.y() - b.y()) * per_area, dv = -(a.y() - c.y()) * per_area;
  const double du_down = (c.x() - b.x()) * per_area, dv_down = (a.x() - c.x()) * per_area;
  const double u = cross(b, c, 0.5, y0) * per_area, v = cross(c, a, 0.5, y0) * per_area;
  constexpr double kFar = 1e15;
  std::array<SideBound, 3> lows, highs;
  lows.fill({-kFar, 0});
  highs.fill({kFar, 0});
  struct Side {
    double at, along, down;
  };
  const std::array<Side, 3> sides{{{u, du, du_down}, {v, dv, dv_down}, {1 - u - v, -du - dv, -du_down - dv_down}}};
  for (std::size_t k = 0; k < 3; ++k) {  // keeps the pixels with at + along x + down y >= -slack
    const Side& side = sides[k];
    const double inverse = -1 / side.along;
    if (side.along > 0)
      lows[k] = {(side.at + kSlack) * inverse, side.down * inverse};
    else if (side.along < 0)
      highs[k] = {(side.at + kSlack) * inverse, side.down * inverse};
  }
  const double dz = du * (a.z() - c.z()) + dv * (b.z() - c.z());
  const double dz_down = du_down * (a.z() - c.z()) + dv_down * (b.z() - c.z());
  const double z0 = c.z() + u * (a.z() - c.z()) + v * (b.z() - c.z());
  const int width = buffer.view.width;
  for (int y = rows.first; y <= rows.last; ++y) {
    const double down = y - rows.first;
    double low = 0, high = width - 1;
    for (std::size_t k = 0; k < 3; ++k) {
      low = std::max(low, lows[k].bound + lows[k].per_row * down);
      high = std::min(high, highs[k].bound + highs[k].per_row * down);
    }
    if (!(low <= high)) continue;
    const int first = static_cast<int>(std::ceil(low)), last = static_cast<int>(std::floor(high));
    if (first > last) continue;
    // Whole lanes are drawn, because most runs are short and would spend their time on the remainder. The pixels beside
    // the run stay unchanged.
    const int count = last + 1 - first, whole = (count + kLanes - 1) / kLanes * kLanes;
    const int from = whole <= width ? std::min(first, width - whole) : first;
    const std::size_t i = buffer.index(from, y);
    draw_run(&buffer.z[i], &buffer.face[i], z0 + dz_down * down + dz * from, dz, first - from, last + 1 - from,
             static_cast<std::size_t>(whole <= width ? whole : count), face);
  }
}

/// Draws faces. `corners_of` returns the corners of a face in part coordinates. `faces` is in increasing order.
template <class CornersOf>
SurfaceBuffer draw_faces(const View& view, const std::vector<std::uint32_t>& faces, const CornersOf& corners_of) {
  SurfaceBuffer buffer;
  buffer.view = view;
  const std::size_t pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  buffer.z.resize(pixels);
  buffer.face.resize(pixels);
  const auto projected = [&](std::uint32_t face) {
    std::array<Vec3, 3> corners = corners_of(face);
    for (Vec3& corner : corners) corner = view.project(corner);
    return corners;
  };
  const std::size_t bands = static_cast<std::size_t>((view.height + kBandRows - 1) / kBandRows);
  std::vector<std::vector<std::uint32_t>> band_faces(bands);
  for (const std::uint32_t f : faces) {
    const auto [a, b, c] = projected(f);
    const RowRange rows = rows_of(a, b, c, view.height);
    for (int band = rows.first / kBandRows; band * kBandRows <= rows.last; ++band) {
      band_faces[static_cast<std::size_t>(band)].push_back(f);
    }
  }
  for_each_chunk(bands, 1, 0, [&](std::size_t first, std::size_t last) {
    for (std::size_t band = first; band < last; ++band) {
      const int top = static_cast<int>(band) * kBandRows;
      // A band is emptied here, so that it is in the cache when its faces are drawn.
      const std::size_t begin = buffer.index(0, top), end = buffer.index(0, std::min(top + kBandRows, view.height));
      std::fill(buffer.z.data() + begin, buffer.z.data() + end, std::numeric_limits<float>::lowest());
      std::fill(buffer.face.data() + begin, buffer.face.data() + end, kNoFace);
      for (const std::uint32_t f : band_faces[band]) {
        const auto [a, b, c] = projected(f);
        RowRange rows = rows_of(a, b, c, view.height);
        rows.first = std::max(rows.first, top);
        rows.last = std::min(rows.last, top + kBandRows - 1);
        draw_face(buffer, a, b, c, f, rows);
      }
    }
  });
  return buffer;
}

}  // namespace

SurfaceBuffer draw_surface(const std::vector<Vec3>& vertices, const std::vector<FaceCorners>& faces, const View& view) {
  std::vector<std::uint32_t> all(faces.size());
  std::iota(all.begin(), all.end(), 0U);
  return draw_faces(view, all, [&](std::uint32_t f) {
    return std::array<Vec3, 3>{vertices[faces[f][0]], vertices[faces[f][1]], vertices[faces[f][2]]};
  });
}

SurfaceBuffer draw_surface(const PictureScene& scene, const View& view) {
  return draw_faces(view, scene.faces_in(view), [&](std::uint32_t f) { return scene.corners(f); });
}

NormalsAt::Known NormalsAt::know(std::uint32_t face) const {
  Known known;
  known.face = face;
  const std::array<Eigen::Vector3f, 3> normals = scene_.normals(face);
  std::array<Eigen::Vector3f, 3> seen;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 normal = normals[k].cast<double>();
    seen[k] = Vec3(normal.dot(view_.right), normal.dot(view_.up), normal.dot(view_.toward)).cast<float>();
  }
  known.last = seen[2];
  known.first_more = seen[0] - seen[2];
  known.second_more = seen[1] - seen[2];
  const std::array<Vec3, 3> corners = scene_.corners(face);
  const Vec3 a = view_.project(corners[0]), b = view_.project(corners[1]), c = view_.project(corners[2]);
  const double area = cross(a, b, c.x(), c.y());
  known.u = cross(b, c, 0.5, 0.5) / area;
  known.u_right = (b.y() - c.y()) / area;
  known.u_down = (c.x() - b.x()) / area;
  known.v = cross(c, a, 0.5, 0.5) / area;
  known.v_right = (c.y() - a.y()) / area;
  known.v_down = (a.x() - c.x()) / area;
  return known;
}

Eigen::Vector3f NormalsAt::in_view(std::uint32_t face, int x, int y) {
  Known& known = kept_[face % kKept];
  if (face != known.face) known = know(face);
  const auto u = static_cast<float>(std::clamp(known.u + x * known.u_right + y * known.u_down, 0.0, 1.0));
  const auto v = static_cast<float>(std::clamp(known.v + x * known.v_right + y * known.v_down, 0.0, 1.0));
  return known.last + u * known.first_more + v * known.second_more;
}

Vec3 NormalsAt::operator()(std::uint32_t face, int x, int y) {
  const Vec3 seen = in_view(face, x, y).cast<double>();
  const double length = seen.norm();
  if (!(length > 0)) return view_.toward;
  const Vec3 normal = (view_.right * seen.x() + view_.up * seen.y() + view_.toward * seen.z()) / length;
  return seen.z() < 0 ? Vec3(-normal) : normal;
}

bool is_visible(const SurfaceBuffer& buffer, const Vec3& point_part, double slack_mm) {
  const Vec3 p = buffer.view.project(point_part);
  if (!(p.x() >= 0 && p.y() >= 0 && p.x() < buffer.view.width && p.y() < buffer.view.height)) return false;
  const std::size_t i = buffer.index(static_cast<int>(p.x()), static_cast<int>(p.y()));
  return buffer.face[i] == kNoFace || p.z() + slack_mm >= static_cast<double>(buffer.z[i]);
}

}  // namespace gouge
