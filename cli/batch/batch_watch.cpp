#include "cli/batch/batch_watch.h"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <filesystem>
#include <set>
#include <utility>

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

/// The notifications of the system about changes in folders. Without notifications, `wait` only waits.
class FolderNews {
 public:
  FolderNews() : handle_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {}
  FolderNews(const FolderNews&) = delete;
  FolderNews& operator=(const FolderNews&) = delete;
  ~FolderNews() {
    if (handle_ >= 0) ::close(handle_);
  }

  /// Adds folders. A folder that was added before is no error. The system drops those that are removed.
  void add(const std::vector<std::string>& folders) const {
    for (const std::string& folder : folders) {
      if (handle_ >= 0)
        ::inotify_add_watch(handle_, folder.c_str(),
                            IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_MODIFY | IN_CREATE);
    }
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

/// Warns once of each folder that cannot be read.
class FolderWarnings {
 public:
  explicit FolderWarnings(const TakeWarning& warn) : warn_(warn) {}

  void tell(const Diagnostics& unreadable) {
    std::set<std::string> now;
    for (const Diagnostic& one : unreadable) {
      now.insert(one.file);
      if (!told_.contains(one.file))
        warn_(make_warning(one.code, one.message + "; its toolpaths are not checked until it can", one.file));
    }
    told_ = std::move(now);
  }

 private:
  const TakeWarning& warn_;
  std::set<std::string> told_;
};

}  // namespace

std::optional<Diagnostic> find_wrong_place(const std::string& place) {
  const SettledFiles files(place);
  std::error_code ignored;
  if (fs::is_directory(files.folder(), ignored) && (files.is_whole_folder() || has_pattern(place))) return std::nullopt;
  return make_error("usage",
                    "--watch '" + printable(place) + "': there is no such folder; expected one, or a pattern in one");
}

void watch_toolpaths(const WatchedPlace& watched, const RunToolpaths& run, const TakeWarning& warn) {
  SettledFiles files(watched.place, watched.output);
  SettledInputs inputs(watched.inputs(), now_s());
  const FolderNews news;
  FolderWarnings warnings(warn);
  FileStamps last, last_inputs;
  while (true) {
    FileStamps settled = files.look(now_s());
    inputs.set(watched.inputs());
    FileStamps settled_inputs = inputs.look(now_s());
    news.add(files.folders());
    warnings.tell(files.unreadable());
    if (files.is_whole_folder())
      std::erase_if(settled, [&](const auto& file) { return !has_toolpath_ending(file.first, watched.are_programs); });
    AfterRun next = AfterRun::go_on;
    if ((settled != last || settled_inputs != last_inputs) && !settled.empty()) {
      std::vector<std::string> paths;
      for (const auto& [path, stamp] : settled) paths.push_back(path);
      next = run(paths);
    }
    if (next == AfterRun::end) return;
    if (next == AfterRun::go_on) {
      last = std::move(settled);
      last_inputs = std::move(settled_inputs);
    }
    news.wait(files.is_unsettled() || inputs.is_unsettled() ? kWhileUnsettled_ms : kWhileQuiet_ms);
  }
}

}  // namespace gouge
