#include "cli/machine/program_files.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "lib/base/files.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigitsOfNumber = 4;

/// Returns the files that a name may mean.
std::vector<fs::path> files_called(const fs::path& folder, const std::string& name) {
  std::vector<std::string> names = {name};
  const bool is_number =
      name.size() > 1 && name[0] == 'O' && name.find_first_not_of("0123456789", 1) == std::string::npos;
  if (is_number && name.size() <= kDigitsOfNumber)
    names.push_back("O" + std::string(kDigitsOfNumber + 1 - name.size(), '0') + name.substr(1));
  std::vector<fs::path> found;
  for (const std::string& one : names) {
    for (const char* ending : {"", ".nc", ".NC", ".cnc", ".ngc", ".eia", ".tap", ".txt"}) {
      std::error_code error;
      const fs::path file = folder / (one + ending);
      if (fs::is_regular_file(file, error)) found.push_back(file);
    }
  }
  return found;
}

}  // namespace

std::shared_ptr<const ProgramSetup> with_files_beside(const std::shared_ptr<const ProgramSetup>& setup,
                                                      const std::string& path_file, std::uint64_t max_bytes,
                                                      FileReceiver on_read) {
  ProgramSetup full = setup ? *setup : ProgramSetup{};
  const fs::path folder = fs::path(path_file).parent_path();
  full.read_beside = [folder, max_bytes,
                      on_read = std::move(on_read)](const std::string& name) -> std::optional<std::string> {
    // A name is one of a file in the folder, never a way to another folder.
    if (name.find_first_of("/\\") != std::string::npos || name.starts_with('.')) return std::nullopt;
    const std::vector<fs::path> files = files_called(folder, name);
    if (files.size() != 1) return std::nullopt;
    Result<std::string> bytes = read_file(files.front().string(), max_bytes);
    if (!bytes) return std::nullopt;
    if (on_read) on_read(files.front().string(), *bytes);
    return std::move(*bytes);
  };
  return std::make_shared<const ProgramSetup>(std::move(full));
}

}  // namespace gouge
