#include "lib/base/file_search.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "lib/base/letters.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::pair<SearchRule, const char*> kRules[] = {{SearchRule::program_beside, "program-beside"},
                                                         {SearchRule::named_by_tools, "named-by-tools"}};

bool is_number(std::string_view digits) {
  return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
}

// O2, o0002 and O00002 are one program.
bool is_same_number(std::string_view stem, std::string_view name) {
  if (stem.empty() || capital(stem[0]) != 'O' || !is_number(stem.substr(1))) return false;
  const auto digits = [](std::string_view text) {
    return text.substr(std::min(text.find_first_not_of("O0o"), text.size()));
  };
  return digits(stem) == digits(name);
}

bool is_program_called(const fs::path& file, const std::string& name) {
  constexpr auto kProgramEndings = std::to_array<std::string_view>({"", ".nc", ".cnc", ".ngc", ".eia", ".tap", ".txt"});
  const bool has_number = name.size() > 1 && name[0] == 'O' && is_number(std::string_view(name).substr(1));
  if (!has_number && name.find('.') != std::string::npos) return file == name;
  const std::string stem = file.stem().string(), ending = in_small_letters(file.extension().string());
  if (std::ranges::find(kProgramEndings, ending) == kProgramEndings.end()) return false;
  return has_number ? is_same_number(stem, name) : stem == name;
}

std::vector<std::string> find_programs(const fs::path& folder, const std::string& name) {
  std::vector<std::string> found;
  std::error_code failed;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const fs::path file = at->path().filename();
    std::error_code ignored;
    if (is_program_called(file, name) && at->is_regular_file(ignored)) found.push_back((folder / file).string());
  }
  std::ranges::sort(found);
  return found;
}

// Returns the entries of a folder with this name: the entry with exactly this name, else all that differ from it in
// case alone.
std::vector<std::string> entries_called(const fs::path& folder, const std::string& name) {
  std::error_code failed;
  if (name == ".." || fs::exists(fs::symlink_status(folder / name, failed))) return {name};
  std::vector<std::string> found;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const std::string entry = at->path().filename().string();
    if (in_small_letters(entry) == in_small_letters(name)) found.push_back(entry);
  }
  std::ranges::sort(found);
  return found;
}

// Returns the path of `name` below `folder`, spelled as the entries of the folder; several if a step is ambiguous.
std::vector<std::string> find_ignoring_case(const fs::path& folder, const fs::path& name) {
  fs::path at = folder;
  for (const fs::path& step : name) {
    std::vector<std::string> entries = entries_called(at, step.string());
    if (entries.empty()) return {};
    if (entries.size() > 1) {
      for (std::string& entry : entries) entry = (at / entry).lexically_normal().string();
      return entries;
    }
    at /= entries.front();
  }
  // A file that cannot be examined may be there: its reader states the reason.
  std::error_code ignored;
  if (fs::status(at, ignored).type() == fs::file_type::not_found) return {};
  return {at.lexically_normal().string()};
}

}  // namespace

const char* rule_name(SearchRule rule) {
  const auto* const known = std::ranges::find(kRules, rule, &std::pair<SearchRule, const char*>::first);
  return known->second;
}

std::optional<SearchRule> search_rule_called(std::string_view name) {
  for (const auto& [rule, its_name] : kRules)
    if (name == its_name) return rule;
  return std::nullopt;
}

std::vector<std::string> repeat_search(const FileSearch& search) {
  if (search.rule == SearchRule::program_beside) return find_programs(search.folder, search.name);
  for (const fs::path& below : {fs::path(), fs::path("..") / "Bit"}) {
    std::vector<std::string> found = find_ignoring_case(search.folder, below / search.name);
    if (!found.empty()) return found;
  }
  return {};
}

std::vector<std::string> find_files(const FileSearch& search, SearchLog& log) {
  std::vector<std::string> found = repeat_search(search);
  DoneSearch done{search, found};
  if (std::ranges::find(log, done) == log.end()) log.push_back(std::move(done));
  return found;
}

std::string place_of(const FileSearch& search) {
  return (fs::path(search.folder) / search.name).lexically_normal().string();
}

}  // namespace gouge
