#include "samples/solids.h"

#include <bit>
#include <cstdint>

namespace gouge::samples {
namespace {

void append_u32(std::string& out, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<char>((value >> shift) & 0xffU));
}

void append_point(std::string& out, const Vec3& p) {
  for (int k = 0; k < 3; ++k) append_u32(out, std::bit_cast<std::uint32_t>(static_cast<float>(p[k])));
}

}  // namespace

void add_quad(Solid& solid, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  solid.push_back({a, b, c});
  solid.push_back({a, c, d});
}

void add_strip(Solid& solid, const Ring& upper, const Ring& lower, bool faces_inward) {
  for (std::size_t i = 0; i < upper.size(); ++i) {
    const std::size_t next = (i + 1) % upper.size();
    if (faces_inward) {
      add_quad(solid, upper[i], upper[next], lower[next], lower[i]);
    } else {
      add_quad(solid, lower[i], lower[next], upper[next], upper[i]);
    }
  }
}

void add_cap(Solid& solid, const Vec3& center, const Ring& ring, bool faces_down) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3& a = ring[i];
    const Vec3& b = ring[(i + 1) % ring.size()];
    solid.push_back(faces_down ? Triangle{center, b, a} : Triangle{center, a, b});
  }
}

Solid make_grid_solid(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                      const std::function<bool(int, int, int)>& is_solid) {
  const std::array<std::span<const double>, 3> breaks = {x, y, z};
  const std::array<int, 3> cells = {static_cast<int>(x.size()) - 1, static_cast<int>(y.size()) - 1,
                                    static_cast<int>(z.size()) - 1};
  const auto filled = [&](const std::array<int, 3>& c) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (c[k] < 0 || c[k] >= cells[k]) return false;
    }
    return is_solid(c[0], c[1], c[2]);
  };
  Solid solid;
  // Adds the face between a filled cell and an empty neighbour along `axis`, on side 0 (low) or 1 (high).
  const auto add_face = [&](const std::array<int, 3>& cell, std::size_t axis, int side) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](int du, int dv) {
      Vec3 p;
      p[static_cast<int>(axis)] = breaks[axis][static_cast<std::size_t>(cell[axis] + side)];
      p[static_cast<int>(u)] = breaks[u][static_cast<std::size_t>(cell[u] + du)];
      p[static_cast<int>(v)] = breaks[v][static_cast<std::size_t>(cell[v] + dv)];
      return p;
    };
    if (side == 1) {
      add_quad(solid, corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
    } else {
      add_quad(solid, corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0));
    }
  };
  for (int i = 0; i < cells[0]; ++i) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int k = 0; k < cells[2]; ++k) {
        const std::array<int, 3> cell = {i, j, k};
        if (!filled(cell)) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          for (int side = 0; side < 2; ++side) {
            std::array<int, 3> neighbour = cell;
            neighbour[axis] += side == 1 ? 1 : -1;
            if (!filled(neighbour)) add_face(cell, axis, side);
          }
        }
      }
    }
  }
  return solid;
}

Solid make_box(const Vec3& low, const Vec3& high) {
  const std::array<double, 2> x = {low.x(), high.x()}, y = {low.y(), high.y()}, z = {low.z(), high.z()};
  return make_grid_solid(x, y, z, [](int, int, int) { return true; });
}

std::string stl_bytes(const Solid& solid) {
  std::string out = "gougecheck sample, binary STL";
  out.resize(80, ' ');
  append_u32(out, static_cast<std::uint32_t>(solid.size()));
  for (const Triangle& triangle : solid) {
    append_point(out, Vec3::Zero());
    for (const Vec3& corner : triangle) append_point(out, corner);
    out.append(2, '\0');
  }
  return out;
}

}  // namespace gouge::samples
