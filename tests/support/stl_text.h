#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/number_text.h"
#include "lib/mesh/indexed_mesh.h"

// Writes STL files by hand, so that tests can damage them.

namespace gouge::shapes {

/// Returns the bytes of a binary STL file with this header text (padded with blanks to 80), this count, and triangles
/// of nine coordinates.
inline std::string binary_stl(const std::string& header, std::uint32_t count,
                              const std::vector<std::vector<float>>& triangles) {
  const auto append = [](std::string& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>((word >> shift) & 0xffU);
  };
  std::string bytes = header;
  bytes.resize(80, ' ');
  append(bytes, count);
  for (const std::vector<float>& triangle : triangles) {
    for (int k = 0; k < 3; ++k) append(bytes, 0);
    for (const float coordinate : triangle) append(bytes, std::bit_cast<std::uint32_t>(coordinate));
    bytes.append(2, '\0');
  }
  return bytes;
}

/// Returns the mesh as ASCII STL with exact numbers.
inline std::string ascii_stl(const IndexedMesh& mesh, const std::string& name = "test") {
  std::string text = "solid " + name + "\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    text += "  facet normal 0 0 0\n    outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = mesh.corner(t, k);
      text += "      vertex " + exact_text(v.x()) + " " + exact_text(v.y()) + " " + exact_text(v.z()) + "\n";
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

}  // namespace gouge::shapes
