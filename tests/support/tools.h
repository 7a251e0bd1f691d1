#pragma once

#include <string>
#include <vector>

#include "toolmodels/assembly.h"
#include "toolmodels/compile_tool.h"

// Named tools for tests, compiled, each with a shank and a holder of two segments.

namespace gouge::tools {

inline ToolAssembly assembly(const Cutter& cutter, double shank_diameter = 10) {
  ToolAssembly tool;
  tool.number = 1;
  tool.name = "test";
  tool.cutter = cutter;
  tool.shank = {{shank_diameter, shank_diameter, 20}};
  tool.holder = {{32, 32, 40}, {40, 46, 30}};
  return tool;
}

inline ToolVariants variants(const ToolAssembly& tool, double stock = 0, double shank = 0, double holder = 0) {
  return make_tool_variants(tool, stock, shank, holder).value();
}

inline ToolVariants flat(double diameter = 10) { return variants(assembly(FlatCutter{diameter, 30}, diameter)); }
inline ToolVariants ball(double diameter = 10) { return variants(assembly(BallCutter{diameter, 30}, diameter)); }
inline ToolVariants bull(double diameter = 16, double corner = 2) {
  return variants(assembly(BullNoseCutter{diameter, corner, 30}, diameter));
}
inline ToolVariants tapered() { return variants(assembly(TaperedCutter{4, 2, 5, 30}, 8)); }
/// Returns a tool that is narrower above the cutter, so that its contour has a shoulder facing up and reflex corners.
inline ToolVariants necked() { return variants(assembly(FlatCutter{12, 10}, 6)); }

/// Returns the shapes beyond end mills: undercut, hollow below, concave, pointed, round everywhere.
inline std::vector<ToolVariants> shapes() {
  std::vector<ToolVariants> made;
  for (const Cutter& cutter : std::vector<Cutter>{
           DrillCutter{10, 118, 30}, ChamferCutter{12, 0, 45, 10}, LollipopCutter{12, 6, 0}, TSlotCutter{25, 1, 1, 8},
           SlittingSawCutter{40, 3, 16, 4}, DovetailCutter{20, 0.5, 30, 8}, BarrelCutter{12, 40, 1, 5, 12, 24},
           OvalCutter{10, 2, 60, 24}, LensCutter{16, 40, 1, 12}, FaceMillCutter{40, 1, 45, 50, 24, 5, 25},
           RadiusCutter{6, 1, 4, 16, 12}, AptCutter{24, 2, 0, 0, -15, 5, 15}})
    made.push_back(variants(assembly(cutter, 6)));
  return made;
}

inline std::vector<ToolVariants> all() { return {flat(), ball(), bull(), tapered(), necked()}; }

}  // namespace gouge::tools
