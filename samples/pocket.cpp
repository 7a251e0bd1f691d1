#include <cmath>
#include <numbers>

#include "samples/cases.h"
#include "samples/cl_text.h"

// A block with a pocket whose floor edge has a fillet of 3 mm. A bull-nose D16 r2 clears it down to the floor: the flat
// of the tool lies exactly on the floor. The wall is at 40 x 20 (half sizes), the floor at z = -15, the top at z = 0. A
// clamp 12 mm high stands on the block.

namespace gouge::samples {
namespace {

constexpr double kHalfX = 40, kHalfY = 20, kCorner = 12, kFillet = 3, kFloor = -15;

/// Returns a rectangle with rounded corners at height z. It begins at the corner at (+x, +y); each corner has `steps`
/// chords.
Ring rounded(double half_x, double half_y, double radius, double z, int steps) {
  Ring ring;
  for (int corner = 0; corner < 4; ++corner) {
    const double sx = corner == 0 || corner == 3 ? 1 : -1, sy = corner < 2 ? 1 : -1;
    for (int i = 0; i <= steps; ++i) {
      const double angle = std::numbers::pi / 2 * (corner + static_cast<double>(i) / steps);
      ring.emplace_back(sx * (half_x - radius) + radius * std::cos(angle),
                        sy * (half_y - radius) + radius * std::sin(angle), z);
    }
  }
  return ring;
}

Solid make_pocket_part() {
  constexpr int kSteps = 24, kFilletSteps = 12;
  Solid solid;
  const Ring outer_top = {{70, 50, 0}, {-70, 50, 0}, {-70, -50, 0}, {70, -50, 0}};
  Ring outer_base = outer_top;
  for (Vec3& p : outer_base) p.z() = -40;
  const Ring rim = rounded(kHalfX, kHalfY, kCorner, 0, kSteps);
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const std::size_t first = corner * (kSteps + 1), last = first + kSteps, next = (last + 1) % rim.size();
    for (std::size_t i = first; i < last; ++i) solid.push_back({outer_top[corner], rim[i + 1], rim[i]});
    add_quad(solid, outer_top[corner], outer_top[(corner + 1) % 4], rim[next], rim[last]);
  }
  Ring upper = rim;
  for (int k = 0; k <= kFilletSteps; ++k) {
    const double angle = std::numbers::pi / 2 * k / kFilletSteps;
    const double inset = kFillet * (1 - std::cos(angle));
    const double z = k == kFilletSteps ? kFloor : kFloor + kFillet * (1 - std::sin(angle));
    const Ring lower = rounded(kHalfX - inset, kHalfY - inset, kCorner - inset, z, kSteps);
    add_strip(solid, upper, lower, true);
    upper = lower;
  }
  add_cap(solid, Vec3(0, 0, kFloor), upper);
  add_strip(solid, outer_top, outer_base);
  add_cap(solid, Vec3(0, 0, -40), outer_base, true);
  return solid;
}

class PocketPath {
 public:
  PocketPath() {
    cl_.line("PARTNO/POCKET SAMPLE");
    cl_.line("UNITS/MM");
    cl_.line("CUTTER/16.000000, 2.000000, 6.000000, 2.000000, 0.000000, 0.000000, 40.000000");
    cl_.line("LOADTL/3");
  }

  std::size_t feed(double x, double y, double z) { return cl_.feed({Vec3(x, y, z), Vec3::UnitZ()}); }
  std::size_t rapid(double x, double y, double z) { return cl_.rapid({Vec3(x, y, z), Vec3::UnitZ()}); }

  void clear_level(double z) {
    for (int row = 0; row <= 4; ++row) {
      const double y = -8 + 4 * row, side = row % 2 == 0 ? 1 : -1;
      feed(-28 * side, y, z);
      feed(28 * side, y, z);
    }
  }

  void contour(double half_x, double half_y, double radius, double z) {
    const Ring ring = rounded(half_x, half_y, radius, z, 10);
    for (const Vec3& p : ring) feed(p.x(), p.y(), p.z());
    feed(ring.front().x(), ring.front().y(), z);
  }

  ClText& text() { return cl_; }

 private:
  ClText cl_{ClText::Form::apt_xyz};
};

void write_clean_part(PocketPath& path) {
  path.rapid(-28, -8, 30);
  path.rapid(-28, -8, 2);
  path.text().line("FEDRAT/800.0000, MMPM");
  path.feed(28, -8, 0);
  path.feed(-28, -8, -2.5);
  path.feed(28, -8, -5);
  path.clear_level(-5);
  path.feed(28, 8, -10);
  path.clear_level(-10);
  path.feed(28, 8, kFloor);
  path.clear_level(kFloor);
  // The centre of the tool's corner arc is 2 above the floor. The arc is clear of the fillet if the wall is at least 9
  // mm from the axis. The distance 9.2 leaves room for the fillet's chords.
  path.contour(kHalfX - 9.2, kHalfY - 9.2, kCorner - 9.2, kFloor);
}

}  // namespace

Sample make_pocket() {
  Sample sample;
  sample.name = "pocket";
  sample.about =
      "A filleted pocket cleared with a bull-nose D16 r2: one point cuts the wall, one rapid drags through the block, "
      "one hits the clamp";
  sample.toolpath_file = "pocket.apt";
  sample.tools =
      R"({"units":"mm","tools":[{"number":3,"name":"bull nose D16 r2","cutter":{"shape":"bull_nose","diameter":16,"corner_radius":2,"length":40},
  "shank":[{"lower_diameter":16,"upper_diameter":16,"length":20}],
  "holder":[{"lower_diameter":28,"upper_diameter":40,"length":20},{"lower_diameter":40,"upper_diameter":40,"length":40}]}]}
)";
  sample.parts.push_back({"part.stl", make_pocket_part()});
  sample.fixtures.push_back({"clamp.stl", make_box({45, -8, 0}, {65, 8, 12})});
  sample.check_exit = 1;
  PocketPath path;
  write_clean_part(path);
  // At z = -13.9 the corner arc is above the fillet's centre, so the side may come to within 0.05 mm of the wall.
  path.contour(kHalfX - 8.05, kHalfY - 8.05, kCorner - 8.05, -13.9);
  path.feed(0, -11.95, -13.9);
  // The side is 0.2 mm deep in the straight wall. The corner arc, which is above the fillet, is deepest at the wall too.
  for (const std::size_t line : {path.feed(1, -12.2, -13.9), path.feed(2, -11.95, -13.9)}) {
    sample.findings.push_back({line, "gouge", "cutter", "part", 0.1999, 0.2001});
  }
  path.rapid(0, 0, -13.9);
  path.rapid(0, 0, -2);
  sample.findings.push_back({path.rapid(-90, 0, -2), "gouge", "cutter", "part", 1.999, 2.001});
  path.rapid(-90, 0, 50);
  path.rapid(100, 0, 50);
  path.rapid(100, 0, 11);
  // The flat passes 1 mm below the top of the clamp.
  sample.findings.push_back({path.rapid(30, 0, 11), "gouge", "cutter", "fixture", 0.999, 1.001});
  path.rapid(30, 0, 50);
  path.text().line("FINI");
  sample.toolpath = path.text().text();
  sample.moves = path.text().positions();
  return sample;
}

}  // namespace gouge::samples
