#include <array>
#include <cmath>
#include <numbers>

#include "samples/cases.h"
#include "samples/cl_text.h"

// Small samples in which tool and part touch, and one sample in inches.

namespace gouge::samples {
namespace {

void finish_contact(Sample& sample, ClText& cl) {
  cl.line("FINI");
  sample.toolpath = cl.text();
  sample.moves = cl.positions();
}

}  // namespace

Sample make_inch() {
  Sample sample;
  sample.name = "inch";
  sample.about = "An inch toolpath on an inch part: a facing cut dives 0.02 in below the floor";
  sample.toolpath_file = "inch.apt";
  sample.unit = "inch";
  sample.check_exit = 1;
  sample.tools =
      R"({"units":"inch","tools":[{"number":2,"name":"bull nose D0.5 r0.0625","cutter":{"shape":"bull_nose","diameter":0.5,"corner_radius":0.0625,"length":1.5},
  "shank":[{"lower_diameter":0.5,"upper_diameter":0.5,"length":0.75}],
  "holder":[{"lower_diameter":1.25,"upper_diameter":1.75,"length":1.5}]}]}
)";
  const std::array<double, 3> x = {0, 1.5, 3}, z = {-1, 0, 0.25};
  const std::array<double, 2> y = {0, 2};
  sample.parts.push_back({"part.stl", make_grid_solid(x, y, z, [](int i, int, int k) { return k == 0 || i == 1; })});
  ClText cl(ClText::Form::apt_xyz);
  cl.line("PARTNO/INCH SAMPLE");
  cl.line("UNITS/INCHES");
  cl.line("CUTTER/0.500000, 0.062500");
  cl.line("LOADTL/2");
  const auto pose = [](double px, double py, double pz) { return Pose{Vec3(px, py, pz), Vec3::UnitZ()}; };
  cl.rapid(pose(-0.5, 0.25, 1));
  for (int row = 0; row < 4; ++row) {
    const double py = 0.25 + 0.5 * row;
    cl.rapid(pose(-0.5, py, 0.5));
    cl.line("FEDRAT/40.0000, IPM");
    cl.feed(pose(-0.5, py, 0));
    if (row == 2) {
      cl.feed(pose(0, py, 0));
      for (const std::size_t line :
           {cl.feed(pose(0.3, py, -0.02)), cl.feed(pose(0.6, py, -0.02)), cl.feed(pose(0.9, py, 0))}) {
        sample.findings.push_back({line, "gouge", "cutter", "part", 0.0199, 0.0201});
      }
    }
    cl.feed(pose(1.2, py, 0));
    cl.rapid(pose(1.2, py, 0.5));
  }
  finish_contact(sample, cl);
  return sample;
}

Sample make_needles() {
  Sample sample;
  sample.name = "needles";
  sample.about = "A flat end mill lies exactly on a round plate whose top is a fan of 718 needle triangles: clean";
  sample.toolpath_file = "needles.apt";
  sample.tools =
      R"({"units":"mm","tools":[{"number":1,"name":"flat D20","cutter":{"shape":"flat","diameter":20,"length":40},
  "holder":[{"lower_diameter":40,"upper_diameter":40,"length":40}]}]}
)";
  Ring top, base;
  for (int i = 0; i < 720; ++i) {
    const double angle = std::numbers::pi * i / 360;
    top.emplace_back(100 * std::cos(angle), 100 * std::sin(angle), 0);
    base.emplace_back(top.back().x(), top.back().y(), -20);
  }
  Solid solid;
  for (std::size_t i = 1; i + 1 < top.size(); ++i) solid.push_back({top[0], top[i], top[i + 1]});
  add_strip(solid, top, base);
  add_cap(solid, Vec3(0, 0, -20), base, true);
  sample.parts.push_back({"part.stl", std::move(solid)});
  ClText cl(ClText::Form::apt_xyz);
  cl.line("PARTNO/NEEDLES");
  cl.line("UNITS/MM");
  cl.line("LOADTL/1");
  cl.rapid({Vec3(-120, -95, 40), Vec3::UnitZ()});
  cl.line("FEDRAT/2000.0000, MMPM");
  for (int row = 0; row <= 38; ++row) {
    const double y = -95 + 5 * row, side = row % 2 == 0 ? -1 : 1;
    for (int i = 0; i <= 6; ++i) cl.feed({Vec3(side * (120 - 40 * i), y, 0), Vec3::UnitZ()});
  }
  finish_contact(sample, cl);
  return sample;
}

Sample make_big_triangles() {
  Sample sample;
  sample.name = "big_triangles";
  sample.about = "A ball on an inclined plane made of two triangles 2 m wide, cutting 0.1 mm where no vertex is near";
  sample.toolpath_file = "big_triangles.apt";
  sample.check_exit = 1;
  sample.tools =
      R"({"units":"mm","tools":[{"number":1,"name":"ball D10","cutter":{"shape":"ball","diameter":10,"length":30},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";
  const Ring top = {{-1000, -1000, -100}, {1000, -1000, 100}, {1000, 1000, 100}, {-1000, 1000, -100}};
  Ring base = top;
  for (Vec3& p : base) p.z() = -300;
  Solid solid;
  add_quad(solid, top[0], top[1], top[2], top[3]);
  add_strip(solid, top, base);
  add_quad(solid, base[3], base[2], base[1], base[0]);
  sample.parts.push_back({"part.stl", std::move(solid)});
  const Vec3 normal = Vec3(-0.1, 0, 1).normalized();
  const Vec3 axis = Vec3(0.2, 0.1, 1).normalized();
  const auto pose = [&](double x, double y, double push) {
    return Pose{Vec3(x, y, 0.1 * x) + (5.003 - push) * normal - 5 * axis, axis};
  };
  ClText cl(ClText::Form::apt);
  cl.line("PARTNO/BIG TRIANGLES");
  cl.line("UNITS/MM");
  cl.line("LOADTL/1");
  cl.feed(pose(-60, 7, 0));
  cl.feed(pose(-20, 9, 0));
  for (const std::size_t line : {cl.feed(pose(0, 10, 0.103)), cl.feed(pose(20, 11, 0))}) {
    sample.findings.push_back({line, "gouge", "cutter", "part", 0.0998, 0.1002});
  }
  cl.feed(pose(60, 13, 0));
  finish_contact(sample, cl);
  return sample;
}

std::vector<Sample> make_all() {
  return {make_freeform(),      make_pocket(),        make_blade(),          make_between_rib(),
          make_between_swing(), make_pole_crossing(), make_rapid_joints(),   make_rapid_independent(),
          make_axis_limit(),    make_axis_flip(),     make_smoothing_tube(), make_between_head(),
          make_thin_post(),     make_buried(),        make_inch(),           make_needles(),
          make_big_triangles(), make_arcs_nx(),       make_arcs_creo(),      make_arcs_catia(),
          make_sunk_jaw(),      make_rapid_stock(),   make_holder_stock(),   make_excess_corner()};
}

}  // namespace gouge::samples
