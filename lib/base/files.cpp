#include "lib/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace gouge {
namespace {

namespace fs = std::filesystem;

std::string reason() {
  return std::strerror(errno);
}

Diagnostic unwritable(const std::string& path, const std::string& why) {
  return make_error("file-unwritable", "cannot write the file: " + why + "; nothing was written", path);
}

bool write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(handle, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

Outcome write_in_place(const std::string& path, std::string_view bytes) {
  const int handle = ::open(path.c_str(), O_WRONLY);
  if (handle < 0) return unwritable(path, reason());
  const bool is_written = write_all(handle, bytes);
  const std::string why = reason();
  ::close(handle);
  if (!is_written) return unwritable(path, why);
  return Done{};
}

}  // namespace

Outcome write_file(const std::string& path, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return unwritable(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_in_place(path, bytes);

  std::string beside = path + ".XXXXXX";
  const int handle = ::mkstemp(beside.data());
  if (handle < 0) return unwritable(path, reason());
  const mode_t mask = ::umask(0);
  ::umask(mask);
  bool is_written = write_all(handle, bytes) && ::fchmod(handle, 0666 & ~mask) == 0;
  std::string why = is_written ? "" : reason();
  if (::close(handle) != 0 && is_written) {
    is_written = false;
    why = reason();
  }
  if (is_written && ::rename(beside.c_str(), path.c_str()) != 0) {
    is_written = false;
    why = reason();
  }
  if (!is_written) {
    ::unlink(beside.c_str());
    return unwritable(path, why);
  }
  return Done{};
}

Outcome make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error || !fs::is_directory(path)) {
    return make_error("folder-unwritable",
                      "cannot make the folder: " + (error ? error.message() : "a file of that name exists"),
                      path);
  }
  return Done{};
}

}  // namespace gouge
