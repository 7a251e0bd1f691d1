#pragma once

#include <array>
#include <string>

namespace gouge::testing_samples {

/// A box as an STL file of text.
inline std::string box_stl(const std::array<double, 3>& low, const std::array<double, 3>& high) {
  // Two triangles for each face, corners numbered by bits: x 1, y 2, z 4.
  constexpr std::array<std::array<int, 3>, 12> kFaces{{{0, 2, 1},
                                                       {1, 2, 3},
                                                       {4, 5, 6},
                                                       {5, 7, 6},
                                                       {0, 1, 4},
                                                       {1, 5, 4},
                                                       {2, 6, 3},
                                                       {3, 6, 7},
                                                       {0, 4, 2},
                                                       {2, 4, 6},
                                                       {1, 3, 5},
                                                       {3, 7, 5}}};
  std::string text = "solid box\n";
  for (const auto& face : kFaces) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : face) {
      text += "vertex";
      for (std::size_t k = 0; k < 3; ++k)
        text += " " + std::to_string(((corner >> k) & 1) != 0 ? high.at(k) : low.at(k));
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

}  // namespace gouge::testing_samples
