#include <array>
#include <cmath>
#include <numbers>

#include "samples/cases.h"
#include "samples/small_case.h"

// Samples of machines: clean as CL data, another verdict by the law or the limits of their machine.json.

namespace gouge::samples {
namespace {

constexpr const char* kBallD10 =
    R"({"units":"mm","tools":[{"number":1,"name":"ball D10","cutter":{"shape":"ball","diameter":10,"length":40},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";

/// A post of 2 by 2 mm about (x, 0) up to `top`, on a plate far below.
NamedSolid post(double at_x, double top) {
  const std::array<double, 4> x = {-60, at_x - 1, at_x + 1, 60}, y = {-30, -1, 1, 30};
  const std::array<double, 3> z = {-40, -30, top};
  return {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); })};
}

Pose leaning(const Vec3& tip, double degrees, double around_degrees = 0) {
  const double s = degrees * std::numbers::pi / 180, c = around_degrees * std::numbers::pi / 180;
  return {tip, Vec3(std::sin(s) * std::cos(c), std::sin(s) * std::sin(c), std::cos(s))};
}

/// A table that turns about C on a trunnion that turns about B; `more` is added to joint B.
std::string trunnion(const std::string& name, const std::string& more, const std::string& laws) {
  return R"({"name": ")" + name + R"(", "source": "an example of this program",
 "joints": [
  {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true, "rate": 7200},
  {"name": "B", "type": "rotary", "side": "table", "direction": [0, 1, 0], "point": [0, 0, -50], "rate": 3600)" +
         more + R"(},
  {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0], "rate": 4000},
  {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0], "rate": 4000},
  {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1], "rate": 6000}],
 "control": {"name": "example", )" +
         laws + R"(, "source": "an example of this program"}}
)";
}

constexpr const char* kAxisLaws = R"("feed_law": "axis", "rapid_law": "axis")";

}  // namespace

// B turns from -s to s while the gauge point stays as high as L cos s above the tips: half way the tool is upright and
// its tip L (1 - cos s) lower. A ball over a post then is that much deeper in it, less what it stood above.
Sample make_rapid_joints() {
  constexpr double kLean = 30, kLength = 100, kAbove = 10;
  Sample sample = small_case("rapid_joints",
                             "A rapid swings a head over a post: clean while the control keeps the tip on its line, in "
                             "the post where all joints run evenly (--tool-length 100)",
                             kBallD10, 0);
  sample.machine = R"({"name": "swing head", "source": "an example of this program",
 "joints": [
  {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "point": [0, 0, 0], "continuous": true},
  {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
  {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
  {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
  {"name": "B", "type": "rotary", "side": "head", "direction": [0, 1, 0], "point": [0, 0, 0]}],
 "control": {"name": "example", "feed_law": "vector", "rapid_law": "joint", "source": "an example of this program"}}
)";
  sample.parts.push_back(post(0, 0));
  ClText cl = start_text(sample);
  cl.feed(leaning({-40, 0, kAbove}, -kLean));
  const std::size_t line = cl.rapid(leaning({40, 0, kAbove}, kLean));
  const double depth = kLength * (1 - std::cos(kLean * std::numbers::pi / 180)) - kAbove;
  sample.by_machine.push_back({line, "gouge", "cutter", "part", depth - 1e-3, depth + 1e-3});
  finish_sweep(sample, cl);
  return sample;
}

// Z falls by 30 mm at 6000 mm/min, X runs 80 mm at 4000 mm/min: Z arrives after a quarter of the time, at x = -20. From
// there the ball passes 4 mm deep over the post at x = -18. At one speed for all axes Z arrives at x = -10 only.
Sample make_rapid_independent() {
  Sample sample =
      small_case("rapid_independent",
                 "A rapid falls beside a post: clean on its line, 4 mm in the post where each joint runs at "
                 "its own rate",
                 kBallD10, 0);
  sample.machine = trunnion("own rates", "", R"("feed_law": "vector", "rapid_law": "independent")");
  sample.parts.push_back(post(-18, 14));
  ClText cl = start_text(sample);
  cl.feed({Vec3(-40, 0, 40), Vec3::UnitZ()});
  const std::size_t line = cl.rapid({Vec3(40, 0, 10), Vec3::UnitZ()});
  sample.by_machine.push_back({line, "gouge", "cutter", "part", 4 - 1e-3, 4 + 1e-3});
  finish_sweep(sample, cl);
  return sample;
}

// The second position needs B at 40 degrees.
Sample make_axis_limit() {
  Sample sample = small_case("axis_limit", "A position leans by 40 degrees, and joint B ends at 35", kBallD10, 0);
  sample.machine = trunnion("short trunnion", R"(, "min": -35, "max": 35)", kAxisLaws);
  sample.parts.push_back(post(0, 0));
  ClText cl = start_text(sample);
  cl.feed(leaning({-40, 0, 30}, 10));
  cl.feed(leaning({40, 0, 30}, 40));
  finish_sweep(sample, cl);
  return sample;
}

// Both axes lean by half a degree, a quarter turn of C apart: the axis turns by 2 asin(sin 0.5 / sqrt 2) = 0.707 degrees.
Sample make_axis_flip() {
  Sample sample =
      small_case("axis_flip", "Near the pole joint C turns by 90 degrees, and the axis by 0.707", kBallD10, 0);
  sample.machine = trunnion("flip", "", kAxisLaws);
  sample.parts.push_back(post(0, 0));
  ClText cl = start_text(sample);
  cl.feed(leaning({-20, 0, 30}, 0.5, 0));
  cl.feed(leaning({20, 0, 30}, 0.5, 90));
  finish_sweep(sample, cl);
  return sample;
}

// The holder, of radius 20 from z = 60 to 100, passes the wall at a distance of 1 mm. If the axis leans by e, the point
// (21, 90) of the wall's upper edge has the distance 21 cos e - 90 sin e from the axis: it is 20 less that deep.
Sample make_smoothing_tube() {
  Sample sample =
      small_case("smoothing_tube",
                 "The holder passes a wall 1 mm beside it: clean, and 0.574 mm in the wall where the control "
                 "may lean the tool by a degree (--axis-tolerance 1)",
                 R"({"units":"mm","tools":[{"number":1,"name":"ball D10",
  "cutter":{"shape":"ball","diameter":10,"length":60},
  "holder":[{"lower_diameter":40,"upper_diameter":40,"length":40}]}]}
)",
                 0);
  sample.parts.push_back(
      {"part.stl", make_grid_solid(std::array<double, 2>{21, 60}, std::array<double, 2>{-50, 150},
                                   std::array<double, 2>{-20, 90}, [](int, int, int) { return true; })});
  ClText cl = start_text(sample);
  cl.feed({Vec3(0, 0, 0), Vec3::UnitZ()});
  cl.feed({Vec3(0, 100, 0), Vec3::UnitZ()});
  finish_sweep(sample, cl);
  return sample;
}

}  // namespace gouge::samples
