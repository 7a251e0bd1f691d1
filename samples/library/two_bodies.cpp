// Answers whether two bodies of a set-up penetrate, how deep, and which shift frees them. The bodies are STL files, or
// two cubes of 10 mm. One of the cubes is turned by 45 degrees and pushed 1 mm into the other. The exit status is 1 if
// they penetrate.

#include <cmath>
#include <cstdio>
#include <vector>

#include <gougecheck/penetration.h>

using gougecheck::Vec3;

namespace {

gougecheck::Mesh cube() {
  std::vector<Vec3> corners;
  for (const double z : {-5.0, 5.0}) corners.insert(corners.end(), {{-5, -5, z}, {5, -5, z}, {5, 5, z}, {-5, 5, z}});
  const std::vector<gougecheck::Triangle> faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                                   {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return {corners, faces, "cube"};
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const bool has_files = count == 3;
    const gougecheck::Mesh a = has_files ? gougecheck::Mesh::read_stl(arguments[1]) : cube();
    const gougecheck::Mesh b = has_files ? gougecheck::Mesh::read_stl(arguments[2]) : cube();
    gougecheck::Transform pose;
    if (!has_files) {
      const double c = std::sqrt(0.5);
      pose = {{c, -c, 0, c, c, 0, 0, 0, 1}, {5 + 5 * std::sqrt(2.0) - 1, 0, 0}};
    }
    gougecheck::PenetrationOptions options;
    options.find_shift = true;
    const gougecheck::Penetration found = gougecheck::penetration(a, b, pose, options);
    std::printf("%s: %.4f to %.4f mm deep\n", gougecheck::state_name(found.state), found.depth, found.depth_upper);
    if (found.shift)
      std::printf("free after a shift of B by (%.4f, %.4f, %.4f)\n", (*found.shift)[0], (*found.shift)[1],
                  (*found.shift)[2]);
    if (found.state == gougecheck::ClashState::not_certified) std::printf("%s\n", found.reason.c_str());
    return found.state == gougecheck::ClashState::penetrating ? 1 : 0;
  } catch (const gougecheck::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
