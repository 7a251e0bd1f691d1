#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "cli/batch/batch_list.h"
#include "cli/job/scene_store.h"
#include "lib/base/file_search.h"
#include "postproc/batch/job_result.h"

namespace gouge {

/// The SHA-256 of files, each of which is read once, and the files that searches find now. May be used from several
/// threads.
class FileHashes {
 public:
  /// Returns "sha256:..." in the form of InputFile; empty if the file cannot be read.
  [[nodiscard]] std::string of(const std::string& file);
  /// Returns the files that a search finds now.
  [[nodiscard]] std::vector<std::string> found_by(const FileSearch& search);

 private:
  std::mutex guard_;
  std::map<std::string, std::string> known_;
  std::map<FileSearch, std::vector<std::string>> searches_;
};

/// Returns a text of the inputs of a job other than its files: the program, its command and its words.
[[nodiscard]] std::string job_text(const BatchJob& job, const std::string& program);

/// Returns the SHA-256 of `text`, a job_text, of the contents of the job's files, and of what `searches` find now, with
/// the contents of those files. Empty if a file cannot be read. A stored result holds as long as its key is that of its
/// own searches: so a file counts too that was absent and now exists.
[[nodiscard]] std::string job_key(const BatchJob& job, const std::string& text, const SearchLog& searches,
                                  FileHashes& hashes);

/// Returns whether all of `outputs` exist with the content that was written. Relative names are below `folder`.
[[nodiscard]] bool are_as_written(const std::vector<JobOutput>& outputs, const std::string& folder);

/// Returns whether the name of an output stays below the folder to which it is relative. A store may come from another
/// user.
[[nodiscard]] bool is_below(const std::string& file);

/// A result, and the file of the job's work (WorkStore), which is to be removed as soon as the result is stored; empty:
/// none.
struct JobRun {
  JobResult result;
  std::string work_file;
};

/// Runs one job to its end, even if it meets errors, and describes its result. The `text` is its job_text. The state of
/// a long check is kept in `folder` after every `chunk` moves.
[[nodiscard]] JobRun run_job(const BatchJob& job, const std::string& text, const std::string& folder, std::size_t chunk,
                             SceneStore& scenes);

/// Name of the folder for checkpoints of long jobs, below the folder of a batch.
inline constexpr const char* kWorkFolder = "unfinished";
/// Removes the files that completed jobs left in that folder.
void remove_work(const std::string& folder);

}  // namespace gouge
