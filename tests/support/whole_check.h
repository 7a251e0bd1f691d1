#pragma once

#include <utility>
#include <vector>

#include "lib/certify/motion_checker.h"

// Runs the whole check for tests of one tool. Header only.

namespace gouge {

/// A setup together with the data to which it refers, except the scene and the tool, which must outlive it.
struct OwnSetup {
  std::vector<HeadBody> heads;
  CheckOptions options;
  PreparedScene scene;
  CheckSetup setup;

  explicit OwnSetup(const ToolVariants* tool, const Scene& of, const CheckOptions& with = {},
                    std::vector<HeadBody> bodies = {})
      : heads(std::move(bodies)),
        options(with),
        scene(prepare_scene(of, with.threads)),
        setup{{tool}, heads, scene, options} {}
  [[nodiscard]] MotionChecker checker() const { return MotionChecker(setup); }

  OwnSetup(const OwnSetup&) = delete;
  OwnSetup& operator=(const OwnSetup&) = delete;
};

inline CheckResult whole_check(const Toolpath& path, const ToolVariants* tool, const Scene& scene,
                               const CheckOptions& options = {}, const std::vector<HeadBody>& heads = {}) {
  return check(path, OwnSetup(tool, scene, options, heads).setup);
}

}  // namespace gouge
