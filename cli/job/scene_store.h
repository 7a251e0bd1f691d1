#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "cli/job/scene_files.h"
#include "cli/options/job_options.h"

namespace gouge {

/// Scenes that several jobs share. The first job that needs a scene reads and indexes it, while other jobs that need it
/// wait. It is released after the last job that may request it. May be used from several threads.
class SceneStore {
 public:
  /// `copies` are the source of files and must outlive the store; null: files are read from their own places.
  explicit SceneStore(MeshCopies* copies = nullptr) : copies_(copies) {}

  /// Registers one more job that will request the scene of these arguments.
  void expect(const JobArguments& arguments);
  /// Releases the scene for one of the registered jobs.
  void release(const JobArguments& arguments);
  /// Returns the source of the scene for a job with these arguments. The store must outlive it.
  [[nodiscard]] SceneSource source(const JobArguments& arguments);
  /// Returns a key that is equal for jobs that may share a scene. It contains the names of the files and the options
  /// for reading them.
  [[nodiscard]] static std::string group_of(const JobArguments& arguments);

 private:
  struct Entry {
    std::once_flag once;
    std::shared_ptr<const SceneFiles> files;
  };
  struct Group {
    std::size_t jobs = 0;
    // by SceneRequest::key, because units may come from the toolpath
    std::map<std::string, std::shared_ptr<Entry>> entries;
  };

  MeshCopies* copies_;
  std::mutex guard_;
  std::map<std::string, Group> groups_;
};

}  // namespace gouge
