#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "postproc/cldata/language/dialect.h"
#include "postproc/formats/write_toolpath.h"

namespace gouge {

/// Expected reading of one written position.
struct ExpectedMotion {
  Pose end;
  std::size_t move = 0;  ///< move of the original path
  bool is_alone = false;
  bool is_checked = true;
  Feed feed;
  double sweep_rad = 0;  ///< right-handed about `axis`; 0: straight
  Vec3 axis = Vec3::UnitZ();
};

/// Reads the written file like any other file, and compares it with the expected motions. Differences are noted in
/// `written`, except `lost_breaks` positions, which are noted already.
///
/// Errors   A motion has another tool, is rapid, or has another feed. Then nothing may be written.
[[nodiscard]] std::optional<Diagnostic> verify_written(const Toolpath& path, const Dialect& target,
                                                       const std::vector<ExpectedMotion>& expected,
                                                       std::size_t lost_breaks, WrittenToolpath& written);

}  // namespace gouge
