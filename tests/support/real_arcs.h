#pragma once

#include <ostream>

// One arc from a real file of each dialect, with its original numbers. Header only.

namespace gouge::real_arcs {

struct ArcCase {
  const char* name;
  const char* text;  // the second move is the arc
  double sweep_deg;
  double axis_z;
};

inline void PrintTo(const ArcCase& c, std::ostream* out) { *out << c.name; }

// The arc after each of these lines continues smoothly only in the sense of its dialect.
inline const ArcCase kArcs[] = {
    {"Nx",
     "TOOL PATH/A,TOOL,B\nGOTO/1434.9836,124.9400,465.0\nGOTO/1409.0996,55.1317,465.0\n"
     "CIRCLE/1432.5401,46.4403,465.0,0.0,0.0,-1.0,25.0,0.06,0.5,125.0,1.0\nGOTO/1423.8487,22.9997,465.0\nEND-OF-PATH\n",
     -89.9998, -1},
    {"Creo",
     "$$* Pro/CLfile Version 8.0\nUNITS / INCHES\nGOTO / 1.3240000000, 2.0, 2.9026\nGOTO / 0.799, 0.8754, 2.9026\n"
     "CIRCLE / 0.8922, 0.8687, 2.9026,  $\n0.0, 0.0, 1.0,  0.0934405158\nGOTO / 0.8154, 0.8153, 2.9026\nFINI\n",
     38.9232, 1},
    {"SolidWorks",
     "TRNTYP/WORLD,0,0,0\nUNIT/MM\nGOTO/27.442212,-7.537687,-17.\nGOTO/32.589949,-2.389949,-17.\n"
     "CIRCLE/31.6,-1.4,-17.,0,0,1.\nGOTO/33.,-1.4,-17.\nFINI\n",
     45, 1},
    {"Autodesk",
     "UNITS/INCHES\nGOTO/0.799000, 2.000000, 2.902600\nGOTO/0.799000, 0.875400, 2.902600\n"
     "MOVARC/0.892200, 0.868700, 2.902600, 0.0, 0.0, 1.0, 0.093441, ANGLE, 38.923201\n"
     "GOTO/0.815400, 0.815300, 2.902600\nFINI\n",
     38.9232, 1},
    {"Camplete",
     "CSI_TOOL_PATH/A\nUNITS/INCHES\nGOTO/0.799000, 2.000000, 2.902600\nGOTO/0.799000, 0.875400, 2.902600\n"
     "CIRCLE/0.892200, 0.868700, 2.902600, 0.0, 0.0, -1.0, 0.093441, 38.923201, 0.0, 0.0, 0.0\n"
     "GOTO/0.815400, 0.815300, 2.902600\nFINI\n",
     -38.9232, -1},
    {"Clt",
     "UNITS/ MM \nOPFEATSTART/A\nGOTO/ 42.865690,74.775708,-19.5\nGOTO/ 37.487168,69.869600,-19.5 \n"
     "CIRCLE/ 38.430651,68.835269,-19.5,0,0,1,1.4,COUNTERCLOCKWISE \nGOTO/ 37.032126,68.899508,-19.500000 \nFINI\n",
     44.988, 1},
    {"Catia",
     "$$ CATIA APT VERSION 1.0\nMULTAX\nGOTO/ 20.29460, 50.8,73.72604,0,0,1\nGOTO/ 20.29460,22.23516,73.72604,0,0,1\n"
     "AUTOPS\nINDIRV/   -0.07170,   -0.99743,    0.00000\n"
     "TLON,GOFWD/      (CIRCLE/     22.66188,     22.06498,     73.72604,$\n"
     "     2.37339),ON,(LINE/     22.66188,     22.06498,     73.72604,$\n"
     "                              20.71116,     20.70862,     73.72604)\nFINI\n",
     38.9232, 1},
};

}  // namespace gouge::real_arcs
