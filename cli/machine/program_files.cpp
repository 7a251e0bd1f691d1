#include "cli/machine/program_files.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "lib/base/files.h"

namespace gouge {

namespace fs = std::filesystem;

std::shared_ptr<const ProgramSetup> with_files_beside(const std::shared_ptr<const ProgramSetup>& setup,
                                                      const std::string& path_file, std::uint64_t max_bytes,
                                                      SearchLog& searches, FileReceiver on_read) {
  ProgramSetup full = setup ? *setup : ProgramSetup{};
  const std::string folder = fs::path(path_file).parent_path().string();
  full.read_beside = [folder, max_bytes, &searches,
                      on_read = std::move(on_read)](const std::string& name) -> std::vector<std::string> {
    // A name is one of a file in the folder, never a way to another folder.
    if (name.find_first_of("/\\") != std::string::npos || name.starts_with('.')) return {};
    std::vector<std::string> texts;
    for (const std::string& file : find_files({SearchRule::program_beside, folder, name}, searches)) {
      Result<std::string> bytes = read_file(file, max_bytes);
      on_read(file, bytes);
      if (bytes) texts.push_back(std::move(*bytes));
    }
    return texts;
  };
  return std::make_shared<const ProgramSetup>(std::move(full));
}

}  // namespace gouge
