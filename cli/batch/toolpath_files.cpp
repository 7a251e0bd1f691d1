#include "cli/batch/toolpath_files.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "cli/output/output_file.h"
#include "cli/output/overwriting.h"
#include "cli/output/report_folder.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOfClData[] = {".apt", ".aptsource", ".as",  ".cl",   ".cld", ".cldata",
                                          ".cls", ".clsf",      ".clt", ".nccs", ".nci", ".ncl"};
constexpr std::string_view kOfPrograms[] = {".cnc", ".eia", ".gcode", ".h",   ".iso", ".min",
                                            ".mpf", ".nc",  ".ngc",   ".ptp", ".spf", ".tap"};

// Returns the ending in small letters, without a version.
std::string ending_of(const fs::path& file) {
  const std::string ending = split_toolpath_name(file.string()).ending;
  return in_small_letters(ending.substr(0, ending.find('.', 1)));
}

template <std::size_t count>
bool is_among(const std::string& ending, const std::string_view (&known)[count]) {
  return std::ranges::find(known, ending) != std::end(known);
}

}  // namespace

bool are_of_programs(const std::vector<std::string>& words) {
  return std::ranges::any_of(words, [](const std::string& word) { return word.starts_with("--control="); });
}

bool has_toolpath_ending(const std::string& file, bool are_programs) {
  const std::string ending = ending_of(file);
  return are_programs ? is_among(ending, kOfPrograms) : is_among(ending, kOfClData);
}

namespace {

/// Finds the toolpaths in a folder and below it, also in the folders to which links lead.
class FolderWalk {
 public:
  FolderWalk(const std::string& output, bool are_programs)
      : own_(canonical_place(output)), are_programs_(are_programs) {}

  /// Adds the toolpaths of a folder, unless it was looked into before.
  void look_into(const std::string& folder) {
    if (!seen_.insert(canonical_place(folder)).second) return;
    found_.folders.push_back(folder);
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
      if (!at->path().filename().string().starts_with('.')) take(at->path().string());
    }
    if (failed)
      found_.unreadable.push_back(
          make_error("folder-unreadable", "the folder cannot be read: " + failed.message(), folder));
  }

  [[nodiscard]] std::vector<std::string> files() const { return {files_.begin(), files_.end()}; }
  [[nodiscard]] const FoldersFound& found() const { return found_; }

 private:
  // A link that leads nowhere is taken: its job fails, and so it is not overlooked.
  void take(const std::string& place) {
    std::error_code ignored;
    const fs::file_status status = fs::status(place, ignored);
    if (fs::is_directory(status)) {
      if (!is_result(place)) look_into(place);
      return;
    }
    const bool may_be_read = fs::is_regular_file(status) || !fs::exists(status);
    if (may_be_read && has_toolpath_ending(place, are_programs_)) files_.insert(place);
  }

  /// Returns whether a folder is that of the results of a batch, this one or another. Corrected toolpaths lie in it.
  [[nodiscard]] bool is_result(const std::string& folder) const {
    return canonical_place(folder) == own_ || is_batch_folder(folder) || is_interrupted_batch(folder);
  }

  std::string own_;
  bool are_programs_;
  std::set<std::string> seen_, files_;
  FoldersFound found_;
};

template <std::size_t count>
std::string listed_endings(const std::string_view (&known)[count]) {
  return listed(std::vector<std::string>(std::begin(known), std::end(known)));
}

// Returns the stem after the names of its last folders: "rough-op10" for "parts/rough/op10.apt" and one folder.
std::string name_with_folders(const fs::path& file, std::size_t folders) {
  std::string name = split_toolpath_name(file.string()).stem;
  for (fs::path at = file.parent_path(); folders > 0 && at.has_filename(); --folders, at = at.parent_path())
    name = at.filename().string() + "-" + name;
  return name;
}

bool are_distinct(std::vector<std::string> names) {
  std::ranges::sort(names);
  return std::ranges::adjacent_find(names) == names.end();
}

// Returns names for files of one stem that tell them apart, if any do.
std::vector<std::string> names_of_alike(const std::vector<fs::path>& files) {
  constexpr std::size_t kMaxFolders = 16;
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.filename().string());
  if (are_distinct(names)) return names;
  for (std::size_t folders = 1; folders <= kMaxFolders; ++folders) {
    std::vector<std::string> longer;
    for (const fs::path& file : files) longer.push_back(name_with_folders(file, folders));
    if (are_distinct(longer)) return longer;
  }
  return names;
}

}  // namespace

Result<std::vector<std::string>> expand_folders(const std::vector<std::string>& places, const std::string& output,
                                                bool are_programs) {
  std::vector<std::string> all;
  for (const std::string& place : places) {
    std::error_code ignored;
    if (!fs::is_directory(place, ignored)) {
      all.push_back(place);
      continue;
    }
    FolderWalk walk(output, are_programs);
    walk.look_into(place);
    if (const Diagnostics& unreadable = walk.found().unreadable; !unreadable.empty()) return unreadable.front();
    const std::vector<std::string> found = walk.files();
    if (found.empty())
      return make_error(
          "usage",
          "the folder " + printable(place) + " has no toolpath; expected files with an ending such as " +
              (are_programs ? listed_endings(kOfPrograms) : listed_endings(kOfClData) + " (programs need --control)") +
              "; name files of other endings themselves");
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

FoldersFound folders_in(const std::string& folder, const std::string& output) {
  FolderWalk walk(output, false);
  walk.look_into(folder);
  return walk.found();
}

std::vector<std::string> names_of_toolpaths(const std::vector<std::string>& paths) {
  std::map<std::string, std::vector<std::size_t>> of_stem;
  for (std::size_t k = 0; k < paths.size(); ++k) of_stem[split_toolpath_name(paths[k]).stem].push_back(k);
  std::vector<std::string> names(paths.size());
  for (const auto& [stem, places] : of_stem) {
    std::vector<fs::path> files;
    for (const std::size_t place : places) files.push_back(fs::absolute(paths[place]).lexically_normal());
    const std::vector<std::string> given = places.size() == 1 ? std::vector<std::string>{stem} : names_of_alike(files);
    for (std::size_t k = 0; k < places.size(); ++k) names[places[k]] = given[k];
  }
  return names;
}

}  // namespace gouge
