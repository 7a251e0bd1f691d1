#include "cli/machine/program_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/files.h"
#include "lib/base/letters.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

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

/// Returns the files of a folder that a name may mean, in the order of their names. A name with an ending means one file.
std::vector<fs::path> files_called(const fs::path& folder, const std::string& name) {
  constexpr auto kEndings = std::to_array<std::string_view>({"", ".nc", ".cnc", ".ngc", ".eia", ".tap", ".txt"});
  const bool has_number = name.size() > 1 && name[0] == 'O' && is_number(std::string_view(name).substr(1));
  const bool is_of_file = name.find('.') != std::string::npos;
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator at(folder.empty() ? "." : folder, failed), end; !failed && at != end;
       at.increment(failed)) {
    const fs::path file = at->path().filename();
    const std::string stem = file.stem().string(), ending = in_small_letters(file.extension().string());
    const bool has_ending = std::ranges::find(kEndings, ending) != kEndings.end();
    const bool is_called = has_number   ? has_ending && is_same_number(stem, name)
                           : is_of_file ? file == name
                                        : has_ending && stem == name;
    std::error_code ignored;
    if (is_called && at->is_regular_file(ignored)) found.push_back(folder / file);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::shared_ptr<const ProgramSetup> with_files_beside(const std::shared_ptr<const ProgramSetup>& setup,
                                                      const std::string& path_file, std::uint64_t max_bytes,
                                                      FileReceiver on_read) {
  ProgramSetup full = setup ? *setup : ProgramSetup{};
  const fs::path folder = fs::path(path_file).parent_path();
  full.read_beside = [folder, max_bytes,
                      on_read = std::move(on_read)](const std::string& name) -> std::vector<std::string> {
    // A name is one of a file in the folder, never a way to another folder.
    if (name.find_first_of("/\\") != std::string::npos || name.starts_with('.')) return {};
    std::vector<std::string> texts;
    for (const fs::path& file : files_called(folder, name)) {
      Result<std::string> bytes = read_file(file.string(), max_bytes);
      if (!bytes) continue;
      if (on_read) on_read(file.string(), *bytes);
      texts.push_back(std::move(*bytes));
    }
    return texts;
  };
  return std::make_shared<const ProgramSetup>(std::move(full));
}

}  // namespace gouge
