#include "lib/base/paged_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <map>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>

#include "lib/base/large_pages.h"

namespace gouge {
namespace {

constexpr PagedLimits kUsual{std::size_t{64} << 20U, std::size_t{512} << 20U, std::size_t{512} << 20U};

// Opens a file without a name. It disappears with the process, in whatever way the process ends.
int open_nameless() {
  const char* const wanted = std::getenv("TMPDIR");
  const std::string folder = wanted != nullptr && *wanted != '\0' ? wanted : "/var/tmp";
  const int handle = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC | O_EXCL, 0600);
  if (handle >= 0) return handle;
  std::string name = folder + "/.gougecheck-pages-XXXXXX";
  const int named = ::mkostemp(name.data(), O_CLOEXEC);
  if (named >= 0) ::unlink(name.c_str());
  return named;
}

// The disk space is allocated at once: otherwise a full disk would end the process when it writes to the memory.
void* map_file(std::size_t bytes) {
  const int handle = open_nameless();
  if (handle < 0) return nullptr;
  void* start = MAP_FAILED;
  if (::posix_fallocate(handle, 0, static_cast<off_t>(bytes)) == 0)
    start = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, handle, 0);
  ::close(handle);
  return start == MAP_FAILED ? nullptr : start;
}

/// Returns the size of the file pages that the process holds, including its own program; nothing if the system does not
/// report it.
std::optional<std::size_t> resident_file_bytes() {
  std::array<char, 128> text{};
  const int handle = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
  if (handle < 0) return std::nullopt;
  const ssize_t count = ::read(handle, text.data(), text.size() - 1);
  ::close(handle);
  if (count <= 0) return std::nullopt;
  char* at = text.data();
  static_cast<void>(std::strtoull(at, &at, 10));  // size of the address space
  static_cast<void>(std::strtoull(at, &at, 10));  // all resident memory
  return static_cast<std::size_t>(std::strtoull(at, &at, 10)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// All arrays in files, and the thread that releases their pages while there are arrays.
class Pages {
 public:
  // Tests of the program (docs/develop/testing.md) set a size: all arrays from it on are in files, and no page is kept.
  Pages() {
    if (const char* const asked = std::getenv("GOUGE_PAGED_BYTES"); asked != nullptr)
      set({static_cast<std::size_t>(std::strtoull(asked, nullptr, 10)), 0, 0});
  }
  Pages(const Pages&) = delete;
  Pages& operator=(const Pages&) = delete;
  ~Pages() { stop(); }

  PagedLimits set(const PagedLimits& limits) {
    const std::scoped_lock lock(guard_);
    const PagedLimits before{min_file_bytes_, resident_bytes_, plain_bytes_};
    min_file_bytes_ = limits.min_file_bytes;
    resident_bytes_ = limits.resident_bytes;
    plain_bytes_ = limits.plain_bytes;
    return before;
  }

  void* allocate(std::size_t bytes) {
    if (bytes >= min_file_bytes_ && bytes > 0) {
      if (void* const start = allocate_large(bytes)) return start;
    }
    void* const start = ::operator new(bytes);
    ask_for_large_pages(start, bytes);
    return start;
  }

  void free(void* start, std::size_t bytes) noexcept {
    if (bytes < smallest_ || !free_large(start)) ::operator delete(start);
  }

  std::size_t count() {
    const std::scoped_lock lock(guard_);
    return arrays_.size();
  }

 private:
  // Null: no file can be made, so the array is in plain memory whatever its size.
  void* allocate_large(std::size_t bytes) {
    const std::scoped_lock lock(guard_);
    smallest_ = std::min(smallest_.load(), bytes);
    if (bytes <= plain_bytes_ && plain_used_ <= plain_bytes_ - bytes) {
      void* const start = ::operator new(bytes);
      ask_for_large_pages(start, bytes);
      plain_.emplace(start, bytes);
      plain_used_ += bytes;
      return start;
    }
    void* const start = map_file(bytes);
    if (start == nullptr) return nullptr;
    arrays_.emplace(start, bytes);
    if (arrays_.size() == 1) begin();
    return start;
  }

  // Returns false for an array that is not counted.
  bool free_large(void* start) noexcept {
    const std::scoped_lock lock(guard_);
    if (const auto found = plain_.find(start); found != plain_.end()) {
      plain_used_ -= found->second;
      plain_.erase(found);
      return false;
    }
    const auto found = arrays_.find(start);
    if (found == arrays_.end()) return false;
    ::munmap(start, found->second);
    arrays_.erase(found);
    if (arrays_.empty()) news_.notify_all();
    return true;
  }

  // If no thread can be started, the system itself releases pages, once it needs the memory.
  void begin() {
    if (trimmer_.joinable()) return news_.notify_all();
    try {
      trimmer_ = std::thread([this] { trim_while_open(); });
    } catch (const std::exception&) {
    }
  }

  void stop() {
    {
      const std::scoped_lock lock(guard_);
      is_closed_ = true;
    }
    news_.notify_all();
    if (trimmer_.joinable()) trimmer_.join();
  }

  void trim_while_open() {
    constexpr auto kPause = std::chrono::milliseconds(20);
    std::unique_lock lock(guard_);
    while (!is_closed_) {
      if (arrays_.empty()) {
        news_.wait(lock);
      } else {
        news_.wait_for(lock, kPause);
        trim();
      }
    }
  }

  // Releases pages. Written data stays: the pages of a shared file are removed from the process, not from the file.
  void trim() {
    const std::optional<std::size_t> resident = resident_file_bytes();
    if (!resident || *resident < resident_bytes_) return;
    for (const auto& [start, bytes] : arrays_) ::madvise(start, bytes, MADV_DONTNEED);
  }

  std::atomic<std::size_t> min_file_bytes_ = kUsual.min_file_bytes;
  std::atomic<std::size_t> smallest_ = static_cast<std::size_t>(-1);  // the smallest large array that there was
  std::mutex guard_;                                                  // protects all members that follow
  std::condition_variable news_;
  std::size_t resident_bytes_ = kUsual.resident_bytes, plain_bytes_ = kUsual.plain_bytes;
  std::size_t plain_used_ = 0;           // size of all arrays of plain_
  std::map<void*, std::size_t> plain_;   // large arrays in plain memory
  std::map<void*, std::size_t> arrays_;  // arrays in files
  std::thread trimmer_;
  bool is_closed_ = false;
};

Pages& pages() {
  static Pages all;
  return all;
}

}  // namespace

PagedLimits set_paged_limits(const PagedLimits& limits) { return pages().set(limits); }

void* allocate_paged(std::size_t bytes) { return pages().allocate(bytes); }

void free_paged(void* start, std::size_t bytes) noexcept { pages().free(start, bytes); }

std::size_t paged_arrays() { return pages().count(); }

}  // namespace gouge
