#pragma once

#include <map>
#include <mutex>
#include <string>

#include "cli/batch/batch_list.h"
#include "cli/job/scene_store.h"
#include "postproc/batch/job_result.h"

namespace gouge {

/// SHA-256 of files, each read once. May be used from several threads.
class FileHashes {
 public:
  /// Returns "sha256:..." as InputFile has it; empty where the file cannot be read.
  [[nodiscard]] std::string of(const std::string& file);

 private:
  std::mutex guard_;
  std::map<std::string, std::string> known_;
};

/// Returns the inputs of a job beside its files: the program, its command and its words.
[[nodiscard]] std::string job_text(const BatchJob& job, const std::string& program);

/// Returns the SHA-256 of `text`, a job_text, and of the contents of the job's files. Empty where one of them cannot be
/// read.
[[nodiscard]] std::string job_key(const BatchJob& job, const std::string& text, FileHashes& hashes);

/// Returns whether all of `outputs`, below `folder` where they are relative, are there and as they were written.
[[nodiscard]] bool are_as_written(const std::vector<JobOutput>& outputs, const std::string& folder);

/// Returns whether the name of an output leads below the folder it is relative to: a store may come from another user.
[[nodiscard]] bool is_below(const std::string& file);

/// A job that was run, and the file of its work (WorkStore), to be removed once the result is safe; empty: none.
struct JobRun {
  JobResult result;
  std::string work_file;
};

/// Runs one job to its end, whatever errors it meets, and describes its result. The `text` is its job_text. The state
/// of a long check is kept in `folder` after every `chunk` moves.
[[nodiscard]] JobRun run_job(const BatchJob& job, const std::string& text, const std::string& folder, std::size_t chunk,
                             SceneStore& scenes);

/// Checkpoints of long jobs, below the folder of a batch.
inline constexpr const char* kWorkFolder = "unfinished";
/// Removes files left there by jobs that are done.
void remove_work(const std::string& folder);

}  // namespace gouge
