#pragma once

#include <string>

namespace gouge {

/// A mark in the folder of a batch that a job is running. It stays if the process ends without ending the job, for example
/// because the system has no memory left. A mark that cannot be written is left out.
class RunningMark {
 public:
  RunningMark(const std::string& folder, const std::string& job);
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;
  ~RunningMark();

 private:
  std::string folder_, file_;
};

/// Returns whether an earlier process left a mark of the job.
[[nodiscard]] bool has_running_mark(const std::string& folder, const std::string& job);

/// Removes the marks of all jobs.
void remove_running_marks(const std::string& folder);

}  // namespace gouge
