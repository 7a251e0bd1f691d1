#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "postproc/formats/write_corrected.h"

namespace gouge {

/// The end of `move` lifted by `dz`.
inline PathChange lift(const Toolpath& path, std::size_t move, double dz) {
  Pose end = path.moves.at(move).end;
  end.tip.z() += dz;
  return {move, end, {}};
}

/// The file with `changes` made, or nothing after a test failure that shows the error.
inline std::string written(const Toolpath& path, const std::vector<PathChange>& changes) {
  const Result<std::string> text = write_corrected(path, changes);
  if (!text) ADD_FAILURE() << to_text(text.error());
  return text ? *text : std::string();
}

}  // namespace gouge
