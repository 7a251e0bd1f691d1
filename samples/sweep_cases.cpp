#include <array>
#include <cmath>
#include <numbers>

#include "samples/cases.h"
#include "samples/small_case.h"

// Small samples in which the motion decides, not the positions.

namespace gouge::samples {
namespace {

constexpr const char* kFlatD10 =
    R"({"units":"mm","tools":[{"number":1,"name":"flat D10","cutter":{"shape":"flat","diameter":10,"length":25},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":25}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";
constexpr const char* kFlatD6 =
    R"({"units":"mm","tools":[{"number":1,"name":"flat D6","cutter":{"shape":"flat","diameter":6,"length":20},
  "shank":[{"lower_diameter":6,"upper_diameter":6,"length":20}],
  "holder":[{"lower_diameter":30,"upper_diameter":30,"length":60}]}]}
)";

}  // namespace

Sample make_between_rib() {
  Sample sample =
      small_case("between_rib", "Both positions are clear, the rib between them is cut 3 mm deep", kFlatD10, 1);
  const std::array<double, 4> x = {-40, -1, 1, 40};
  const std::array<double, 2> y = {-30, 30};
  const std::array<double, 3> z = {-10, 0, 8};
  sample.parts.push_back({"part.stl", make_grid_solid(x, y, z, [](int i, int, int k) { return k == 0 || i == 1; })});
  ClText cl = start_text(sample);
  cl.feed({Vec3(-20, 0, 5), Vec3::UnitZ()});
  sample.findings.push_back({cl.feed({Vec3(20, 0, 5), Vec3::UnitZ()}), "gouge", "cutter", "part", 2.999, 3.001});
  finish_sweep(sample, cl);
  return sample;
}

Sample make_between_swing() {
  Sample sample = small_case(
      "between_swing", "The tip rests while the axis swings over: the holder grazes a post between two clear positions",
      R"({"units":"mm","tools":[{"number":1,"name":"ball D6","cutter":{"shape":"ball","diameter":6,"length":20},
  "shank":[{"lower_diameter":6,"upper_diameter":6,"length":20}],
  "holder":[{"lower_diameter":30,"upper_diameter":30,"length":30}]}]}
)",
      1);
  // The top corner (1, 11..13, 41) of the post is deepest when the axis points along (1, 0, 41). Its distance along the
  // axis is then sqrt(41^2 + 1), and the holder begins at 40.
  const std::array<double, 4> x = {-30, -1, 1, 30}, y = {-30, 11, 13, 30};
  const std::array<double, 3> z = {-12, -2, 41};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); })});
  const double deepest = std::sqrt(41.0 * 41.0 + 1) - 40;
  const double tilt = std::numbers::pi / 6;
  ClText cl = start_text(sample);
  cl.feed({Vec3(0, 0, 0), Vec3(std::sin(tilt), 0, std::cos(tilt))});
  const std::size_t line = cl.feed({Vec3(0, 0, 0), Vec3(-std::sin(tilt), 0, std::cos(tilt))});
  sample.findings.push_back({line, "gouge", "holder", "part", deepest - 1e-3, deepest + 1e-3});
  finish_sweep(sample, cl);
  return sample;
}

// Both axes lean by s, 45 degrees to either side of x. On the great circle the axis between them leans by atan(tan s
// cos 45). If a rotary table turns while its tilt stands still, the axis leans by s. Then the holder, of radius 16, is
// 1 mm deep over the front edge (x, 0, 60) of the post.
Sample make_pole_crossing() {
  Sample sample = small_case(
      "pole_crossing",
      "The tip rests while the axis turns past the pole: the holder passes a post on the great circle, and is 1 mm in it "
      "where A stands and C turns",
      R"({"units":"mm","tools":[{"number":1,"name":"ball D6","cutter":{"shape":"ball","diameter":6,"length":20},
  "shank":[{"lower_diameter":6,"upper_diameter":6,"length":20}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":60}]}]}
)",
      0);
  const double lean = std::numbers::pi / 18, height = 60, radius = 16, depth = 1;
  const double front = (radius - depth + height * std::sin(lean)) / std::cos(lean);
  const std::array<double, 4> x = {-30, front, front + 4, 40}, y = {-30, -1, 1, 30};
  const std::array<double, 3> z = {-12, -3.5, height};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); })});
  const double out = std::sin(lean) / std::numbers::sqrt2;
  ClText cl = start_text(sample);
  cl.feed({Vec3(0, 0, 0), Vec3(out, -out, std::cos(lean))});
  cl.feed({Vec3(0, 0, 0), Vec3(out, out, std::cos(lean))});
  finish_sweep(sample, cl);
  return sample;
}

