#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "lib/check/scene.h"
#include "lib/path/toolpath.h"
#include "postproc/formats/read_toolpath.h"
#include "tests/support/scatter.h"
#include "tests/support/shapes.h"
#include "tests/support/solids.h"
#include "tests/support/tools.h"

// Random programs over random solids, written as CL data and read by the program's own reader: most moves clean, some a
// little or much too deep, feeds, rapids, arcs, tilted axes and holes. The same for a number on every machine.

namespace gouge::laws {

struct CorrectionScene {
  std::string text;
  Toolpath path;
  Scene scene;
  ToolVariants tool = tools::ball();
  double tolerance_mm = 0.01;
  std::optional<double> max_side_shift_mm;
};

class CorrectionScatter {
 public:
  explicit CorrectionScatter(std::uint64_t number) : random_(number * 7919 + 17) {}

  CorrectionScene scene() {
    CorrectionScene made;
    static const std::vector<ToolVariants> kTools = [] {
      std::vector<ToolVariants> all = tools::all();
      for (ToolVariants& tool : tools::shapes()) all.push_back(std::move(tool));
      all.push_back(tools::variants(tools::assembly(BallCutter{10, 30}), 0.2, 0.3, 0.5));
      return all;
    }();
    made.tool = kTools[is(0.85) ? below(4) : below(kTools.size())];
    made.tolerance_mm = is(0.8) ? 0.01 : is(0.5) ? 0.05 : 0.002;
    if (is(0.2)) made.max_side_shift_mm = in(0, 3);
    add_solids(made.scene);
    made.text = program();
    ReadOutcome read = read_toolpath("random.ncl", made.text);
    if (read.toolpath) made.path = std::move(*read.toolpath);
    return made;
  }

 private:
  double in(double low, double high) { return random_.in(low, high); }
  bool is(double share) { return random_.is(share); }
  std::size_t below(std::size_t n) { return random_.below(n); }
  /// From 0.003 mm to 8 mm, all sizes alike.
  double some_depth() { return 0.003 * std::pow(2700, in(0, 1)); }

  /// A block whose top is z = 0, with something on it or in it.
  void add_solids(Scene& scene) {
    const double half = in(20, 40);
    if (is(0.2)) {
      scene.parts.push_back(shapes::moved(shapes::sphere(25, 16, 32), Vec3(0, 0, -25)));
    } else if (is(0.15)) {
      scene.parts.push_back(shapes::moved(shapes::bumpy_sphere(30, 3), Vec3(0, 0, -30)));
    } else {
      scene.parts.push_back(shapes::box(Vec3(-half, -half, -30), Vec3(half, half, 0)));
    }
    for (std::size_t k = below(4); k > 0; --k) {
      const Vec3 at(in(-25, 25), in(-25, 25), 0);
      const Vec3 size(in(0.05, 6), in(0.5, 30), in(0.5, 12));
      const bool is_thin_in_y = is(0.5);
      const Vec3 arm = is_thin_in_y ? Vec3(size.y(), size.x(), 0) : Vec3(size.x(), size.y(), 0);
      const IndexedMesh rib = shapes::box(at - arm - Vec3(0, 0, 5), at + arm + Vec3(0, 0, size.z()));
      (is(0.85) ? scene.parts : scene.fixtures).push_back(rib);
    }
    if (is(0.1))
      scene.parts.push_back(shapes::moved(shapes::star_prism(5, 15, 6, in(1, 8)), Vec3(in(-10, 10), in(-10, 10), 0)));
    if (is(0.08))
      scene.parts.push_back(shapes::moved(shapes::open_cube(12), Vec3(in(-20, 10), in(-20, 10), in(-4, 0))));
  }

  static std::string numbers(const Vec3& v, int decimals) {
    char text[96];
    std::snprintf(text, sizeof text, "%.*f, %.*f, %.*f", decimals, v.x(), decimals, v.y(), decimals, v.z());
    return text;
  }

  std::string go_to(const Vec3& tip) {
    std::string text = "GOTO / " + numbers(tip, 4);
    if (is_tilted_) text += ",  $\n" + numbers(axis_, 10);
    return text + "\n";
  }

  /// A row along the top, with dips, a jump over the block or an arc, or some holes.
  std::string program() {
    is_tilted_ = is(0.4);
    axis_ = Vec3(0, 0, 1);
    std::string text = "$$* Pro/CLfile\n$$-> MFGNO / X\nUNITS / MM\nLOADTL / 1\n";
    if (is_tilted_) text += "MULTAX / ON\n";
    const double level = is(0.7) ? 0 : in(-1, 4);
    Vec3 at(in(-30, 30), in(-30, 30), 40);
    text += "RAPID\n" + go_to(at);
    for (std::size_t k = 3 + below(7); k > 0; --k) {
      if (is_tilted_ && is(0.7)) axis_ = Vec3(in(-0.4, 0.4), in(-0.4, 0.4), 1).normalized();
      const double kind = in(0, 1);
      if (!is_tilted_ && kind < 0.15) {
        text += arc(at);
        continue;
      }
      if (!is_tilted_ && kind < 0.2) {
        text += holes(at);
        continue;
      }
      const double reach = is(0.5) ? 4 : 40;
      at += Vec3(in(-reach, reach), in(-reach, reach), 0);
      at.z() = is(0.1) ? 30 : is(0.3) ? level - some_depth() : level + (is(0.5) ? 0 : in(0, 2));
      if (is(0.15)) text += "RAPID\n";
      text += go_to(at);
    }
    return text + "RAPID\n" + go_to(Vec3(at.x(), at.y(), 60)) + "FINI\n";
  }

  std::string arc(Vec3& at) {
    const double radius = in(2, 20), from = in(0, 2 * std::numbers::pi), sweep = in(0.3, 6);
    const auto on = [&](double angle) { return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0); };
    Vec3 start = at;
    start.z() = is(0.5) ? 0 : -some_depth();
    const Vec3 center = start - on(from);
    at = center + on(from + sweep);
    char text[160];
    std::snprintf(text, sizeof text, "CIRCLE / %s,  $\n0.0000000000, 0.0000000000, 1.0000000000,  %.6f\n",
                  numbers(center, 4).c_str(), radius);
    return go_to(start) + text + go_to(at);
  }

  std::string holes(Vec3& at) {
    const double bottom = is(0.5) ? 0.01 * in(-2, 2) : in(-3, 1);
    at.z() = is(0.5) ? 0 : in(-1, 1);
    char text[128];
    std::snprintf(text, sizeof text, "CYCLE / DRILL, DEPTH, %.4f, MMPM, 100, CLEAR, 3\n",
                  std::max(0.01, at.z() - bottom));
    std::string all = go_to(Vec3(at.x(), at.y(), 20)) + text;
    for (std::size_t k = 1 + below(3); k > 0; --k) {
      all += go_to(at);
      at += Vec3(in(-15, 15), in(-15, 15), 0);
    }
    at.z() = 25;
    return all + "CYCLE / OFF\n" + go_to(at);
  }

  test::Scatter random_;
  bool is_tilted_ = false;
  Vec3 axis_ = Vec3::UnitZ();
};

}  // namespace gouge::laws
