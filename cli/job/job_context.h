#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "cli/job/scene_files.h"
#include "lib/base/file_search.h"

namespace gouge {

struct InputFile;
struct ReportModel;
class CheckpointStore;

/// Environment of one run of `check` or `correct`: its streams, the source of its meshes, and a receiver of the result
/// besides its outputs.
struct JobContext {
  std::ostream& out;
  std::ostream& err;
  SceneSource scenes = load_scene;
  /// Called as soon as all outputs are written; not called if there is no result, or an output could not be written.
  /// Empty: none.
  std::function<void(const ReportModel&)> on_result = {};
  /// Called with the searches for files that may be absent, before `on_result`, and if a job ends while it is read. Empty:
  /// none.
  std::function<void(const SearchLog&)> on_searches = {};
  /// Returns the store in which a check of these inputs keeps its state; may return null. Empty: no state is kept.
  std::function<CheckpointStore*(const std::vector<InputFile>&)> checkpoints_of = {};
};

}  // namespace gouge
