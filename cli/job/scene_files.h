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

/// STL files that a job is checked against, and the way to read them.
struct SceneRequest {
  std::vector<std::string> parts, fixtures, heads;
  LengthUnit unit = LengthUnit::mm;
  RigidTransform place;    ///< of parts and fixtures; heads are in the tool's frame
  std::string place_text;  ///< the same, as the user typed it
  std::uint64_t max_bytes = 0;
  unsigned threads = 0;
  MeshCopies* copies = nullptr;  ///< where files are read from; none: where they are
  std::vector<MeshLimit> limits{};

  /// Returns a key that is equal for requests that read the same files in the same way.
  [[nodiscard]] std::string key() const;
};

/// The meshes that were read. They are immutable, so that several jobs may share them, from any thread.
class SceneFiles {
 public:
  Scene scene;
  std::vector<HeadBody> heads;    ///< in the tool's frame
  std::vector<InputFile> inputs;  ///< in the order parts, fixtures, heads
  std::vector<MeshFacts> parts, fixtures, head_facts;
  Diagnostics notes;
  Diagnostics errors;  ///< where there is one the rest is of no use

  /// Returns the scene with its indices, made at the first call. `threads` as in for_each_chunk.
  [[nodiscard]] const PreparedScene& prepared(unsigned threads, const ProgressCall& progress = {}) const;

 private:
  mutable std::once_flag once_;
  mutable std::optional<PreparedScene> prepared_;
};

/// Reads every file. All errors are in the result, not the first alone.
[[nodiscard]] std::shared_ptr<const SceneFiles> load_scene(const SceneRequest& request, Progress& progress);

/// Source of a job's scene: load_scene, or a store that several jobs share.
using SceneSource = std::function<std::shared_ptr<const SceneFiles>(const SceneRequest& request, Progress& progress)>;

}  // namespace gouge
