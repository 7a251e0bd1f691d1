#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "cli/job/scene_files.h"
#include "cli/options/job_options.h"

namespace gouge {

/// Scenes that several jobs share. Each is read and indexed once, by the first job that needs it, while others that
/// want the same wait. It is released when the last job that may request it is done. May be used from several threads.
class SceneStore {
 public:
  /// Files are read from `copies`, which must outlive it; none: where they are.
  explicit SceneStore(MeshCopies* copies = nullptr) : copies_(copies) {}

  /// One more job will request the scene of these arguments.
  void expect(const JobArguments& arguments);
  /// A job that was expected is done with it.
  void release(const JobArguments& arguments);
  /// Returns where a job of these arguments has its scene from; the store must outlive it.
  [[nodiscard]] SceneSource source(const JobArguments& arguments);
  /// Returns a key that is equal for jobs that may share a scene. It states the files that they name and how.
  [[nodiscard]] static std::string group_of(const JobArguments& arguments);

 private:
  struct Entry {
    std::once_flag once;
    std::shared_ptr<const SceneFiles> files;
  };
  struct Group {
    std::size_t jobs = 0;
    std::map<std::string, std::shared_ptr<Entry>> entries;  // by SceneRequest::key, as units may come from the toolpath
  };

  MeshCopies* copies_;
  std::mutex guard_;
  std::map<std::string, Group> groups_;
};

}  // namespace gouge
