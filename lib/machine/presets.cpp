#include "lib/machine/read_machine.h"

namespace gouge {

// Each value has its source in the text. A fact of a machine or a control without a source stays empty.
const std::vector<MachinePreset>& machine_presets() {
  static const std::vector<MachinePreset> presets = {
      {"linuxcnc-xyzac-trt", "LinuxCNC, A trunnion with a C table", R"json({
  "name": "linuxcnc-xyzac-trt",
  "source": "LinuxCNC configs/sim/axis/vismach/5axis/table-rotary-tilting/xyzac-trt.ini: limits, rates, and conventional-directions 0, so rotations are opposite to ISO 841 (src/emc/kinematics/trtfuncs.c)",
  "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, -1], "min": -36000, "max": 36000, "rate": 1800},
    {"name": "A", "type": "rotary", "side": "table", "direction": [-1, 0, 0], "min": -100, "max": 50, "rate": 1800},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0], "min": -200, "max": 200, "rate": 1200},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0], "min": -100, "max": 100, "rate": 1200},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1], "min": -120, "max": 120, "rate": 1200}
  ],
  "control": {"name": "LinuxCNC", "program": "linuxcnc", "feed_law": "axis", "rapid_law": "axis", "joint_rapid_law": "joint",
    "source": "LinuxCNC src/emc/tp/tc.c TC_LINEAR: xyz, abc and uvw each linear in one progress; G0 is coordinated (kinematics switched on)"}
})json"},
      {"linuxcnc-xyzbc-trt", "LinuxCNC, B trunnion with a C table", R"json({
  "name": "linuxcnc-xyzbc-trt",
  "source": "LinuxCNC configs/sim/axis/vismach/5axis/table-rotary-tilting/xyzbc-trt.ini: limits of the axes, rates, and conventional-directions 0, so rotations are opposite to ISO 841 (src/emc/kinematics/trtfuncs.c)",
  "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, -1], "min": -36000, "max": 36000, "rate": 1800},
    {"name": "B", "type": "rotary", "side": "table", "direction": [0, -1, 0], "min": -36000, "max": 36000, "rate": 1800},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0], "min": -200, "max": 200, "rate": 1200},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0], "min": -100, "max": 100, "rate": 1200},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1], "min": -120, "max": 120, "rate": 1200}
  ],
  "control": {"name": "LinuxCNC", "program": "linuxcnc", "feed_law": "axis", "rapid_law": "axis", "joint_rapid_law": "joint",
    "source": "LinuxCNC src/emc/tp/tc.c TC_LINEAR: xyz, abc and uvw each linear in one progress; G0 is coordinated (kinematics switched on)"}
})json"},
      {"haas-umc750", "Haas UMC-750, B trunnion with a C table", R"json({
  "name": "haas-umc750",
  "source": "arrangement and signs from a program of the NX post HAAS_UMC750_5AXIS_MILL_IN and its CL data: axis = (sin B cos C, sin B sin C, cos B); no source for limits and rates, so none are set",
  "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "B", "type": "rotary", "side": "table", "direction": [0, 1, 0]},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]}
  ],
  "control": {"name": "Haas NGC", "program": "haas", "feed_law": null, "rapid_law": null, "source": "the Haas manual promises no motion of the rotary axes under G234: give --feed-law and --rapid-law"}
})json"},
      {"table-b-head", "C table and B head, square", R"json({
  "name": "table-b-head",
  "source": "an arrangement, no machine: no limits and no rates",
  "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
    {"name": "B", "type": "rotary", "side": "head", "direction": [0, 1, 0]}
  ],
  "control": {"name": "not given", "feed_law": null, "rapid_law": null, "source": "give --feed-law and --rapid-law"}
})json"},
      {"head-ca", "C and A in the head, square", R"json({
  "name": "head-ca",
  "source": "an arrangement, no machine: no limits and no rates",
  "joints": [
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
    {"name": "C", "type": "rotary", "side": "head", "direction": [0, 0, 1], "continuous": true},
    {"name": "A", "type": "rotary", "side": "head", "direction": [1, 0, 0]}
  ],
  "control": {"name": "not given", "feed_law": null, "rapid_law": null, "source": "give --feed-law and --rapid-law"}
})json"},
      {"nutating-45", "C table and a B head nutating at 45 degrees", R"json({
  "name": "nutating-45",
  "source": "an arrangement, no machine: no limits and no rates",
  "joints": [
    {"name": "C", "type": "rotary", "side": "table", "direction": [0, 0, 1], "continuous": true},
    {"name": "X", "type": "linear", "side": "head", "direction": [1, 0, 0]},
    {"name": "Y", "type": "linear", "side": "head", "direction": [0, 1, 0]},
    {"name": "Z", "type": "linear", "side": "head", "direction": [0, 0, 1]},
    {"name": "B", "type": "rotary", "side": "head", "direction": [0, 1, 1], "continuous": true}
  ],
  "control": {"name": "not given", "feed_law": null, "rapid_law": null, "source": "give --feed-law and --rapid-law"}
})json"}};
  return presets;
}

}  // namespace gouge
