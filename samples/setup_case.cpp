#include <array>

#include "samples/cases.h"
#include "samples/cl_text.h"

// A sample with a wrong set-up and a correct path.

namespace gouge::samples {
namespace {

constexpr double kSunk = 2;

/// Returns a block with a pocket, y from 0 to 60.
Solid make_block() {
  const std::array<double, 4> x = {0, 20, 80, 100}, y = {0, 15, 45, 60};
  const std::array<double, 3> z = {0, 25, 40};
  return make_grid_solid(x, y, z, [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
}

/// Returns a vise jaw whose nose reaches into the block.
Solid make_jaw() {
  const std::array<double, 2> x = {10, 90};
  const std::array<double, 3> y = {-40, -20, kSunk}, z = {-10, 5, 30};
  return make_grid_solid(x, y, z, [](int, int j, int k) { return j == 0 || k == 1; });
}

}  // namespace

Sample make_sunk_jaw() {
  Sample sample;
  sample.name = "sunk_jaw";
  sample.about =
      "A pocket cleared without a gouge, in a block that its vise jaw reaches 2 mm into: a warning, and a clash";
  sample.toolpath_file = "sunk_jaw.apt";
  sample.tools =
      R"({"units":"mm","tools":[{"number":1,"name":"flat D10","cutter":{"shape":"flat","diameter":10,"length":30},
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";
  sample.parts.push_back({"part.stl", make_block()});
  sample.fixtures.push_back({"jaw.stl", make_jaw()});
  sample.overlap = kSunk;
  ClText cl(ClText::Form::apt_xyz);
  cl.line("PARTNO/SUNK JAW");
  cl.line("UNITS/MM");
  cl.line("LOADTL/1");
  cl.rapid({Vec3(25, 20, 60), Vec3::UnitZ()});
  cl.line("FEDRAT/600.0000, MMPM");
  for (int level = 0; level < 3; ++level) {
    for (int row = 0; row <= 4; ++row) {
      const double y = 20 + 5 * row, z = 35 - 5 * level;
      for (const double x : {row % 2 == 0 ? 25.0 : 75.0, row % 2 == 0 ? 75.0 : 25.0})
        cl.feed({Vec3(x, y, z), Vec3::UnitZ()});
    }
    cl.rapid({Vec3(75, 40, 60), Vec3::UnitZ()});
    cl.rapid({Vec3(25, 20, 60), Vec3::UnitZ()});
  }
  cl.line("FINI");
  sample.toolpath = cl.text();
  sample.moves = cl.positions();
  return sample;
}

}  // namespace gouge::samples
