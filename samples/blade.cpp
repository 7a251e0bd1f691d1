#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "samples/cases.h"
#include "samples/cl_text.h"

// A twisted blade: an ellipse of half axes 20 x 3 mm carried up 60 mm while it turns by 35 degrees. A tapered ball
// mills it in one spiral, with its axis 60 degrees from the surface normal. Every section is convex. So a ball on the
// true surface enters the mesh for two reasons only: the twist (below 3 um) and the chords of the path (below 4 um).

namespace gouge::samples {
namespace {

constexpr double kBladeTurn = 2 * std::numbers::pi;
constexpr double kA = 20, kB = 3, kHeight = 60, kTwist = 35 * kBladeTurn / 360 / kHeight;
constexpr double kBall = 2, kBladeAllowance = 0.006;

Vec3 turned(double x, double y, double z) {
  const double c = std::cos(kTwist * z), s = std::sin(kTwist * z);
  return {c * x - s * y, s * x + c * y, z};
}

Vec3 surface(double u, double z) { return turned(kA * std::cos(u), kB * std::sin(u), z); }

Vec3 blade_normal(double u, double z) {
  const Vec3 along_u = turned(-kA * std::sin(u), kB * std::cos(u), z) - Vec3(0, 0, z);
  const Vec3 p = surface(u, z);
  const Vec3 along_z(-kTwist * p.y(), kTwist * p.x(), 1);
  return along_u.cross(along_z).normalized();
}

Solid make_blade_part() {
  constexpr int kAround = 160, kRows = 60;
  const auto section = [](double z) {
    Ring ring;
    for (int i = 0; i < kAround; ++i) ring.push_back(surface(kBladeTurn * i / kAround, z));
    return ring;
  };
  Solid solid;
  Ring lower = section(0);
  add_cap(solid, Vec3(0, 0, 0), lower, true);
  for (int row = 1; row <= kRows; ++row) {
    const Ring upper = section(kHeight * row / kRows);
    add_strip(solid, upper, lower);
    lower = upper;
  }
  add_cap(solid, Vec3(0, 0, kHeight), lower);
  return solid;
}

struct BladePosition {
  Pose pose;
  double depth = 0;
};

BladePosition blade_position(double u, double z, double push) {
  const Vec3 n = blade_normal(u, z);
  const Vec3 outward = Vec3(n.x(), n.y(), 0).normalized();
  BladePosition p;
  p.pose.axis = (0.5 * outward + std::sqrt(0.75) * Vec3::UnitZ()).normalized();
  p.pose.tip = surface(u, z) + (kBall + kBladeAllowance - push) * n - kBall * p.pose.axis;
  p.depth = push - kBladeAllowance;
  return p;
}

/// Returns the step of u from here: 1.5 mm, or less if the normal would turn by more than 0.08.
double step_at(double u) {
  const double c = std::cos(u), s = std::sin(u);
  const double length = std::sqrt(kA * kA * s * s + kB * kB * c * c);
  const double turn = kA * kB / (kB * kB * c * c + kA * kA * s * s);
  return std::min(1.5 / length, 0.08 / turn);
}

std::vector<BladePosition> make_spiral() {
  std::vector<BladePosition> spiral;
  int pushed_in_first = 0, pushed_in_second = 0;
  double u = 0, z = 56;
  while (z > 6) {
    const bool is_on_flank = std::abs(std::sin(u)) > 0.95;
    double push = 0;
    if (is_on_flank && spiral.size() > 400 && pushed_in_first < 4) {
      push = 0.1;
      ++pushed_in_first;
    } else if (is_on_flank && spiral.size() > 900 && pushed_in_second < 1) {
      push = 0.25;
      ++pushed_in_second;
    }
    spiral.push_back(blade_position(u, z, push));
    // The edges are sharp, so the step must be small enough for both of its ends.
    const double step = std::min(step_at(u), step_at(u + step_at(u)));
    u += step;
    z -= 4 * step / kBladeTurn;
  }
  return spiral;
}

Pose raised_blade(const Pose& pose, double by) { return {pose.tip + by * pose.axis, pose.axis}; }

}  // namespace

Sample make_blade() {
  Sample sample;
  sample.name = "blade";
  sample.about =
      "A twisted blade milled in one spiral with a tapered ball D4 from a CLSF with a turned MSYS: five bad points";
  sample.toolpath_file = "blade.cls";
  sample.tools =
      R"({"units":"mm","tools":[{"number":7,"name":"tapered ball D4","cutter":{"shape":"tapered","diameter":4,"corner_radius":2,"taper_angle":5,"length":30},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
  "holder":[{"lower_diameter":26,"upper_diameter":30,"length":40}]}]}
)";
  sample.parts.push_back({"blade.stl", make_blade_part()});
  sample.check_exit = 1;
  RigidTransform block;  // the transformation that the MSYS below states: X along +Y, Y along -X
  block.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  block.shift = Vec3(10, 20, 5);
  ClText cl(ClText::Form::nx, block.inverse());
  cl.line("TOOL PATH/BLADE_SPIRAL,TOOL,TAPERED_BALL_D4");
  cl.line("TLDATA/MILL,4.0000,2.0000,30.0000,5.0000,0.0000");
  cl.line("MSYS/10.0000,20.0000,5.0000,0.0000000,1.0000000,0.0000000,-1.0000000,0.0000000,0.0000000");
  cl.line("$$ centerline data");
  cl.line("PAINT/PATH");
  cl.line("LOAD/TOOL,7");
  const std::vector<BladePosition> spiral = make_spiral();
  cl.rapid({Vec3(0, 0, 150), Vec3::UnitZ()});
  cl.rapid(raised_blade(spiral.front().pose, 20));
  cl.line("PAINT/COLOR,31");
  cl.line("FEDRAT/MMPM,900.0000");
  double before = 0;
  for (const BladePosition& p : spiral) {
    const std::size_t line = cl.feed(p.pose);
    const double depth = std::max(before, p.depth);
    if (depth > 0) sample.findings.push_back({line, "gouge", "cutter", "part", depth - 0.01, depth + 0.01});
    before = p.depth;
  }
  cl.rapid(raised_blade(spiral.back().pose, 60));
  cl.rapid({Vec3(0, 0, 150), Vec3::UnitZ()});
  cl.line("END-OF-PATH");
  sample.toolpath = cl.text();
  sample.moves = cl.positions();
  return sample;
}

}  // namespace gouge::samples
