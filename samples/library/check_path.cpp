// Checks a path in memory against a part in memory: a ball end mill crosses a block, once above it and once too deep.
// Prints every gouge with its witness. The exit status is 1 if there is a gouge.

#include <cstdio>
#include <vector>

#include <gougecheck/check.h>

using gougecheck::Vec3;

namespace {

// Returns a block from (0, 0, -10) to (40, 20, 0), mm; its top is the plane z = 0.
gougecheck::Mesh block() {
  const std::vector<Vec3> corners = {{0, 0, -10}, {40, 0, -10}, {40, 20, -10}, {0, 20, -10},
                                     {0, 0, 0},   {40, 0, 0},   {40, 20, 0},   {0, 20, 0}};
  const std::vector<gougecheck::Triangle> faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                                   {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  return {corners, faces, "block"};
}

}  // namespace

int main() {
  try {
    const gougecheck::Tool tool("ball", {{"diameter", 10}, {"length", 30}}, {{10, 10, 20}}, {{32, 32, 40}});
    const std::vector<Vec3> tips = {{-10, 10, 0.5}, {50, 10, 0.5}, {50, 12, 5}, {50, 12, -0.25}, {-10, 12, -0.25}};
    const std::vector<Vec3> axes = {{0, 0, 1}};  // one axis for all positions
    const gougecheck::Path path(tips, axes);
    const gougecheck::Report report = gougecheck::check(path, block(), tool);
    for (std::size_t move = 0; move < report.size(); ++move) {
      if (report.state()[move] != gougecheck::State::gouge) continue;
      const Vec3& point = report.point()[move];
      std::printf("move %zu: gouge of %.3f mm at (%.3f, %.3f, %.3f), t = %.3f, face %lld\n", move, report.depth()[move],
                  point[0], point[1], point[2], report.t()[move], static_cast<long long>(report.triangle()[move]));
    }
    std::printf("%zu of %zu moves are clean\n", report.count(gougecheck::State::clean), report.size());
    return report.is_clean() ? 0 : 1;
  } catch (const gougecheck::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
