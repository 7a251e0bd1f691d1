#pragma once

#include <vector>

#include "lib/path/toolpath.h"

// Builds toolpaths from positions, for tests of the libraries below the reader. Header only.

namespace gouge::paths {

inline Pose upright(double x, double y, double z) { return {Vec3(x, y, z), Vec3::UnitZ()}; }

/// Returns a path of one tool through the given positions; the first is a position without a motion.
inline Toolpath through(const std::vector<Pose>& poses, MoveKind kind = MoveKind::feed) {
  Toolpath path;
  path.file = "test.apt";
  path.tools.resize(1);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Move move;
    move.kind = kind;
    move.line = i + 1;
    move.has_start = i > 0;
    move.end = poses[i];
    move.tool = 0;
    path.moves.push_back(move);
  }
  return path;
}

}  // namespace gouge::paths
