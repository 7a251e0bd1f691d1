#include "tests/bench/bench_tool.h"

#include <cmath>
#include <numbers>

#include "toolmodels/compile_tool.h"

namespace gouge::bench {
namespace {

constexpr double kFlutes_mm = 30;

BenchTool make(const std::string& name, const Cutter& cutter, double shank_mm, const ConvexPiece& lower,
               const HolderSize& holder) {
  BenchTool tool;
  tool.name = name;
  tool.assembly.number = 1;
  tool.assembly.name = name;
  tool.assembly.cutter = cutter;
  if (shank_mm > 0) tool.assembly.shank = {{shank_mm, shank_mm, holder.z0_mm - kFlutes_mm}};
  tool.assembly.holder = {{holder.diameter_mm, holder.diameter_mm, holder.z1_mm - holder.z0_mm}};
  tool.variants = make_tool_variants(tool.assembly, 0, 0, 0).value();
  tool.lower = lower;
  const double r = holder.diameter_mm / 2;
  tool.holder.contour = {{0, holder.z0_mm}, {r, holder.z0_mm}, {r, holder.z1_mm}, {0, holder.z1_mm}};
  return tool;
}

}  // namespace

BenchTool make_ball(double diameter_mm, const HolderSize& holder) {
  const double r = diameter_mm / 2;
  const ConvexPiece lower = {{{0, r}, {0, holder.z0_mm}}, r};
  return make("ball", BallCutter{diameter_mm, kFlutes_mm}, diameter_mm, lower, holder);
}

BenchTool make_bull(double diameter_mm, double corner_mm, const HolderSize& holder) {
  const double r = diameter_mm / 2 - corner_mm, top = holder.z0_mm;
  const ConvexPiece lower = {{{0, corner_mm}, {r, corner_mm}, {r, top}, {0, top}}, corner_mm};
  return make("bull", BullNoseCutter{diameter_mm, corner_mm, kFlutes_mm}, diameter_mm, lower, holder);
}

BenchTool make_taper(double diameter_mm, double angle_deg, const HolderSize& holder) {
  // The cutter's cone runs up to the holder. The core is drawn 1 mm higher, so that its rounded rim begins
  // inside the holder.
  const double r = diameter_mm / 2, top = holder.z0_mm + 1;
  const double wide = (top - r) * std::tan(angle_deg * std::numbers::pi / 180);
  const ConvexPiece lower = {{{0, r}, {wide, top}, {0, top}}, r};
  return make("taper", TaperedCutter{diameter_mm, r, angle_deg, holder.z0_mm}, 0, lower, holder);
}

}  // namespace gouge::bench
