#include "lib/hierarchy/block_tree.h"

#include <algorithm>

namespace gouge {

std::size_t BlockTree::mesh_of(std::uint32_t triangle) const {
  if (meshes.size() == 1) return 0;
  const auto after = std::upper_bound(first_triangle.begin(), first_triangle.end(), triangle);
  return static_cast<std::size_t>(after - first_triangle.begin()) - 1;
}

std::array<Vec3, 3> BlockTree::corners(std::uint32_t triangle) const {
  const std::size_t m = mesh_of(triangle);
  const std::size_t t = triangle - first_triangle[m];
  return {meshes[m]->corner(t, 0), meshes[m]->corner(t, 1), meshes[m]->corner(t, 2)};
}

std::uint32_t BlockTree::file_triangle(std::uint32_t triangle) const {
  const std::size_t m = mesh_of(triangle);
  return meshes[m]->file_triangle[triangle - first_triangle[m]];
}

}  // namespace gouge
