#include "cli/batch/batch_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <filesystem>

#include "cli/batch/settled_files.h"
#include "cli/batch/toolpath_files.h"
#include "lib/base/printable_text.h"
#include "lib/base/tolerance.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr double kNanosecond_s = 1 / 1e9;
constexpr int kWhileUnsettled_ms = 300;
// maximum pause: for network drives the system does not report what other machines write
constexpr int kWhileQuiet_ms = 5000;

double now_s() {
  timespec clock{};
  ::clock_gettime(CLOCK_MONOTONIC, &clock);
  return static_cast<double>(clock.tv_sec) + kNanosecond_s * static_cast<double>(clock.tv_nsec);
}

/// The notifications of the system about changes in a folder. Without notifications, `wait` only waits.
class FolderNews {
 public:
  explicit FolderNews(const std::string& folder) : handle_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (handle_ >= 0)
      ::inotify_add_watch(handle_, folder.c_str(),
                          IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_MODIFY);
  }
  FolderNews(const FolderNews&) = delete;
  FolderNews& operator=(const FolderNews&) = delete;
  ~FolderNews() {
    if (handle_ >= 0) ::close(handle_);
  }

  void wait(int at_max_ms) const {
    pollfd news{handle_, POLLIN, 0};
    ::poll(&news, handle_ >= 0 ? 1 : 0, at_max_ms);
    std::array<char, 4096> events{};
    while (handle_ >= 0 && ::read(handle_, events.data(), events.size()) > 0) {
    }
  }

 private:
  int handle_;
};

bool has_pattern(const std::string& place) {
  return fs::path(place).filename().string().find_first_of("*?[") != std::string::npos;
}

}  // namespace

Outcome watch_toolpaths(const std::string& place, bool are_programs, const RunToolpaths& run) {
  SettledFiles files(place);
  std::error_code ignored;
  const bool is_there = fs::is_directory(files.folder(), ignored) && (files.is_whole_folder() || has_pattern(place));
  if (!is_there)
    return make_error("usage",
                      "--watch '" + printable(place) + "': there is no such folder; expected one, or a pattern in one");
  const FolderNews news(files.folder());
  FileStamps last;
  while (true) {
    FileStamps settled = files.look(now_s());
    if (files.is_whole_folder())
      std::erase_if(settled, [&](const auto& file) { return !has_toolpath_ending(file.first, are_programs); });
    AfterRun next = AfterRun::go_on;
    if (settled != last && !settled.empty()) {
      std::vector<std::string> paths;
      for (const auto& [path, stamp] : settled) paths.push_back(path);
      next = run(paths);
    }
    if (next == AfterRun::end) return Done{};
    if (next == AfterRun::go_on) last = std::move(settled);
    news.wait(files.is_unsettled() ? kWhileUnsettled_ms : kWhileQuiet_ms);
  }
}

}  // namespace gouge
