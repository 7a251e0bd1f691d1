#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "lib/check/scene.h"
#include "lib/tool/compiled_tool.h"
#include "tests/support/paths.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"

// Random paths among random triangles: most near the boundary of the tool, some lying on it. The seed is printed; the
// environment variable GOUGE_SEED sets another.

namespace gouge::laws {

inline std::uint64_t seed() {
  static const std::uint64_t kSeed = [] {
    const char* given = std::getenv("GOUGE_SEED");
    const std::uint64_t chosen = given == nullptr ? 20260101 : std::strtoull(given, nullptr, 10);
    std::cout << "GOUGE_SEED=" << chosen << "\n";
    return chosen;
  }();
  return kSeed;
}

struct RandomScene {
  Toolpath path;
  Scene scene;
};

class SceneScatter : public test::Scatter {
 public:
  explicit SceneScatter(std::uint64_t stream) : Scatter(seed() * 1000003 + stream) {}

  /// Triangles about a tool that stands upright at the origin.
  IndexedMesh triangles(std::size_t count) {
    IndexedMesh mesh;
    mesh.name = "random";
    for (std::size_t k = 0; k < count; ++k) {
      const double nearest = in(0, 1) < 0.6 ? 4 : 20;
      const double angle = in(0, 2 * M_PI), far = nearest + in(0, 9), size = std::pow(10, in(-0.5, 1));
      const Vec3 at(far * std::cos(angle), far * std::sin(angle), in(-6, 110));
      for (int c = 0; c < 3; ++c) mesh.vertices.push_back(at + point(size));
      const std::size_t n = mesh.vertices.size();
      shapes::add_triangle(mesh, n - 3, n - 2, n - 1);
    }
    return mesh;
  }

  /// `largest_move` in mm; the axis turns by a tenth of it or less, in radians.
  std::vector<Pose> poses(std::size_t count, double largest_move) {
    std::vector<Pose> all{{point(1), axis(0.1)}};
    while (all.size() < count) {
      const double distance = largest_move * std::pow(10, in(-2, 0));
      // Some moves are pure rotations, some pure shifts.
      const double kind = in(0, 1);
      Pose next = all.back();
      if (kind > 0.2) next.tip += point(distance);
      if (kind < 0.8) next.axis = (next.axis + 0.03 * point(distance)).normalized();
      all.push_back(next);
    }
    return all;
  }

  /// One half of the scenes are deep in triangles, in the other the tool slides along them, clean or nearly so.
  RandomScene scene(const CompiledTool& tool) {
    const bool is_sliding = in(0, 1) < 0.5;
    RandomScene random{paths::through(poses(4, is_sliding ? 0.1 : 5)),
                       {{triangles(is_sliding ? 0 : 1 + below(4))}, {}}};
    for (std::size_t k = 1 + below(4); k > 0; --k) {
      add_touching(random.scene.parts[0], tool, random.path.moves[below(4)].end, is_sliding ? 0.02 : 0.3);
    }
    return random;
  }

 private:
  /// A triangle that all but lies on the tool at `pose`: in or near a tangent plane, deeper or away by `off` at most.
  void add_touching(IndexedMesh& mesh, const CompiledTool& tool, const Pose& pose, double off) {
    const BoundaryElement& e = tool.elements[below(tool.elements.size())];
    Vec2 at = e.a + in(0, 1) * (e.b - e.a);
    Vec2 out = e.normal;
    if (e.kind == ElementKind::arc) {
      out = (at - e.center).normalized();
      at = e.center + e.radius_mm * out;
    }
    const Vec3 u = pose.axis.unitOrthogonal();
    const Vec3 sideways = Eigen::AngleAxisd(in(-M_PI, M_PI), pose.axis) * u;
    const Vec3 normal = out.x() * sideways + out.y() * pose.axis;
    const double deeper = in(0, 1) < 0.3 ? 0.0 : (in(0, 1) < 0.5 ? off : -off) * std::pow(10, in(-3, 0));
    const Vec3 foot = pose.tip + at.x() * sideways + at.y() * pose.axis - deeper * normal;
    const double size = std::pow(10, in(-1, 1.7));
    const double lean = in(0, 1) < 0.5 ? 0.0 : off / size * std::pow(10, in(-3, 0));
    const double thin = in(0, 1) < 0.3 ? 1e-3 : 1.0;
    const Vec3 a = normal.unitOrthogonal(), b = normal.cross(a);
    for (int c = 0; c < 3; ++c) {
      mesh.vertices.push_back(foot + size * (in(-1, 1) * a + thin * in(-1, 1) * b + lean * in(-1, 1) * normal));
    }
    const std::size_t n = mesh.vertices.size();
    shapes::add_triangle(mesh, n - 3, n - 2, n - 1);
  }
};

}  // namespace gouge::laws
