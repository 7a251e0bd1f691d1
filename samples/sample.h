#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "samples/solids.h"

// A sample: generated input together with the verdict that a check must give. The verdicts follow from the formulas of
// the shapes, never from a run of the checker, so that they can prove it wrong.

namespace gouge::samples {

struct NamedSolid {
  std::string file;  ///< for example "part.stl"
  Solid solid;
};

/// Expected report of the move whose statement begins on `line`. Lengths are in the unit of the toolpath.
struct ExpectedFinding {
  std::size_t line = 0;
  std::string state = "gouge";  ///< gouge or buried
  std::string body = "cutter";
  std::string against = "part";
  double depth_min = 0, depth_max = 0;  ///< limits of the true depth; both are 0 for buried
};

struct Sample {
  std::string name;   ///< also the name of its folder and toolpath
  std::string about;  ///< one sentence that describes the sample
  std::string toolpath_file;
  std::string toolpath;  ///< text of the toolpath
  std::string tools;     ///< tool library, as JSON text
  std::string machine;   ///< machine file, as JSON text; empty: none
  std::string unit = "mm";
  std::vector<NamedSolid> parts, fixtures;
  double overlap = 0;             ///< penetration depth of fixture and part; 0: they do not penetrate
  std::vector<NamedSolid> heads;  ///< in the tool's frame; used by `check` only
  int check_exit = 0, correct_exit = 0;
  std::size_t moves = 0;
  /// one for each move that is not clean, ordered by line; all other moves are clean
  std::vector<ExpectedFinding> findings;
  std::vector<ExpectedFinding> by_machine;  ///< the same with --machine machine.json
};

}  // namespace gouge::samples
