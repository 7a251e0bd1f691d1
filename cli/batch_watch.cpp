#include "cli/batch_watch.h"

#include <fnmatch.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr double kSettled_s = 1;
constexpr int kWhileUnsettled_ms = 300;
constexpr int kWhileQuiet_ms = 5000;  // network drives tell nothing of what others write there

double seconds_of(const timespec& time) {
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// What of a file changes when it is written.
struct Stamp {
  std::int64_t time_ns = 0;
  off_t bytes = 0;

  bool operator==(const Stamp&) const = default;
};
using Stamps = std::map<std::string, Stamp>;

bool is_passed_over(const std::string& name) {
  constexpr std::string_view kTemporary[] = {"~", ".tmp", ".part", ".partial", ".crdownload", ".swp", ".lock"};
  return name.starts_with('.') ||
         std::ranges::any_of(kTemporary, [&](std::string_view end) { return std::string_view(name).ends_with(end); });
}

/// The system's word that something happens in a folder; where it gives none, only time passes.
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

  void wait(int at_most_ms) const {
    pollfd news{handle_, POLLIN, 0};
    ::poll(&news, handle_ >= 0 ? 1 : 0, at_most_ms);
    std::array<char, 4096> events{};
    while (handle_ >= 0 && ::read(handle_, events.data(), events.size()) > 0) {
    }
  }

 private:
  int handle_;
};

class Watch {
 public:
  explicit Watch(const std::string& place) : folder_(place), pattern_("*") {
    std::error_code ignored;
    if (fs::is_directory(place, ignored)) return;
    folder_ = fs::path(place).has_parent_path() ? fs::path(place).parent_path().string() : ".";
    pattern_ = fs::path(place).filename().string();
  }

  [[nodiscard]] const std::string& folder() const { return folder_; }

  // Also whether some file is yet to settle.
  std::pair<Stamps, bool> look() {
    std::map<std::string, Seen> now;
    Stamps settled;
    timespec clock{};
    ::clock_gettime(CLOCK_MONOTONIC, &clock);
    const double now_s = seconds_of(clock);
    std::error_code ignored;
    for (fs::directory_iterator entry(folder_, ignored), end; entry != end; entry.increment(ignored)) {
      const std::string path = entry->path().string(), name = entry->path().filename().string();
      struct stat file {};
      if (is_passed_over(name) || ::fnmatch(pattern_.c_str(), name.c_str(), 0) != 0) continue;
      if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) continue;
      const Stamp stamp{file.st_mtim.tv_sec * std::int64_t{1'000'000'000} + file.st_mtim.tv_nsec, file.st_size};
      const auto before = seen_.find(path);
      // By our own clock: a copy keeps the time of what it is a copy of.
      const double since_s = before != seen_.end() && before->second.stamp == stamp ? before->second.since_s : now_s;
      now[path] = {stamp, since_s};
      if (now_s - since_s >= kSettled_s) settled[path] = stamp;
    }
    seen_ = std::move(now);
    return {settled, settled.size() < seen_.size()};
  }

 private:
  struct Seen {
    Stamp stamp;
    double since_s = 0;
  };

  std::string folder_, pattern_;
  std::map<std::string, Seen> seen_;
};

}  // namespace

Outcome watch_toolpaths(const std::string& place, const std::function<bool(const std::vector<std::string>&)>& run) {
  Watch watch(place);
  std::error_code ignored;
  if (!fs::is_directory(watch.folder(), ignored))
    return make_error("usage",
                      "--watch '" + printable(place) + "': there is no such folder; expected one, or a pattern in one");
  const FolderNews news(watch.folder());
  Stamps last;
  while (true) {
    const auto [settled, is_unsettled] = watch.look();
    if (settled != last && !settled.empty()) {
      std::vector<std::string> files;
      for (const auto& [path, stamp] : settled) files.push_back(path);
      if (!run(files)) return Done{};
    }
    last = settled;
    news.wait(is_unsettled ? kWhileUnsettled_ms : kWhileQuiet_ms);
  }
}

}  // namespace gouge
