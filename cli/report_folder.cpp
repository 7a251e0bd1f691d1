#include "cli/report_folder.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kNames = {"report.html",      "result.json",  "moves.csv",
                                                    "before_after.png", "heat_map.png", "depth_along_path.png"};

// event_1.png to event_9.png: a report has fewer, and a longer number may be a date of somebody's own.
bool is_event_picture(std::string_view name) {
  return name.size() == 11 && name.starts_with("event_") && name.ends_with(".png") && name[6] >= '1' && name[6] <= '9';
}

}  // namespace

bool is_name_of_report(const std::string& name) {
  return std::find(kNames.begin(), kNames.end(), name) != kNames.end() || is_event_picture(name);
}

Diagnostics remove_older_report(const std::string& folder, const std::vector<NamedFile>& files) {
  std::vector<std::string> older;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    const bool is_new = std::any_of(files.begin(), files.end(), [&](const NamedFile& f) { return f.name == name; });
    if (is_name_of_report(name) && !is_new && entry->is_regular_file(ignored)) older.push_back(name);
  }
  std::sort(older.begin(), older.end());
  Diagnostics errors;
  for (const std::string& name : older) {
    std::error_code error;
    fs::remove(fs::path(folder) / name, error);
    if (!error) continue;
    errors.push_back(make_error("file-unwritable",
                                "belongs to an older report and cannot be removed: " + error.message(),
                                (fs::path(folder) / name).string()));
  }
  return errors;
}

}  // namespace gouge
