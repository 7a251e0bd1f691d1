#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "lib/base/number_text.h"
#include "tests/postproc/gcode/siemens/siemens_program.h"
#include "tests/support/scatter.h"

// Random chains of frames against 4x4 matrices, which share no formula with the reader.

namespace gouge::siemens_chain_test {
namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

Matrix identity() {
  Matrix made{};
  for (std::size_t i = 0; i < 4; ++i) made[i][i] = 1;
  return made;
}

Matrix times(const Matrix& a, const Matrix& b) {
  Matrix made{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) made[i][j] += a[i][k] * b[k][j];
  return made;
}

/// Turn about an axis, 0 for X, by its two rows of sine and cosine.
Matrix turn(std::size_t axis, double degrees) {
  Matrix made = identity();
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  made[u][u] = made[v][v] = c;
  made[u][v] = -s;
  made[v][u] = s;
  return made;
}

/// A statement and its matrix.
std::pair<std::string, Matrix> random_frame(test::Scatter& scatter) {
  std::array<double, 3> value{};
  for (double& one : value) one = std::round(scatter.in(-100, 100) * 8) / 8;
  const auto words = [&] {
    return " X" + exact_text(value[0]) + " Y" + exact_text(value[1]) + " Z" + exact_text(value[2]);
  };
  Matrix made = identity();
  switch (scatter.below(4)) {
    case 0:
      for (std::size_t i = 0; i < 3; ++i) made[i][3] = value[i];
      return {"TRANS" + words(), made};
    case 1:
      return {"ROT" + words(), times(times(turn(2, value[2]), turn(1, value[1])), turn(0, value[0]))};
    case 2: {
      const std::size_t axis = scatter.below(3);
      made[axis][axis] = -1;
      return {std::string("MIRROR ") + "XYZ"[axis] + "1", made};
    }
    default:
      for (std::size_t i = 0; i < 3; ++i) made[i][i] = 0.5;
      return {"SCALE X0.5 Y0.5 Z0.5", made};
  }
}

TEST(SiemensChain, RandomChainsOfFramesAgreeWithMatrices) {
  test::Scatter scatter(2026);
  for (int i = 0; i < 500; ++i) {
    Matrix all = identity();
    std::string blocks;
    const std::size_t frames = 1 + scatter.below(6);
    for (std::size_t k = 0; k < frames; ++k) {
      const auto [block, matrix] = random_frame(scatter);
      const bool is_additive = k > 0 && scatter.is(0.8);
      blocks += (is_additive ? "A" : "") + block + "\n";
      all = is_additive ? times(all, matrix) : matrix;
    }
    const Vec3 p(std::round(scatter.in(-50, 50)), std::round(scatter.in(-50, 50)), std::round(scatter.in(-50, 50)));
    blocks += "G1 X" + exact_text(p.x()) + " Y" + exact_text(p.y()) + " Z" + exact_text(p.z()) + " F100\n";
    Vec3 expected = Vec3::Zero();
    for (std::size_t row = 0; row < 3; ++row) {
      expected[static_cast<int>(row)] = all[row][3];
      for (std::size_t k = 0; k < 3; ++k) expected[static_cast<int>(row)] += all[row][k] * p[static_cast<int>(k)];
    }
    test::expect_at(test::tip_after(blocks), expected.x(), expected.y(), expected.z(), 1e-9);
  }
}

}  // namespace
}  // namespace gouge::siemens_chain_test
