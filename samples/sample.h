#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "samples/solids.h"

// A sample: generated input together with the verdict it must get. The verdicts come from the formulas the
// shapes are made of, never from running the checker, so that they can prove it wrong.

namespace gouge::samples {

struct NamedSolid {
  std::string file;  ///< for example "part.stl"
  Solid solid;
};

/// Expected report of the move whose statement begins on `line`. Lengths in the toolpath's unit.
struct ExpectedFinding {
  std::size_t line = 0;
  std::string state = "gouge";  ///< gouge or buried
  std::string body = "cutter";
  std::string against = "part";
  double depth_min = 0, depth_max = 0;  ///< the true depth lies between; both 0 for buried
};

struct Sample {
  std::string name;   ///< also the name of its folder and toolpath
  std::string about;  ///< one sentence for people
  std::string toolpath_file;
  std::string toolpath;  ///< text
  std::string tools;     ///< library, JSON text
  std::string machine;   ///< machine.json; empty: none
  std::string unit = "mm";
  std::vector<NamedSolid> parts, fixtures;
  double overlap = 0;             ///< how deep fixture and part penetrate each other; 0: not at all
  std::vector<NamedSolid> heads;  ///< in the tool's frame; used by `check` only
  int check_exit = 0, correct_exit = 0;
  std::size_t moves = 0;
  std::vector<ExpectedFinding> findings;    ///< one per move that is not clean, by line; all others are clean
  std::vector<ExpectedFinding> by_machine;  ///< the same with --machine machine.json
};

}  // namespace gouge::samples
