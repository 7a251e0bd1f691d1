// Answers the queries of a haptic device, a thousand a second. How deep is the tool at the position of the hand, and
// which way is out? The hand circles over a part of 20 000 triangles and presses into it. Prints the rate and the
// slowest result.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gougecheck/check.h>

using gougecheck::Vec3;

namespace {

// Returns a bowl of n * n squares, 80 mm wide: a surface without an inside, like a scan.
gougecheck::Mesh bowl(std::uint32_t n) {
  std::vector<Vec3> vertices;
  std::vector<gougecheck::Triangle> faces;
  for (std::uint32_t i = 0; i <= n; ++i) {
    for (std::uint32_t k = 0; k <= n; ++k) {
      const double x = 80.0 * i / n - 40, y = 80.0 * k / n - 40;
      vertices.push_back({x, y, 0.01 * (x * x + y * y)});
      const std::uint32_t a = i * (n + 1) + k, b = a + n + 1;
      if (i < n && k < n) faces.insert(faces.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    }
  }
  return {vertices, faces, "bowl"};
}

}  // namespace

int main() {
  using Clock = std::chrono::steady_clock;
  try {
    const gougecheck::Tool tool("bull_nose", {{"diameter", 8}, {"corner_radius", 2}, {"length", 20}}, {{8, 8, 40}});
    const gougecheck::DepthQuery query(bowl(100), tool);
    constexpr int kTicks = 1000;
    double slowest = 0, deepest = 0;
    const auto start = Clock::now();
    for (int tick = 0; tick < kTicks; ++tick) {
      const double angle = 0.0063 * tick, press = 0.3 * std::sin(0.05 * tick);
      const Vec3 tip = {25 * std::cos(angle), 25 * std::sin(angle), 7.2 - press};
      const auto before = Clock::now();
      const gougecheck::Contact contact = query.at(tip, {0, 0, 1});
      slowest = std::max(slowest, std::chrono::duration<double>(Clock::now() - before).count());
      deepest = std::max(deepest, contact.depth);  // the force would be contact.depth along contact.normal
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    std::printf("%.0f poses a second, the slowest took %.2f ms; deepest %.3f mm\n", kTicks / seconds, 1e3 * slowest,
                deepest);
    return 0;
  } catch (const gougecheck::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
