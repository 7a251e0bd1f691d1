#include "lib/base/staged_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace gouge {

namespace {

namespace fs = std::filesystem;

std::string reason() {
  return std::string(std::strerror(errno)) + (errno == EFBIG ? " (a limit of the shell, ulimit -f)" : "");
}

Diagnostic unwritable(const std::string& path, const std::string& why) {
  return make_error("file-unwritable", "cannot write the file: " + why + "; nothing was written", path);
}

std::string folder_of(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
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

// Some file systems cannot synchronise, and report that. Their data is then as safe as they make it.
bool synchronise(int handle) { return ::fsync(handle) == 0 || errno == EINVAL || errno == ENOTSUP || errno == ENOSYS; }

Outcome write_at_position(const std::string& path, std::string_view bytes) {
  const int handle = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (handle < 0) return unwritable(path, reason());
  const bool is_written = write_all(handle, bytes);
  const std::string why = reason();
  ::close(handle);
  if (!is_written) return unwritable(path, why);
  return Done{};
}

// Gives a name to a file that has none.
bool link_as(int handle, const std::string& name) {
  const std::string own = "/proc/self/fd/" + std::to_string(handle);
  return ::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

}  // namespace

Result<std::string> follow_links(const std::string& path) {
  constexpr int kMaxLinks = 40;  // the same limit as the kernel's
  fs::path at = path;
  for (int links = 0; links < kMaxLinks; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(at, error))) return at.string();
    const fs::path target = fs::read_symlink(at, error);
    if (error) return unwritable(path, error.message());
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  return unwritable(path, "its symbolic links go in a circle");
}

std::optional<std::string> why_not_replaceable(const std::string& path) {
  struct stat info {};
  if (::access(path.c_str(), W_OK) != 0) return "it is write-protected (" + reason() + ")";
  if (::stat(path.c_str(), &info) != 0) return reason();
  if (::geteuid() != 0 && info.st_uid != ::geteuid())
    return "it belongs to another user, who would lose it to a file of yours; remove it first";
  if (::geteuid() != 0 && info.st_gid != ::getegid() && ::group_member(info.st_gid) == 0)
    return "its group is not one of yours, so a new file could not keep it; remove it first";
  return std::nullopt;
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : path_(std::move(other.path_)),
      prefix_(std::move(other.prefix_)),
      target_(std::move(other.target_)),
      beside_(std::move(other.beside_)),
      direct_(std::move(other.direct_)),
      handle_(std::exchange(other.handle_, -1)) {}

StagedFile::~StagedFile() {
  if (handle_ >= 0) ::close(handle_);
}

TemporaryName StagedFile::name_beside() const { return TemporaryName(random_name(folder_of(target_) + "/" + prefix_)); }

bool StagedFile::open_beside() {
  remove_abandoned(folder_of(target_), prefix_);
  if (::access("/proc/self/fd", X_OK) == 0)
    handle_ = ::open(folder_of(target_).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (handle_ < 0) {
    // This branch is for a file system that has no files without a name.
    TemporaryName name = name_beside();
    handle_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (handle_ < 0) {
      name.forget();
      return false;
    }
    beside_ = std::move(name);
  }
  keep_from_removal(handle_);
  return true;
}

bool StagedFile::fill(const TextWriter& write) {
  struct stat old {
  }, own{};
  if (::stat(target_.c_str(), &old) == 0) {
    if (::fstat(handle_, &own) != 0) return false;
    const bool is_other = own.st_uid != old.st_uid || own.st_gid != old.st_gid;
    if (is_other && ::fchown(handle_, old.st_uid, old.st_gid) != 0) return false;
    if (::fchmod(handle_, old.st_mode & 0777) != 0) return false;
  }
  int error = 0;  // the first error: after an error nothing else succeeds
  write([&](std::string_view bytes) {
    if (error == 0 && !write_all(handle_, bytes)) error = errno;
  });
  errno = error;
  return error == 0 && synchronise(handle_);
}

Result<StagedFile> StagedFile::make(const std::string& path, std::string_view bytes, const std::string& prefix) {
  return make(
      path, [bytes](const PutText& put) { put(bytes); }, prefix);
}

Result<StagedFile> StagedFile::make(const std::string& path, const TextWriter& write, const std::string& prefix) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) return unwritable(path, "it is a folder");
  StagedFile staged(path, prefix);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    write([&](std::string_view bytes) { staged.direct_ += bytes; });
    return staged;
  }
  const Result<std::string> target = follow_links(path);
  if (!target) return target.error();
  staged.target_ = *target;
  if (fs::exists(status)) {
    if (const auto why = why_not_replaceable(staged.target_)) return unwritable(path, *why);
  }
  if (!staged.open_beside() || !staged.fill(write)) return unwritable(path, reason());
  return staged;
}

bool StagedFile::put_in_place() {
  if (beside_.empty()) {
    if (link_as(handle_, target_)) return true;
    if (errno != EEXIST) return false;
    TemporaryName name = name_beside();
    if (!link_as(handle_, name.c_str())) {
      name.forget();
      return false;
    }
    beside_ = std::move(name);
  }
  if (::rename(beside_.c_str(), target_.c_str()) != 0) return false;
  beside_.forget();
  return true;
}

Outcome StagedFile::commit() {
  if (handle_ < 0) return write_at_position(path_, direct_);
  const bool is_there = put_in_place();
  const std::string why = reason();
  ::close(std::exchange(handle_, -1));
  if (!is_there) return unwritable(path_, why);
  return Done{};
}

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLetters = "0123456789abcdefghijklmnopqrstuv";

bool is_random_name(std::string_view name, std::string_view prefix) {
  if (name.size() != prefix.size() + kRandomLetters || !name.starts_with(prefix)) return false;
  return name.find_first_not_of(kLetters, prefix.size()) == std::string_view::npos;
}

void remove_if_abandoned(const std::string& file) {
  const int handle = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (handle < 0) return;
  struct stat info {};
  const bool is_ours = ::fstat(handle, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid();
  if (is_ours && ::flock(handle, LOCK_EX | LOCK_NB) == 0) ::unlink(file.c_str());
  ::close(handle);
}

}  // namespace

std::string random_name(const std::string& prefix) {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) < 0) number = static_cast<std::uint64_t>(::getpid());
  std::string name = prefix;
  for (int i = 0; i < kRandomLetters; ++i) name += kLetters[number >> 5 * i & 31];
  return name;
}

void keep_from_removal(int handle) {
  // If a file system has no locks, remove_abandoned gets no lock either, and removes nothing.
  static_cast<void>(::flock(handle, LOCK_EX | LOCK_NB));
}

void remove_abandoned(const std::string& folder, const std::string& prefix) {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    if (is_random_name(entry->path().filename().string(), prefix)) remove_if_abandoned(entry->path().string());
  }
}

}  // namespace gouge
