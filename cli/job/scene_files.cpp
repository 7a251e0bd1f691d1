#include "cli/job/scene_files.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/number_text.h"
#include "lib/base/parallel.h"
#include "lib/certify/assess.h"
#include "lib/check/scene_reach.h"
#include "lib/mesh/load_mesh.h"
#include "lib/validate/validate_mesh.h"

namespace gouge {
namespace {

class SceneLoader {
 public:
  SceneLoader(const SceneRequest& request, Progress& progress) : request_(request), progress_(progress) {}

  std::shared_ptr<const SceneFiles> run() {
    read_meshes(request_.parts, "part", files_->scene.parts, files_->parts, request_.place);
    read_meshes(request_.fixtures, "fixture", files_->scene.fixtures, files_->fixtures, request_.place);
    read_heads();
    if (files_->errors.empty()) add_limits();
    return std::move(files_);
  }

 private:
  void add_limits() {
    files_->scene.limits = request_.limits;
    for (const MeshLimit& limit : request_.limits) {
      std::vector<MeshFacts>& facts = rule_of(limit.against).is_workpiece ? files_->parts : files_->fixtures;
      facts[limit.mesh].clearance_mm = limit.clearance_mm;
    }
  }

  void read_heads() {
    std::vector<IndexedMesh> meshes;
    read_meshes(request_.heads, "head", meshes, files_->head_facts, RigidTransform());
    for (IndexedMesh& mesh : meshes) {
      for (const Surface& piece : head_pieces(Surface(std::move(mesh)))) add_head(piece);
    }
  }

  // Adds an error of a head, once for all its pieces.
  void add_error(const Diagnostic& error) {
    const auto is_same = [&](const Diagnostic& other) { return to_text(other) == to_text(error); };
    if (std::ranges::none_of(files_->errors, is_same)) files_->errors.push_back(error);
  }

  void add_head(const Surface& piece) {
    Result<HeadBody> head = build_head_body(piece);
    if (!head) return add_error(head.error());
    const std::vector<IndexedMesh> shells = shells_of(piece.mesh());
    const auto crosses = [](const IndexedMesh& shell) {
      const MeshValidation judged = validate_mesh(shell, find_mesh_findings(shell));
      return judged.self_intersections.pairs > 0 || !judged.trouble.empty();
    };
    if (std::any_of(shells.begin(), shells.end(), crosses)) {
      return add_error(make_error("mesh-head-crosses",
                                  "crosses itself, so what is inside the head is not defined; expected a plain solid; "
                                  "'gougecheck mesh FILE' reports where",
                                  piece.mesh().name));
    }
    files_->heads.push_back(std::move(*head));
  }

  void read_meshes(const std::vector<std::string>& names, const char* role, std::vector<IndexedMesh>& meshes,
                   std::vector<MeshFacts>& facts, const RigidTransform& place) {
    for (const std::string& name : names) {
      progress_.begin("reading " + name);
      Result<FileView> view = request_.copies != nullptr ? request_.copies->view(name, request_.max_bytes)
                                                         : view_file(name, request_.max_bytes);
      if (!view) {
        files_->errors.push_back(view.error());
        continue;
      }
      Result<LoadedMesh> loaded = describe_and_load(role, name, std::move(*view), {request_.unit, place});
      if (!loaded) {
        files_->errors.push_back(loaded.error());
        continue;
      }
      add_mesh(std::move(*loaded), name, meshes, facts);
    }
  }

  // Computes the checksum and loads the mesh side by side if there are two threads, because for a large file both take
  // equally long. Each of them releases the file as soon as possible.
  Result<LoadedMesh> describe_and_load(const char* role, const std::string& name, FileView view,
                                       const MeshPlacement& placement) {
    InputFile input;
    std::optional<Result<LoadedMesh>> loaded;
    std::array<FileView, 2> views{view, std::move(view)};
    for_each_chunk(2, 1, request_.threads, [&](std::size_t task, std::size_t) {
      FileView mine = std::move(views[task]);
      if (task == 0) {
        input = describe_input(role, name, mine.bytes);
      } else {
        loaded = load_mesh_view(std::move(mine), name, placement, progress_.call());
      }
    });
    files_->inputs.push_back(std::move(input));
    return std::move(*loaded);
  }

  void add_mesh(LoadedMesh&& loaded, const std::string& name, std::vector<IndexedMesh>& meshes,
                std::vector<MeshFacts>& facts) {
    if (const auto error = find_too_far(loaded.mesh, "part", "--stl-units and --place"))
      return files_->errors.push_back(*error);
    files_->notes.insert(files_->notes.end(), loaded.notes.begin(), loaded.notes.end());
    MeshFacts fact;
    fact.name = name;
    fact.triangles = loaded.mesh.triangles.size();
    fact.vertices = loaded.mesh.vertices.size();
    fact.dropped = loaded.findings.degenerate_triangles.count;
    fact.is_closed = loaded.findings.is_watertight();
    fact.solid = assume_solid(name, loaded.findings);
    for (const Diagnostic& d : loaded.notes) {
      if (d.severity == Severity::warning) fact.meaning += (fact.meaning.empty() ? "" : "; ") + d.message;
    }
    facts.push_back(fact);
    meshes.push_back(std::move(loaded.mesh));
  }

  const SceneRequest& request_;
  Progress& progress_;
  std::shared_ptr<SceneFiles> files_ = std::make_shared<SceneFiles>();
};

}  // namespace

std::string SceneRequest::key() const {
  std::string key = std::string(unit_name(unit)) + '\n' + place_text + '\n' + std::to_string(max_bytes);
  const std::pair<const char*, const std::vector<std::string>&> roles[] = {
      {"\npart ", parts}, {"\nfixture ", fixtures}, {"\nhead ", heads}};
  for (const auto& [role, names] : roles) {
    for (const std::string& name : names) key += role + std::to_string(name.size()) + ' ' + name;
  }
  for (const MeshLimit& limit : limits) {
    key += '\n' + std::string(against_name(limit.against)) + ' ' + std::to_string(limit.mesh) + ' ' +
           exact_text(limit.clearance_mm) + ' ' + exact_text(limit.tolerance_mm);
  }
  return key;
}

const PreparedScene& SceneFiles::prepared(unsigned threads, const ProgressCall& progress) const {
  std::call_once(once_, [&] { prepared_.emplace(scene, threads, progress); });
  return *prepared_;
}

std::shared_ptr<const SceneFiles> load_scene(const SceneRequest& request, Progress& progress) {
  return SceneLoader(request, progress).run();
}

}  // namespace gouge
