#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "samples/cases.h"
#include "samples/cl_text.h"

// A wavy surface z = f(x, y) with a wall behind it. A ball D10 finishes it, with lead and tilt that vary along the
// path. The centre of the ball lies at radius + kAllowance from the true surface along its normal. So chords of the
// mesh and of the path (each below 5 um) stay within the tolerance. Where `dip` is not 0, the tool is pushed in along
// the normal. The smallest radius of curvature is 20 mm, so the depth of the cut is `dip`.

namespace gouge::samples {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kRadius = 5, kAllowance = 0.005;
constexpr double kWallX = 106, kWallTop = 57.5, kHolderStart = 50;
constexpr int kPasses = 25;

/// The density of the part's triangles and of the path's positions; the shapes do not depend on it.
struct Density {
  int columns = 142, rows = 134, per_pass = 97;
};

double height(double x, double y) {
  return 6 + 4 * std::sin(kTurn * x / 98) * std::sin(kTurn * y / 80 + 0.4) + 0.5 * std::cos(kTurn * y / 50);
}

Vec3 freeform_normal(double x, double y) {
  const double wave = kTurn * y / 80 + 0.4;
  const double dx = 4 * kTurn / 98 * std::cos(kTurn * x / 98) * std::sin(wave);
  const double dy =
      4 * kTurn / 80 * std::sin(kTurn * x / 98) * std::cos(wave) - 0.5 * kTurn / 50 * std::sin(kTurn * y / 50);
  return Vec3(-dx, -dy, 1).normalized();
}

/// Returns the tool axis. In the passes near the wall it leans away from the wall, except in the last pass, in which it
/// is upright. There the lower face of the holder reaches below the top of the wall.
Vec3 tool_axis(int pass, double x, double y) {
  if (pass == kPasses - 1) return Vec3::UnitZ();
  const double s = std::clamp((x - 50) / 34, 0.0, 1.0);
  const double blend = s * s * (3 - 2 * s);
  const double tilt_deg = 12 * std::sin(kTurn * x / 60) * (1 - blend) - 20 * blend;
  const double lead_deg = 10 * std::sin(kTurn * y / 50 + 0.7 * pass);
  return Vec3(std::tan(tilt_deg * kTurn / 360), std::tan(lead_deg * kTurn / 360), 1).normalized();
}

/// Returns the depth of the tool below the surface in mm: a slow dive, one bad point, a stretch of constant depth. j
/// counts 96ths of the pass.
double dip(int pass, double j) {
  if (pass == 6 && j >= 30 && j <= 42) return std::min(0.3, 0.05 * std::min(j - 29, 43 - j));
  if (pass == 12 && std::abs(j - 50) < 0.01) return 0.5;
  if (pass == 17 && j >= 60 && j <= 70) return 0.12;
  return 0;
}

Solid make_freeform_part(const Density& density) {
  std::vector<double> columns, rows;
  for (int i = 0; i <= density.columns; ++i) columns.push_back(kWallX * i / density.columns);
  for (int j = 0; j <= density.rows; ++j) rows.push_back(100.0 * j / density.rows);
  std::vector<std::vector<Vec3>> grid;
  for (const double x : columns) {
    grid.emplace_back();
    for (const double y : rows) grid.back().emplace_back(x, y, height(x, y));
  }
  for (const double x : {kWallX + 1, kWallX + 20}) {
    grid.emplace_back();
    for (const double y : rows) grid.back().emplace_back(x, y, kWallTop);
  }
  Solid solid;
  const std::size_t last_i = grid.size() - 1, last_j = rows.size() - 1;
  for (std::size_t i = 0; i < last_i; ++i) {
    for (std::size_t j = 0; j < last_j; ++j) {
      add_quad(solid, grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]);
    }
  }
  Ring rim;
  for (std::size_t i = 0; i < last_i; ++i) rim.push_back(grid[i][0]);
  for (std::size_t j = 0; j < last_j; ++j) rim.push_back(grid[last_i][j]);
  for (std::size_t i = last_i; i > 0; --i) rim.push_back(grid[i][last_j]);
  for (std::size_t j = last_j; j > 0; --j) rim.push_back(grid[0][j]);
  Ring base = rim;
  for (Vec3& p : base) p.z() = -20;
  add_strip(solid, rim, base);
  add_cap(solid, Vec3(60, 50, -20), base, true);
  return solid;
}

struct FreeformPosition {
  Pose pose;
  double cutter_depth = 0;  ///< depth of the resting cutter; below 0: clear
  double holder_depth = 0;  ///< depth of the resting holder in the top of the wall, where the axis is upright
};

FreeformPosition freeform_position(int pass, int index, const Density& density) {
  const int steps = density.per_pass - 1;
  const double j = 96.0 * index / steps;
  const double x = 2 + 4 * pass, y = 2 + 96.0 * (pass % 2 == 0 ? index : steps - index) / steps;
  const Vec3 axis = tool_axis(pass, x, y);
  const double offset = kRadius + kAllowance - dip(pass, j);
  FreeformPosition p;
  p.pose.axis = axis;
  p.pose.tip = Vec3(x, y, height(x, y)) + offset * freeform_normal(x, y) - kRadius * axis;
  p.cutter_depth = dip(pass, j) - kAllowance;
  if (pass == kPasses - 1) p.holder_depth = kWallTop - (p.pose.tip.z() + kHolderStart);
  return p;
}

