#include "cli/batch/running_mark.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "lib/base/sha256.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "/running";

// Returns the file of a mark. Names of jobs differ in bytes that some file systems do not distinguish, so it is a hash.
std::string mark_of(const std::string& folder, const std::string& job) {
  return folder + kFolder + "/" + sha256_of(job) + ".job";
}

}  // namespace

RunningMark::RunningMark(const std::string& folder, const std::string& job)
    : folder_(folder + kFolder), file_(mark_of(folder, job)) {
  std::error_code ignored;
  fs::create_directory(folder_, ignored);
  std::ofstream(file_) << job << '\n';
}

RunningMark::~RunningMark() {
  ::unlink(file_.c_str());
  ::rmdir(folder_.c_str());  // has an effect only if it is an empty folder
}

bool has_running_mark(const std::string& folder, const std::string& job) {
  std::error_code ignored;
  return fs::is_regular_file(mark_of(folder, job), ignored);
}

void remove_running_marks(const std::string& folder) {
  std::error_code ignored;
  std::vector<fs::path> marks;
  for (fs::directory_iterator entry(folder + kFolder, ignored), end; entry != end; entry.increment(ignored))
    if (entry->path().extension() == ".job") marks.push_back(entry->path());
  for (const fs::path& mark : marks) fs::remove(mark, ignored);
  ::rmdir((folder + kFolder).c_str());
}

}  // namespace gouge
