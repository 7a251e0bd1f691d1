#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "cli/job/scene_files.h"

namespace gouge {

struct InputFile;
struct ReportModel;
class CheckpointStore;

/// Environment of one run of `check` or `correct`: its streams, the source of its meshes, and who receives
/// the result beside its outputs.
struct JobContext {
  std::ostream& out;
  std::ostream& err;
  SceneSource scenes = load_scene;
  /// Called once all outputs stand; not where there is no result, or one of them could not be written. Empty: none.
  std::function<void(const ReportModel&)> on_result = {};
  /// Returns where a check of these inputs keeps what is done of it; may return null. Empty: nowhere.
  std::function<CheckpointStore*(const std::vector<InputFile>&)> checkpoints_of = {};
};

}  // namespace gouge
