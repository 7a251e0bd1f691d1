#pragma once

#include <functional>
#include <iosfwd>
#include <vector>

#include "cli/job/scene_files.h"

namespace gouge {

struct InputFile;
struct ReportModel;
class KeptWork;

/// What surrounds one run of `check` or `correct`: where it prints, where its meshes come from, and who wants to know
/// the result beside its outputs.
struct JobContext {
  std::ostream& out;
  std::ostream& err;
  SceneSource scenes = load_scene;
  /// Called once all outputs stand; not where there is no result, or one of them could not be written. Empty: nobody.
  std::function<void(const ReportModel&)> on_result = {};
  /// Where a check of these inputs keeps what is done of it; may return null. Empty: nowhere.
  std::function<KeptWork*(const std::vector<InputFile>&)> keep_work = {};
};

}  // namespace gouge
