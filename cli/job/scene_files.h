#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/job/mesh_copies.h"
#include "cli/terminal/progress.h"
#include "lib/base/diagnostic.h"
#include "lib/base/units.h"
#include "lib/check/prepared_scene.h"
#include "lib/check/scene.h"
#include "lib/geom/pose.h"
#include "lib/head/head_body.h"
#include "postproc/report/report_model.h"

namespace gouge {

/// The STL files for the check of a job, and options for reading them.
struct SceneRequest {
  std::vector<std::string> parts, fixtures, heads;
  LengthUnit unit = LengthUnit::mm;
  RigidTransform place;    ///< place of parts and fixtures; heads are in the frame of the tool
  std::string place_text;  ///< the place as the user typed it
  std::uint64_t max_bytes = 0;
  unsigned threads = 0;
  MeshCopies* copies = nullptr;  ///< source of copies; null: files are read from their own places
  std::vector<MeshLimit> limits{};

  /// Returns a key that is equal for requests that read the same files in the same way.
  [[nodiscard]] std::string key() const;
};

/// The meshes that were read. They are immutable, so several jobs may share them, from any thread.
class SceneFiles {
 public:
  Scene scene;
  std::vector<HeadBody> heads;    ///< in the frame of the tool
  std::vector<InputFile> inputs;  ///< in the order parts, fixtures, heads
  std::vector<MeshFacts> parts, fixtures, head_facts;
  Diagnostics notes;
  Diagnostics errors;  ///< if there is an error, the other members are useless

  /// Returns the scene with its indices, which are made in the first call. `threads` as in for_each_chunk.
  [[nodiscard]] const PreparedScene& prepared(unsigned threads, const ProgressCall& progress = {}) const;

 private:
  mutable std::once_flag once_;
  mutable std::optional<PreparedScene> prepared_;
};

/// Reads every file. The result has all errors, not only the first.
[[nodiscard]] std::shared_ptr<const SceneFiles> load_scene(const SceneRequest& request, Progress& progress);

/// Source of a job's scene: load_scene, or a store that several jobs share.
using SceneSource = std::function<std::shared_ptr<const SceneFiles>(const SceneRequest& request, Progress& progress)>;

}  // namespace gouge
