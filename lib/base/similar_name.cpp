#include "lib/base/similar_name.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <tuple>

#include "lib/base/letters.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxEntries = 10'000;  // of a folder that is searched for a similar name

// Edits that turn `a` into `b`, a swap of neighbours being one (Damerau 1964, in its restricted form).
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> edits(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        edits[i][k] = i + k;
        continue;
      }
      const std::size_t change = edits[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      edits[i][k] = std::min({edits[i - 1][k] + 1, edits[i][k - 1] + 1, change});
      const bool is_swap = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
      if (is_swap) edits[i][k] = std::min(edits[i][k], edits[i - 2][k - 2] + 1);
    }
  }
  return edits[a.size()][b.size()];
}

struct Likeness {
  std::size_t edits = 0, common_beginning = 0, common_letters = 0;

  [[nodiscard]] bool is_nearer_than(const Likeness& other) const {
    return std::tuple(edits, other.common_beginning, other.common_letters) <
           std::tuple(other.edits, common_beginning, common_letters);
  }
};

Likeness likeness_of(std::string_view word, std::string_view name) {
  Likeness likeness{edits_between(word, name)};
  likeness.common_beginning = static_cast<std::size_t>(std::ranges::mismatch(word, name).in1 - word.begin());
  std::string a(word), b(name), common;
  std::ranges::sort(a);
  std::ranges::sort(b);
  std::ranges::set_intersection(a, b, std::back_inserter(common));
  likeness.common_letters = common.size();
  return likeness;
}

/// Returns the only name that begins with `word`; empty if there is no such name, or more than one. A file with a further
/// ending, such as part.stl.bak, is another file.
std::string find_only_begun(std::string_view word, const std::vector<std::string>& names) {
  const auto is_begun = [&](const std::string& name) {
    return name.starts_with(word) && name.size() > word.size() && name[word.size()] != '.';
  };
  const auto first = std::ranges::find_if(names, is_begun);
  return first != names.end() && std::none_of(first + 1, names.end(), is_begun) ? *first : std::string();
}

/// Names of the files in `folder`, sorted. Empty if it cannot be read.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code failed;
  std::size_t entries = 0;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end && entries < kMaxEntries;
       at.increment(failed), ++entries) {
    std::error_code unknown;
    if (!at->is_directory(unknown)) names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Returns the one of `files` that `name` was probably meant to be; another case of letters comes first.
std::string find_similar_file(const std::string& name, const std::vector<std::string>& files) {
  const std::string wanted = in_small_letters(name);
  const auto same = std::ranges::find(files, wanted, in_small_letters);
  if (same != files.end()) return *same;
  const std::string stem = fs::path(name).stem().string();
  const auto other_ending = [&](const std::string& file) { return fs::path(file).stem() == stem; };
  const auto first = std::ranges::find_if(files, other_ending);
  const std::string similar = find_similar_name(name, files);
  return similar.empty() && first != files.end() ? *first : similar;
}

}  // namespace

std::string find_similar_name(std::string_view word, const std::vector<std::string>& names) {
  constexpr std::size_t kShortest = 3, kLong = 8;
  if (word.size() < kShortest) return {};
  if (std::string begun = find_only_begun(word, names); !begun.empty()) return begun;
  const std::size_t limit = word.size() > kLong ? 4 : 3;
  const std::string* nearest = nullptr;
  Likeness best;
  for (const std::string& name : names) {
    const std::size_t longer = std::max(name.size(), word.size()), shorter = std::min(name.size(), word.size());
    if (longer - shorter >= limit) continue;
    const Likeness found = likeness_of(word, name);
    if (found.edits >= limit || (nearest != nullptr && !found.is_nearer_than(best))) continue;
    best = found;
    nearest = &name;
  }
  return nearest == nullptr ? std::string() : *nearest;
}

Diagnostic describe_missing_file(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code unknown;
  if (fs::is_symlink(fs::symlink_status(path, unknown)))
    return make_error("file-not-found",
                      "is a link to " + fs::read_symlink(path, unknown).string() + ", which does not exist", path);
  std::string message = "no such file", slashed = path;
  std::ranges::replace(slashed, '\\', '/');
  if (slashed != path && fs::exists(slashed, unknown))
    return make_error("file-not-found", message + "; did you mean " + slashed + "?", path);
  if (!folder.empty() && !fs::exists(folder, unknown)) {
    message += "; the folder " + folder.string() + " does not exist";
  } else {
    const std::string similar =
        find_similar_file(fs::path(path).filename().string(), files_in(folder.empty() ? "." : folder));
    if (!similar.empty()) message += "; did you mean " + similar + "?";
  }
  return make_error("file-not-found", message, path);
}

}  // namespace gouge
