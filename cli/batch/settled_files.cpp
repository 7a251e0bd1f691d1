#include "cli/batch/settled_files.h"

#include <fnmatch.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr double kSettled_s = 1;

bool is_passed_over(const std::string& name) {
  constexpr std::string_view kTemporary[] = {"~", ".tmp", ".part", ".partial", ".crdownload", ".swp", ".lock"};
  return name.starts_with('.') ||
         std::ranges::any_of(kTemporary, [&](std::string_view end) { return std::string_view(name).ends_with(end); });
}

}  // namespace

SettledFiles::SettledFiles(const std::string& place) : folder_(place), pattern_("*") {
  std::error_code ignored;
  is_whole_folder_ = fs::is_directory(place, ignored);
  if (is_whole_folder_) return;
  folder_ = fs::path(place).has_parent_path() ? fs::path(place).parent_path().string() : ".";
  pattern_ = fs::path(place).filename().string();
}

FileStamps SettledFiles::look(double now_s) {
  std::map<std::string, Seen> now;
  FileStamps settled;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder_, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string path = entry->path().string(), name = entry->path().filename().string();
    struct stat file {};
    if (is_passed_over(name) || ::fnmatch(pattern_.c_str(), name.c_str(), 0) != 0) continue;
    if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode)) continue;
    const FileStamp stamp{file.st_mtim.tv_sec * std::int64_t{1'000'000'000} + file.st_mtim.tv_nsec, file.st_size};
    const auto before = seen_.find(path);
    const double since_s = before != seen_.end() && before->second.stamp == stamp ? before->second.since_s : now_s;
    now[path] = {stamp, since_s};
    if (now_s - since_s >= kSettled_s) settled[path] = stamp;
  }
  seen_ = std::move(now);
  is_unsettled_ = settled.size() < seen_.size();
  return settled;
}

}  // namespace gouge