/// Adds the finding for the move between two positions. The depth is largest at one of its ends.
void add_finding(Sample& sample, std::size_t line, const FreeformPosition& a, const FreeformPosition& b) {
  const double holder = std::max(a.holder_depth, b.holder_depth);
  const double cutter = std::max(a.cutter_depth, b.cutter_depth);
  if (holder > 0) {
    sample.findings.push_back({line, "gouge", "holder", "part", holder - 1e-3, holder + 1e-3});
  } else if (cutter > 0) {
    sample.findings.push_back({line, "gouge", "cutter", "part", cutter - 0.01, cutter + 0.01});
  }
}

FreeformPosition raised_freeform(const FreeformPosition& p, double by) {
  FreeformPosition up;
  up.pose = {p.pose.tip + by * p.pose.axis, p.pose.axis};
  return up;
}

Sample make_with(const Density& density, const std::string& name) {
  Sample sample;
  sample.name = name;
  sample.about =
      "A wavy surface finished with a ball D10 in 5-axis: two dives, one bad point, and a last pass whose holder rubs "
      "the wall";
  sample.toolpath_file = "freeform.apt";
  sample.tools =
      R"({"units":"mm","tools":[{"number":1,"name":"ball D10","cutter":{"shape":"ball","diameter":10,"length":30},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":20}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40},{"lower_diameter":40,"upper_diameter":46,"length":30}]}]}
)";
  sample.parts.push_back({"part.stl", make_freeform_part(density)});
  sample.check_exit = 1;
  ClText cl(ClText::Form::apt);
  cl.line("PARTNO/FREEFORM SAMPLE");
  cl.line("UNITS/MM");
  cl.line("MULTAX/ON");
  cl.line("CUTTER/10.000000, 5.000000, 0.000000, 5.000000, 0.000000, 0.000000, 30.000000");
  cl.line("LOADTL/1");
  cl.line("SPINDL/12000.000, RPM, CLW");
  cl.rapid({Vec3(50, 50, 150), Vec3::UnitZ()});
  for (int pass = 0; pass < kPasses; ++pass) {
    cl.line("PPRINT/PASS " + std::to_string(pass + 1) + ", X " + fixed_text(2 + 4 * pass, 1));
    FreeformPosition before = raised_freeform(freeform_position(pass, 0, density), 30);
    cl.rapid(before.pose);
    cl.line("FEDRAT/1200.0000, MMPM");
    for (int j = 0; j < density.per_pass; ++j) {
      const FreeformPosition here = freeform_position(pass, j, density);
      add_finding(sample, cl.feed(here.pose), before, here);
      before = here;
    }
    const FreeformPosition retracted = raised_freeform(before, 30);
    add_finding(sample, cl.rapid(retracted.pose), before, retracted);
  }
  cl.rapid({Vec3(50, 50, 150), Vec3::UnitZ()});
  cl.line("SPINDL/OFF");
  cl.line("FINI");
  sample.toolpath = cl.text();
  sample.moves = cl.positions();
  return sample;
}

}  // namespace

void put_long_path(std::size_t moves, const PutText& put) {
  constexpr int kSteps = 399;
  constexpr std::size_t kColumns = 23;  // number of columns, none of which is under the wall
  put("PARTNO/LONG SAMPLE\nUNITS/MM\nMULTAX/ON\nLOADTL/1\nSPINDL/12000.000, RPM, CLW\n");
  for (std::size_t done = 0, pass = 0; done < moves; ++pass) {
    const std::size_t column = pass % kColumns, round = pass / kColumns;
    const double x =
        2 + 4 * (static_cast<double>(column) + 0.97 * std::fmod(0.618033988749895 * static_cast<double>(round), 1.0));
    const auto pose = [&](int step) -> Pose {
      const double y = 2 + 96.0 * (pass % 2 == 0 ? step : kSteps - step) / kSteps;
      const Vec3 axis = tool_axis(static_cast<int>(column), x, y);
      const double pushed = column == 6 && round % 100 == 0 ? dip(6, 96.0 * step / kSteps) : 0;
      return {Vec3(x, y, height(x, y)) + (kRadius + kAllowance - pushed) * freeform_normal(x, y) - kRadius * axis,
              axis};
    };
    const auto above = [&](int step) -> Pose { return {pose(step).tip + 30 * pose(step).axis, pose(step).axis}; };
    ClText cl(ClText::Form::apt);
    cl.rapid(above(0));
    cl.line("FEDRAT/1200.0000, MMPM");
    for (int step = 0; step <= kSteps; ++step) {
      if (done + cl.positions() < moves) cl.feed(pose(step));
    }
    if (done + cl.positions() < moves) cl.rapid(above(kSteps));
    done += cl.positions();
    put(cl.text());
  }
  put("SPINDL/OFF\nFINI\n");
}

Sample make_freeform() { return make_with({}, "freeform"); }

Sample make_freeform_large() { return make_with({224, 210, 400}, "freeform_large"); }

}  // namespace gouge::samples
