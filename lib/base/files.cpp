#include "lib/base/files.h"

#include <filesystem>
#include <system_error>

#include "lib/base/staged_file.h"

namespace gouge {

Outcome write_file(const std::string& path, std::string_view bytes) {
  Result<StagedFile> staged = StagedFile::make(path, bytes);
  if (!staged) return staged.error();
  return staged->commit();
}

Outcome make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error || !std::filesystem::is_directory(path)) {
    return make_error("folder-unwritable",
                      "cannot make the folder: " + (error ? error.message() : "a file of that name exists"), path);
  }
  return Done{};
}

}  // namespace gouge
