#pragma once

#include <string>
#include <vector>

#include "tests/support/scatter.h"
#include "toolmodels/assembly.h"

// Named tools that between them have every kind of corner, step, arc and growth.

namespace gouge::test {

inline ToolAssembly assembly(const std::string& name, Cutter cutter, std::vector<ToolSegment> shank = {},
                             std::vector<ToolSegment> holder = {}) {
  return {1, name, cutter, std::move(shank), std::move(holder)};
}

inline std::vector<ToolAssembly> sample_tools() {
  const std::vector<ToolSegment> straight{{10, 10, 20}};
  const std::vector<ToolSegment> two_step{{32, 32, 40}, {40, 46, 30}};
  return {
      assembly("flat alone", FlatCutter{10, 30}),
      assembly("ball", BallCutter{10, 30}, straight, two_step),
      assembly("bull nose", BullNoseCutter{16, 2, 25}, {{16, 16, 15}}, {{40, 32, 20}, {32, 50, 25}}),
      assembly("tapered ball", TaperedCutter{4, 2, 5, 30}, {{9.5, 9.5, 25}}, {{32, 32, 50}}),
      assembly("tapered flat", TaperedCutter{6, 0, 10, 20}, {{14, 14, 30}}),
      assembly("tapered bull", TaperedCutter{12, 1.5, 3, 30}, {{10, 10, 15}}, {{28, 28, 40}}),
      assembly("dovetail", TaperedCutter{20, 0.5, -30, 8}, {{8, 8, 30}}, {{30, 30, 30}}),
      assembly("narrow neck", BullNoseCutter{12, 3, 10}, {{8, 8, 20}, {8, 12, 5}, {12, 12, 10}},
               {{25, 35, 10}, {35, 20, 30}}),
      assembly("drill", AptCutter{12, 0, 6, 3.605164, 31, 0, 63}, {{12, 12, 20}}, {{40, 40, 30}}),
      assembly("apt cone with corner", AptCutter{20, 2, 0, 0, 20, 15, 30}, {{20, 20, 20}}, {{50, 60, 30}}),
      assembly("slot cutter", FlatCutter{30, 4}, {{10, 10, 40}}, {{40, 40, 20}, {63, 63, 5}, {50, 50, 30}}),
      assembly("needle", BallCutter{0.2, 1}, {{3, 3, 30}}, {{60, 60, 120}}),
  };
}

}  // namespace gouge::test
