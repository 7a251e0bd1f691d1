#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gougecheck/check.h>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"
#include "lib/check/prepared_scene.h"
#include "lib/mesh/mesh_findings.h"
#include "lib/path/toolpath.h"
#include "postproc/formats/read_toolpath.h"
#include "postproc/report/report_model.h"
#include "toolmodels/tool_library.h"

// Content of the public classes, for the sources of this module. Here a Result becomes a value or is thrown as an
// Error; code below this module does not throw.

namespace gougecheck {

[[noreturn]] void raise(const gouge::Diagnostic& error);

template <class T>
T value_or_raise(gouge::Result<T>&& result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

[[nodiscard]] Note to_note(const gouge::Diagnostic& diagnostic);
[[nodiscard]] std::vector<Note> to_notes(const gouge::Diagnostics& diagnostics);

[[nodiscard]] inline gouge::Vec3 to_vector(const Vec3& v) { return {v[0], v[1], v[2]}; }
[[nodiscard]] inline Vec3 to_array(const gouge::Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Returns a pose that a check can use, with a unit axis; nothing if the numbers do not give one.
[[nodiscard]] std::optional<gouge::Pose> to_pose(const Vec3& tip, const Vec3& axis);

/// Meshes with the indices of checks, which are made once, at the first request and from any thread. Must not move.
class SceneIndex {
 public:
  explicit SceneIndex(gouge::Scene scene) : scene_(std::move(scene)) {}

  [[nodiscard]] const gouge::Scene& scene() const { return scene_; }
  /// Returns the prepared scene; `threads` as in for_each_chunk.
  [[nodiscard]] const gouge::PreparedScene& prepared(unsigned threads) const {
    std::call_once(once_, [&] { prepared_.emplace(scene_, threads); });
    return *prepared_;
  }

 private:
  gouge::Scene scene_;
  mutable std::once_flag once_;
  mutable std::optional<gouge::PreparedScene> prepared_;
};

struct Mesh::Content {
  explicit Content(gouge::IndexedMesh mesh) : index(gouge::Scene{{std::move(mesh)}, {}}) {}

  [[nodiscard]] const gouge::IndexedMesh& mesh() const { return index.scene().parts.front(); }

  SceneIndex index;  // index of the mesh as the only part
  gouge::MeshFindings findings;
  gouge::Diagnostics notes;
  gouge::InputFile file;                           // without a role; without a name: from memory
  gouge::LengthUnit unit = gouge::LengthUnit::mm;  // in which the file was read
  bool has_unknown_unit = false;                   // read without a unit: a check takes the unit of its path
  mutable std::once_flag inch_once;
  mutable std::shared_ptr<const Content> in_inches;  // the mesh of the same file, read in inches
};

/// Access for code that makes meshes from other meshes.
struct MeshAccess {
  /// Returns a mesh of unknown unit as read in `unit`, mm or inch; a mesh of known unit stays the same.
  [[nodiscard]] static Mesh in(const Mesh& mesh, gouge::LengthUnit unit);
};

struct Scene::Content {
  std::vector<Mesh> parts, fixtures;
  std::vector<double> fixture_clearances;
  std::shared_ptr<const SceneIndex> index;

  /// Returns whether one of its files was read without a unit.
  [[nodiscard]] bool has_unknown_unit() const;

  mutable std::once_flag inch_once;
  mutable std::optional<Scene> in_inches;  // the same scene with these files read in inches
};

/// Returns the scene with its meshes of unknown unit read in `unit`. For mm, or if it has no such mesh, that is the
/// same scene.
/// Cost     A copy of those meshes, made once for each of them.
[[nodiscard]] Scene scene_in(const Scene& scene, gouge::LengthUnit unit);

struct Tool::Content {
  gouge::ToolAssembly assembly;
};

struct ToolLibrary::Content {
  gouge::ToolLibrary library;
  std::vector<gouge::InputFile> files = {};  // that of the library, then those that it names; empty: from memory
  bool is_by_facts = false;                  // read with facts that the file does not state
};

/// Facts about a program that its text does not state.
struct ProgramOrigin {
  std::string machine;  // with which it was read, with its facts; empty: none
  std::string joint_rapid_law;
  std::vector<gouge::OptionText> options;  // as the command records them
  std::vector<gouge::InputFile> files;     // that were read beside it
};

struct Path::Content {
  gouge::Toolpath path;
  bool is_from_memory = false;     // its text is made from its positions
  bool is_rewritten = false;       // its text is that of a correction, not that of the file of its name
  std::optional<ReadFacts> facts;  // those with which its text was read; none: it is not read by its text alone
  ProgramOrigin program;           // of a program
  std::vector<Vec3> tips, axes;
  std::vector<MoveKind> kinds;
  std::vector<std::uint32_t> lines;
};

/// Access for code that makes paths from other paths.
struct PathAccess {
  [[nodiscard]] static Path from(gouge::Toolpath path, bool is_from_memory);
  /// Returns the path of a program with its origin.
  [[nodiscard]] static Path with_program(const Path& path, ProgramOrigin origin);
  /// Returns the path that a correction wrote.
  [[nodiscard]] static Path rewritten(gouge::Toolpath path);
  /// Returns another path with the machine and the facts with which `path` was read.
  [[nodiscard]] static Path with_origin_of(const Path& path, gouge::Toolpath other);
  /// Returns the path as one that its text and these facts give.
  [[nodiscard]] static Path with_facts(const Path& path, const ReadFacts& facts);
  /// Reads the bytes of a file with the name `name` by the `options`.
  [[nodiscard]] static Path from_bytes(const std::string& name, std::string bytes,
                                       const gouge::ReadOptions& options = {});
};

}  // namespace gougecheck
