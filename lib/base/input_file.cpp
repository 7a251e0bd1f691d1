#include "lib/base/input_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "lib/base/files.h"
#include "lib/base/large_pages.h"
#include "lib/base/number_text.h"
#include "lib/base/similar_name.h"

namespace gouge {
namespace {

Diagnostic unreadable(const std::string& path, int error) {
  return make_error("file-unreadable", std::string("cannot read the file: ") + std::strerror(error), path);
}

Diagnostic too_large(const std::string& path, const std::string& found, std::uint64_t max_bytes) {
  return make_error("input-too-large",
                    found + "; expected at most " + byte_size_text(max_bytes) +
                        "; check that it is the right file, or allow more with --max-input",
                    path);
}

Diagnostic changed(const std::string& path) {
  return make_error(
      "input-changed",
      "changed while it was read; expected a file that is complete; run again when what writes it is done", path);
}

// Returns whether the input is the terminal of this program: typed input ends. Other devices, such as a disk or
// /dev/zero, may never end.
bool is_own_terminal(const struct stat& info) {
  struct stat input {};
  return ::fstat(STDIN_FILENO, &input) == 0 && S_ISCHR(input.st_mode) && input.st_rdev == info.st_rdev &&
         ::isatty(STDIN_FILENO) == 1;
}

std::optional<Diagnostic> find_unfit(const struct stat& info, const std::string& path, std::uint64_t max_bytes) {
  if (S_ISDIR(info.st_mode)) return make_error("file-is-folder", "is a folder; expected a file", path);
  if (S_ISBLK(info.st_mode) || (S_ISCHR(info.st_mode) && !is_own_terminal(info)))
    return make_error("input-is-device", "is a device; expected a file or a pipe", path);
  const auto bytes = static_cast<std::uint64_t>(info.st_size);
  if (S_ISREG(info.st_mode) && bytes > max_bytes)
    return too_large(path, "has " + std::to_string(bytes) + " bytes", max_bytes);
  return std::nullopt;
}

bool is_same_state(const struct stat& a, const struct stat& b) {
  return a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

template <class Bytes>
Result<Bytes> read_all(InputReader& file) {
  Bytes bytes;
  bytes.reserve(file.expected_bytes());
  std::string chunk(std::size_t{1} << 20U, '\0');
  for (;;) {
    const Result<std::size_t> count = file.read(chunk.data(), chunk.size());
    if (!count) return count.error();
    if (*count == 0) return bytes;
    bytes.insert(bytes.end(), chunk.data(), chunk.data() + *count);
  }
}

}  // namespace

InputReader::InputReader(std::string path, int handle, const struct stat& before, std::uint64_t max_bytes)
    : path_(std::move(path)), handle_(handle), before_(before), max_bytes_(max_bytes) {}

InputReader::InputReader(InputReader&& other) noexcept
    : path_(std::move(other.path_)),
      handle_(std::exchange(other.handle_, -1)),
      before_(other.before_),
      max_bytes_(other.max_bytes_),
      bytes_(other.bytes_) {}

InputReader::~InputReader() {
  if (handle_ >= 0) ::close(handle_);
}

Result<InputReader> InputReader::open_standard_input(std::uint64_t max_bytes) {
  static std::atomic<bool> is_read{false};
  const std::string path = kStandardInput;
  if (is_read.exchange(true))
    return make_error("input-twice",
                      "standard input was read already; expected '-' for one input, and files for others", path);
  struct stat info {};
  const int handle = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0);
  if (handle < 0 || ::fstat(handle, &info) != 0) return unreadable(path, errno);
  InputReader file(path, handle, info, max_bytes);
  if (const auto unfit = find_unfit(info, path, max_bytes)) return *unfit;
  return file;
}

Result<InputReader> InputReader::open(const std::string& path, std::uint64_t max_bytes) {
  if (path == kStandardInput) return open_standard_input(max_bytes);
  struct stat info {};
  // The status is read before the file is opened, because opening a tape rewinds it.
  if (::stat(path.c_str(), &info) != 0) {
    if (errno == ENOENT) return describe_missing_file(path);
    return unreadable(path, errno);
  }
  if (const auto unfit = find_unfit(info, path, max_bytes)) return *unfit;
  const int handle = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (handle < 0) return unreadable(path, errno);
  if (::fstat(handle, &info) != 0) info = {};
  InputReader file(path, handle, info, max_bytes);
  if (const auto unfit = find_unfit(info, path, max_bytes)) return *unfit;
  return file;
}

std::size_t InputReader::expected_bytes() const {
  return S_ISREG(before_.st_mode) ? static_cast<std::size_t>(before_.st_size) : 0;
}

Result<std::size_t> InputReader::read(char* to, std::size_t room) {
  ssize_t count = 0;
  do {
    count = ::read(handle_, to, room);
  } while (count < 0 && errno == EINTR);
  if (count < 0) return unreadable(path_, errno);
  bytes_ += static_cast<std::uint64_t>(count);
  if (bytes_ > max_bytes_) return too_large(path_, "goes on after " + byte_size_text(max_bytes_), max_bytes_);
  const std::uint64_t expected = expected_bytes();
  if (expected > 0 && bytes_ > expected) return changed(path_);
  if (count > 0 || !S_ISREG(before_.st_mode)) return static_cast<std::size_t>(count);
  struct stat after {};
  const bool is_whole = ::fstat(handle_, &after) == 0 && is_same_state(before_, after);
  if (!is_whole || (expected > 0 && bytes_ != expected)) return changed(path_);
  return std::size_t{0};
}

Result<FileView> view_file(const std::string& path, std::uint64_t max_bytes) {
  Result<InputReader> file = InputReader::open(path, max_bytes);
  if (!file) return file.error();
  const std::size_t size = file->expected_bytes();
  if (size == 0) {
    Result<std::string> read = read_all<std::string>(*file);
    if (!read) return read.error();
    const auto kept = std::make_shared<const std::string>(std::move(*read));
    return FileView{*kept, kept};
  }
  const std::shared_ptr<char[]> bytes(new char[size]);  // without an initial fill with zeros
  ask_for_large_pages(bytes.get(), size);
  for (std::size_t at = 0;;) {
    char beyond = 0;
    const Result<std::size_t> count = at < size ? file->read(bytes.get() + at, size - at) : file->read(&beyond, 1);
    if (!count) return count.error();
    if (*count == 0) return FileView{{bytes.get(), size}, bytes};
    at += *count;
  }
}

Result<std::string> read_file(const std::string& path, std::uint64_t max_bytes) {
  Result<InputReader> file = InputReader::open(path, max_bytes);
  if (!file) return file.error();
  return read_all<std::string>(*file);
}

Result<PagedVector<char>> read_long_file(const std::string& path, std::uint64_t max_bytes) {
  Result<InputReader> file = InputReader::open(path, max_bytes);
  if (!file) return file.error();
  return read_all<PagedVector<char>>(*file);
}

}  // namespace gouge
