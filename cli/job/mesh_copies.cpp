#include "cli/job/mesh_copies.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "lib/base/sha256.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInUse = "/in-use";
constexpr std::size_t kHashDigits = 64;  // length of a SHA-256

/// An open file, which is closed by the destructor; its lock ends too.
class OpenFile {
 public:
  OpenFile(const std::string& path, int flags) : handle_(::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW, 0600)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (handle_ >= 0) ::close(handle_);
  }
  [[nodiscard]] int handle() const { return handle_; }
  [[nodiscard]] int release() { return std::exchange(handle_, -1); }

 private:
  int handle_;
};

bool lock(int handle, int how) {
  int status = 0;
  do {
    status = ::flock(handle, how);
  } while (status != 0 && errno == EINTR);
  return status == 0;
}

bool write_all(int handle, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(handle, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// Returns the identity of the present version of a file. A new version, or another file with this name, has another
// change time.
std::string key_of(const std::string& path, const struct stat& info) {
  std::error_code ignored;
  std::string text = fs::absolute(path, ignored).string();
  for (const long long number :
       {static_cast<long long>(info.st_dev), static_cast<long long>(info.st_ino), static_cast<long long>(info.st_size),
        static_cast<long long>(info.st_mtim.tv_sec), static_cast<long long>(info.st_mtim.tv_nsec),
        static_cast<long long>(info.st_ctim.tv_sec), static_cast<long long>(info.st_ctim.tv_nsec)})
    text += '\n' + std::to_string(number);
  return sha256_of(text);
}

void remove_copies(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored)) {
    const std::string name = entry->path().filename().string();
    if (name.find_first_not_of("0123456789abcdef") >= kHashDigits && name.size() >= kHashDigits)
      files.push_back(entry->path().string());
  }
  for (const std::string& file : files) ::unlink(file.c_str());
}

}  // namespace

MeshCopies::MeshCopies(const std::string& folder) {
  if (folder.empty()) return;
  folder_ = folder + "/gougecheck-meshes-" + std::to_string(::geteuid());
  open();
  if (in_use_ < 0) folder_.clear();
}

MeshCopies::~MeshCopies() {
  if (in_use_ < 0) return;
  // If several processes end at once, only the last one gets this lock.
  if (lock(in_use_, LOCK_EX | LOCK_NB)) {
    remove_copies(folder_);
    ::unlink((folder_ + kInUse).c_str());
    ::rmdir(folder_.c_str());
  }
  ::close(in_use_);
}

void MeshCopies::open() {
  // The last process to end removes the folder, perhaps between two steps here.
  constexpr int kMaxTries = 100;
  for (int attempt = 0; attempt < kMaxTries; ++attempt) {
    if (::mkdir(folder_.c_str(), 0700) != 0 && errno != EEXIST) return note("cannot be made", errno);
    struct stat info {};
    if (::lstat(folder_.c_str(), &info) != 0) continue;
    const bool is_own = S_ISDIR(info.st_mode) && info.st_uid == ::geteuid() && (info.st_mode & 077) == 0;
    if (!is_own) return note("is no folder that you alone may write", 0);
    OpenFile in_use(folder_ + kInUse, O_RDWR | O_CREAT);
    if (in_use.handle() < 0) {
      if (errno == ENOENT) continue;
      return note("cannot be written", errno);
    }
    const bool is_alone = lock(in_use.handle(), LOCK_EX | LOCK_NB);
    if (!is_alone && errno != EWOULDBLOCK) return note("has no locks", errno);
    struct stat locked {};
    const auto is_there = [&] { return ::fstat(in_use.handle(), &locked) == 0 && locked.st_nlink > 0; };
    if (is_alone && is_there()) remove_copies(folder_);  // copies of killed processes
    if (!lock(in_use.handle(), LOCK_SH)) return note("has no locks", errno);
    if (!is_there()) continue;
    in_use_ = in_use.release();
    return;
  }
  note("is removed again and again", 0);
}

Result<FileView> MeshCopies::view(const std::string& path, std::uint64_t max_bytes) {
  struct stat info {};
  const bool may_be_copied = in_use_ >= 0 && ::stat(path.c_str(), &info) == 0 && S_ISREG(info.st_mode) &&
                             static_cast<std::uint64_t>(info.st_size) <= max_bytes;
  if (!may_be_copied) return view_file(path, max_bytes);
  const std::string copy = folder_ + "/" + key_of(path, info);
  // The process that copies holds the lock of this file, which contains the hash as soon as the copy is complete.
  OpenFile hash_file(copy + ".sha256", O_RDWR | O_CREAT);
  if (hash_file.handle() < 0 || !lock(hash_file.handle(), LOCK_EX)) {
    note("cannot be written", errno);
    return view_file(path, max_bytes);
  }
  std::array<char, kHashDigits> hash{};
  if (::pread(hash_file.handle(), hash.data(), hash.size(), 0) == static_cast<ssize_t>(hash.size())) {
    lock(hash_file.handle(), LOCK_UN);
    Result<FileView> view = view_file(copy, max_bytes);
    if (view && sha256_of(view->bytes) == std::string_view(hash.data(), hash.size())) return view;
    return view_file(path, max_bytes);
  }
  Result<FileView> view = view_file(path, max_bytes);
  if (view && put(copy, view->bytes)) static_cast<void>(write_all(hash_file.handle(), sha256_of(view->bytes)));
  return view;
}

bool MeshCopies::put(const std::string& copy, std::string_view bytes) {
  const OpenFile file(copy, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.handle() < 0 || !write_all(file.handle(), bytes)) {
    note("cannot be written", errno);
    ::unlink(copy.c_str());
    return false;
  }
  const std::scoped_lock lock(guard_);
  ++files_;
  bytes_ += bytes.size();
  return true;
}

void MeshCopies::note(const std::string& what, int error) {
  const std::scoped_lock lock(guard_);
  if (trouble_) return;
  trouble_ = make_warning("scratch-unusable",
                          what + (error != 0 ? std::string(": ") + std::strerror(error) : std::string()) +
                              "; meshes are read where they are; the results are the same",
                          folder_);
}

std::optional<Diagnostic> MeshCopies::trouble() const {
  const std::scoped_lock lock(guard_);
  return trouble_;
}

std::size_t MeshCopies::files() const {
  const std::scoped_lock lock(guard_);
  return files_;
}

std::uint64_t MeshCopies::bytes() const {
  const std::scoped_lock lock(guard_);
  return bytes_;
}

}  // namespace gouge
