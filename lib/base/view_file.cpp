#include "lib/base/view_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "lib/base/files.h"

namespace gouge {
namespace {

// Null when the file cannot be mapped: a pipe, a folder, an empty or missing file.
std::shared_ptr<const void> mapped(const std::string& path, std::size_t& size) {
  const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (handle < 0) return nullptr;
  struct stat info {};
  void* start = MAP_FAILED;
  if (::fstat(handle, &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0) {
    size = static_cast<std::size_t>(info.st_size);
    start = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, handle, 0);
  }
  ::close(handle);
  if (start == MAP_FAILED) return nullptr;
  ::madvise(start, size, MADV_SEQUENTIAL);
  return {start, [size](const void* at) { ::munmap(const_cast<void*>(at), size); }};
}

}  // namespace

Result<FileView> view_file(const std::string& path) {
  std::size_t size = 0;
  if (std::shared_ptr<const void> start = mapped(path, size)) {
    const std::string_view bytes(static_cast<const char*>(start.get()), size);
    return FileView{bytes, std::move(start)};
  }
  Result<std::string> read = read_file(path);
  if (!read) return read.error();
  const auto kept = std::make_shared<const std::string>(std::move(read.value()));
  return FileView{*kept, kept};
}

}  // namespace gouge
