#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lib/base/number_text.h"
#include "samples/cases.h"
#include "samples/cl_text.h"

// One motion with arcs of both senses, written in dialects that state an arc in different ways. In NX it runs clockwise
// about its vector, in Creo counter-clockwise. CATIA has a tangent, and the end point inside the statement.

namespace gouge::samples {
namespace {

constexpr double kCut = 5;       // z of the arcs
constexpr double kWide = 14;     // radius of the arc that would meet the second post if it ran the other way round
constexpr double kClose = 6.2;   // radius of the arc that comes too near to the first post
constexpr double kEnd_deg = 10;  // both arcs run between this angle and 180 degrees minus this angle
constexpr const char* kArcFlatD10 =
    R"({"units":"mm","tools":[{"number":1,"name":"flat D10","cutter":{"shape":"flat","diameter":10,"length":25},
  "shank":[{"lower_diameter":10,"upper_diameter":10,"length":25}],
  "holder":[{"lower_diameter":32,"upper_diameter":32,"length":40}]}]}
)";

Vec3 at(double radius, double angle_deg, double z = kCut) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return Vec3(radius * std::cos(angle), radius * std::sin(angle), z);
}

std::string numbers(std::initializer_list<double> values, const char* separator) {
  std::string text;
  for (const double value : values) {
    if (!text.empty()) text += separator;
    text += fixed_text(value, 5);
  }
  return text;
}

std::size_t next_line(const ClText& cl) {
  return static_cast<std::size_t>(std::count(cl.text().begin(), cl.text().end(), '\n')) + 1;
}

/// Writes an arc about the z axis from its radius and two angles. Returns the line on which its statement begins.
using WriteArc = std::size_t (*)(ClText& cl, double radius, double from_deg, double to_deg);

std::size_t write_nx_arc(ClText& cl, double radius, double from_deg, double to_deg) {
  const double clockwise = to_deg > from_deg ? -1 : 1;
  cl.line("CIRCLE/" + numbers({0, 0, kCut, 0, 0, clockwise, radius, 0.01, 0.5, 10, 0}, ","));
  return cl.feed({at(radius, to_deg), Vec3::UnitZ()});
}

std::size_t write_creo_arc(ClText& cl, double radius, double from_deg, double to_deg) {
  cl.line("CIRCLE / " + numbers({0, 0, kCut}, ", ") + ",  $");
  cl.line(numbers({0, 0, to_deg > from_deg ? 1.0 : -1.0}, ", ") + ",  " + fixed_text(radius, 10));
  return cl.feed({at(radius, to_deg), Vec3::UnitZ()});
}

std::size_t write_catia_arc(ClText& cl, double radius, double from_deg, double to_deg) {
  const Vec3 tangent = at(1, from_deg + (to_deg > from_deg ? 90 : -90)), end = at(radius, to_deg);
  cl.line("AUTOPS");
  cl.line("INDIRV/ " + numbers({tangent.x(), tangent.y(), 0}, ", "));
  const std::size_t line = next_line(cl);
  cl.line("TLON,GOFWD/ (CIRCLE/ " + numbers({0, 0, kCut}, ", ") + ",$");
  cl.line("    " + fixed_text(radius, 5) + "),ON,(LINE/ " + numbers({0, 0, kCut}, ", ") + ",$");
  cl.line("    " + numbers({end.x(), end.y(), end.z()}, ", ") + ")");
  return line;
}

struct Dialect {
  const char* name;
  const char* file;
  ClText::Form form;
  std::vector<std::string> head, foot;
  WriteArc write_arc;
  std::size_t arcs_without_goto;
};

// The cutter's corner edge passes the corner (1, 1) of the post at kClose - sqrt(2) from the tool axis, inside the
// cutter's radius.
Sample make_arcs(const Dialect& dialect) {
  Sample sample;
  sample.name = dialect.name;
  sample.about =
      "Two arcs of either sense about a post: the near one cuts its edges, the far one is clear only in its own sense";
  sample.toolpath_file = dialect.file;
  sample.tools = kArcFlatD10;
  sample.check_exit = 1;
  const std::array<double, 4> x = {-30, -1, 1, 30}, z = {-10, 0, 10, 11};
  const std::array<double, 6> y = {-30, -15, -13, -1, 1, 30};
  sample.parts.push_back({"part.stl", make_grid_solid(x, y, z, [](int i, int j, int k) {
                            return k == 0 || (k == 1 && i == 1 && (j == 1 || j == 3));
                          })});
  const double depth = 5 - (kClose - std::sqrt(2.0));
  ClText cl(dialect.form);
  for (const std::string& line : dialect.head) cl.line(line);
  cl.rapid({at(kWide, kEnd_deg, 20), Vec3::UnitZ()});
  cl.feed({at(kWide, kEnd_deg), Vec3::UnitZ()});
  dialect.write_arc(cl, kWide, kEnd_deg, 180 - kEnd_deg);
  cl.feed({at(kClose, 180 - kEnd_deg), Vec3::UnitZ()});
  const std::size_t line = dialect.write_arc(cl, kClose, 180 - kEnd_deg, kEnd_deg);
  cl.feed({at(kClose, kEnd_deg, 20), Vec3::UnitZ()});
  for (const std::string& text : dialect.foot) cl.line(text);
  sample.findings.push_back({line, "gouge", "cutter", "part", depth - 1e-3, depth + 1e-3});
  sample.toolpath = cl.text();
  sample.moves = cl.positions() + dialect.arcs_without_goto;
  return sample;
}

}  // namespace

Sample make_arcs_nx() {
  return make_arcs({"arcs_nx",
                    "arcs_nx.cls",
                    ClText::Form::nx,
                    {"TOOL PATH/ARCS,TOOL,FLAT_D10", "TLDATA/MILL,10.0000,0.0000,25.0000,0.0000,0.0000",
                     "MSYS/0.0000,0.0000,0.0000,1.0000000,0.0000000,0.0000000,0.0000000,1.0000000,0.0000000",
                     "LOAD/TOOL,1", "FEDRAT/MMPM,1000.0000"},
                    {"END-OF-PATH"},
                    write_nx_arc,
                    0});
}

Sample make_arcs_creo() {
  return make_arcs({"arcs_creo",
                    "arcs_creo.ncl.1",
                    ClText::Form::apt_xyz,
                    {"$$*          Pro/CLfile  Version 8.0 - 8.0.3.0", "PARTNO / ARCS", "UNITS / MM", "LOADTL / 1",
                     "$$-> CUTTER / 10.000000", "FEDRAT / 1000.000000,  MMPM"},
                    {"FINI"},
                    write_creo_arc,
                    0});
}

Sample make_arcs_catia() {
  return make_arcs({"arcs_catia",
                    "arcs_catia.aptsource",
                    ClText::Form::apt,
                    {"$$     CATIA APT VERSION 1.0", "PARTNO ARCS", "UNITS/MM", "MULTAX",
                     "CUTTER/ 10.000000,  0.000000,  5.000000,  0.000000,  0.000000,$", "         0.000000, 25.000000",
                     "LOADTL/1", "FEDRAT/ 1000.0000,MMPM"},
                    {"END"},
                    write_catia_arc,
                    2});
}

}  // namespace gouge::samples
