#include <array>

#include "samples/cases.h"
#include "samples/small_case.h"

// Samples of remaining stock: clean against the part, and not against the material around it.

namespace gouge::samples {
namespace {

Pose upright(double x, double y, double z) { return {Vec3(x, y, z), Vec3::UnitZ()}; }

std::string flat_d10(const std::string& flutes) {
  return R"({"units":"mm","tools":[{"number":1,"name":"flat D10","cutter":{"shape":"flat","diameter":10,"length":)" +
         flutes + R"(},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":5}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";
}

}  // namespace

// A slot 10 mm wide and 5 mm deep at y = 10, and the way back at y = 30 as a rapid through 5 mm of stock.
Sample make_rapid_stock() {
  Sample sample = small_case("rapid_stock",
                             "A slot, and a rapid back beside it: clean on the finished part, and through 5 mm of "
                             "material with --stock part+5",
                             flat_d10("25"), 0);
  sample.parts.push_back({"part.stl", make_box({0, 0, -30}, {80, 60, -5})});
  ClText cl = start_text(sample);
  cl.rapid(upright(-40, 10, 30));
  cl.rapid(upright(-40, 10, -5));
  cl.feed(upright(120, 10, -5));
  cl.rapid(upright(120, 10, 30));
  cl.rapid(upright(120, 30, 30));
  cl.rapid(upright(120, 30, -5));
  cl.rapid(upright(-40, 30, -5));
  finish_sweep(sample, cl);
  return sample;
}

// A slot at y = 30 in three levels, 28 mm deep. The holder begins 20 mm above the tip, so it is 8 mm below the face of a box
// about the part, whose post reaches up to z = 0.
Sample make_holder_stock() {
  Sample sample = small_case("holder_stock",
                             "A slot 28 mm deep with a holder 20 mm above the tip: clean on the finished part, and the "
                             "holder 8 mm in the walls of the slot with --stock box",
                             flat_d10("15"), 0);
  const std::array<double, 3> x = {0, 90, 100}, y = {0, 4, 60}, z = {-40, -28, 0};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 0); })});
  ClText cl = start_text(sample);
  cl.rapid(upright(-40, 30, 30));
  for (const double level : {-10.0, -20.0, -28.0}) {
    cl.rapid(upright(-40, 30, level));
    cl.feed(upright(140, 30, level));
    cl.rapid(upright(140, 30, 30));
    cl.rapid(upright(-40, 30, 30));
  }
  finish_sweep(sample, cl);
  return sample;
}

// An end mill of radius 5 clears a floor between two walls 15 mm high, which meet in a square corner at (0, 0). Material stays
// in the corner, up to (1 - 1 / sqrt(2)) * 5 = 1.464 mm from the walls.
Sample make_excess_corner() {
  Sample sample = small_case("excess_corner",
                             "A floor and two walls with a square corner: clean, and 1.464 mm of material stays in the "
                             "corner with --stock box --excess 0.1",
                             flat_d10("25"), 0);
  const std::array<double, 3> x = {-10, 0, 40}, y = {-10, 0, 30}, z = {-10, 0, 15};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || i == 0 || j == 0; })});
  ClText cl = start_text(sample);
  cl.rapid(upright(60, 5, 30));
  cl.rapid(upright(60, 5, 0));
  cl.feed(upright(5, 5, 0));
  cl.feed(upright(5, 50, 0));
  for (const double row : {29.0, 21.0, 13.0}) {
    cl.feed(upright(60, 50, 0));
    cl.feed(upright(60, row, 0));
    cl.feed(upright(5, row, 0));
    cl.feed(upright(60, row, 0));
  }
  cl.rapid(upright(60, 13, 30));
  finish_sweep(sample, cl);
  return sample;
}

}  // namespace gouge::samples
