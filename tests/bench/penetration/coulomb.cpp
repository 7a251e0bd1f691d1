#include "tests/bench/penetration/coulomb.h"

#include <cmath>
#include <numbers>

namespace gouge {
namespace {

constexpr int kMaxSteps = 20000;
constexpr double kConverged = 1e-13;
constexpr double kSmallestStep = 1e-12;

/// Half of a Fibonacci spiral: no two ends coincide, none opposes another.
std::vector<Vec3> spiral(std::size_t count) {
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Vec3> axes;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double r = std::sqrt(1 - z * z), angle = turn * static_cast<double>(i);
    axes.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  return axes;
}

/// Force on each axis' positive end by all other ends.
std::vector<Vec3> forces(std::span<const Vec3> axes) {
  std::vector<Vec3> all(axes.size(), Vec3::Zero());
  for (std::size_t i = 0; i < axes.size(); ++i) {
    for (std::size_t j = 0; j < axes.size(); ++j) {
      if (i == j) continue;
      const Vec3 near = axes[i] - axes[j], far = axes[i] + axes[j];
      all[i] += near / std::pow(near.squaredNorm(), 1.5) + far / std::pow(far.squaredNorm(), 1.5);
    }
    all[i] -= all[i].dot(axes[i]) * axes[i];
  }
  return all;
}

}  // namespace

double coulomb_energy(std::span<const Vec3> axes) {
  double energy = 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    energy += 0.5 / axes[i].norm();
    for (std::size_t j = 0; j < i; ++j) energy += 2 / (axes[i] - axes[j]).norm() + 2 / (axes[i] + axes[j]).norm();
  }
  return energy;
}

std::vector<Vec3> spread_axes(std::size_t count) {
  std::vector<Vec3> axes = spiral(count);
  double energy = coulomb_energy(axes);
  double step = 0.1 / static_cast<double>(count);
  for (int i = 0; i < kMaxSteps && step > kSmallestStep; ++i) {
    const std::vector<Vec3> push = forces(axes);
    std::vector<Vec3> next = axes;
    for (std::size_t a = 0; a < count; ++a) next[a] = (axes[a] + step * push[a]).normalized();
    const double next_energy = coulomb_energy(next);
    if (!(next_energy < energy)) {
      step *= 0.5;
      continue;
    }
    const bool has_converged = energy - next_energy < kConverged * energy;
    axes = std::move(next);
    energy = next_energy;
    step *= 1.2;
    if (has_converged) break;
  }
  return axes;
}

}  // namespace gouge