Sample make_between_head() {
  Sample sample = small_case(
      "between_head",
      "The tip rests while the axis swings over: the machine's head, given as STL, dips into a post that the tool and "
      "its holder pass",
      R"({"units":"mm","tools":[{"number":1,"name":"ball D6","cutter":{"shape":"ball","diameter":6,"length":20},
  "shank":[{"lower_diameter":6,"upper_diameter":6,"length":20}],
  "holder":[{"lower_diameter":30,"upper_diameter":30,"length":60}]}]}
)",
      1);
  // The lower face of the head is 100 above the tip. The top edges (+-1, 16.5..18.5, 101) of the post are deepest when
  // the axis points along (+-1, 0, 101). They pass the holder, of radius 15, at 16.5.
  const std::array<double, 4> x = {-30, -1, 1, 30}, y = {-30, 16.5, 18.5, 30};
  const std::array<double, 3> z = {-12, -1.5, 101};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); })});
  sample.heads.push_back({"head.stl", make_box({-30, -40, 100}, {30, 40, 160})});
  const double deepest = std::sqrt(101.0 * 101.0 + 1) - 100;
  const double tilt = std::numbers::pi / 6;
  ClText cl = start_text(sample);
  cl.feed({Vec3(0, 0, 0), Vec3(std::sin(tilt), 0, std::cos(tilt))});
  const std::size_t line = cl.feed({Vec3(0, 0, 0), Vec3(-std::sin(tilt), 0, std::cos(tilt))});
  sample.findings.push_back({line, "gouge", "head", "part", deepest - 1e-3, deepest + 1e-3});
  finish_sweep(sample, cl);
  return sample;
}

Sample make_thin_post() {
  Sample sample = small_case("thin_post", "A rapid 120 mm long crosses a post 0.04 mm thick", kFlatD6, 1);
  const std::array<double, 4> x = {-70, -0.02, 0.02, 70}, y = {-20, -5, 5, 20};
  const std::array<double, 3> z = {-10, 0, 10};
  sample.parts.push_back(
      {"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) { return k == 0 || (i == 1 && j == 1); })});
  ClText cl = start_text(sample);
  cl.feed({Vec3(-60, 0, 4), Vec3::UnitZ()});
  // On the axis the depth is equal to the tool's radius: the post reaches 6 mm above the tip.
  sample.findings.push_back({cl.rapid({Vec3(60, 0, 4), Vec3::UnitZ()}), "gouge", "cutter", "part", 2.999, 3.0001});
  finish_sweep(sample, cl);
  return sample;
}

Sample make_buried() {
  Sample sample =
      small_case("buried", "The whole tool is inside a closed block; the way out cuts through its face", kFlatD6, 1);
  sample.parts.push_back({"part.stl", make_box({-200, -200, -200}, {200, 200, 200})});
  sample.correct_exit = 1;
  ClText cl = start_text(sample);
  for (const double x : {0.0, 10.0}) {
    sample.findings.push_back({cl.feed({Vec3(x, 0, 0), Vec3::UnitZ()}), "buried", "cutter", "part", 0, 0});
  }
  // The face is at the middle of the holder here, so a point on the axis has the holder's radius as its depth.
  sample.findings.push_back({cl.rapid({Vec3(10, 0, 320), Vec3::UnitZ()}), "gouge", "holder", "part", 14.999, 15.0001});
  cl.rapid({Vec3(0, 0, 330), Vec3::UnitZ()});
  finish_sweep(sample, cl);
  return sample;
}

}  // namespace gouge::samples
