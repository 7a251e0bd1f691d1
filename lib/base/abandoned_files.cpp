#include "lib/base/abandoned_files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace gouge {
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
  // Where a file system has no locks, remove_abandoned gets none either and leaves everything.
  static_cast<void>(::flock(handle, LOCK_EX | LOCK_NB));
}

void remove_abandoned(const std::string& folder, const std::string& prefix) {
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    if (is_random_name(entry->path().filename().string(), prefix)) remove_if_abandoned(entry->path().string());
  }
}

}  // namespace gouge
