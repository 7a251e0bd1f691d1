#include "toolmodels/import/beside_file.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "lib/base/files.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

// The entries of a folder that have this name: the one that has it exactly, else all that differ in case alone.
std::vector<std::string> entries_called(const fs::path& folder, const std::string& name) {
  std::error_code failed;
  if (name == ".." || fs::exists(fs::symlink_status(folder / name, failed))) return {name};
  std::vector<std::string> found;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::string entry = at->path().filename().string();
    if (lower(entry) == lower(name)) found.push_back(entry);
  }
  std::ranges::sort(found);
  return found;
}

struct Place {
  fs::path path;
  std::optional<Diagnostic> ambiguous;
};

// `name` below `folder`, spelled as it stands there; as it was asked for where there is none.
Place find_ignoring_case(const fs::path& folder, const fs::path& name) {
  fs::path at = folder;
  for (const fs::path& step : name) {
    const std::vector<std::string> found = entries_called(at, step.string());
    if (found.size() > 1)
      return {folder / name, make_error("import-beside",
                                        "no file has exactly this name, and '" + found[0] + "' and '" + found[1] +
                                            "' differ from it in case alone; rename one of them",
                                        (folder / name).string())};
    if (found.empty()) return {folder / name, std::nullopt};
    at /= found.front();
  }
  return {at, std::nullopt};
}

}  // namespace

Result<BesideFile> read_beside(const std::string& library_file, const std::string& name, std::uint64_t most_bytes) {
  const fs::path folder = fs::path(library_file).parent_path();
  std::vector<std::string> tried;
  for (const fs::path& below : {fs::path(), fs::path("..") / "Bit"}) {
    const Place place = find_ignoring_case(folder, below / name);
    if (place.ambiguous) return *place.ambiguous;
    tried.push_back(place.path.lexically_normal().string());
    Result<std::string> bytes = read_file(tried.back(), most_bytes);
    if (bytes) return BesideFile{tried.back(), std::move(*bytes)};
    if (bytes.error().code != "file-not-found") return bytes.error();
  }
  return make_error("file-not-found", "there is no such file, nor " + tried[1], tried[0]);
}

}  // namespace gouge
