// Loaded before a program (LD_PRELOAD): lets the n-th call of a kind fail, deliver less, or end the process. The
// environment states which, GOUGE_FAULT=KIND:N:WHAT, N counted from 1 and with a + for that call and all after it:
//
//   KIND   memory (malloc and its like), map (mmap), thread, open, read, write, sync, place (rename, linkat, mkdir,
//          fchmod, fchown, ftruncate), remove (unlink, rmdir), close
//   WHAT   the name of an errno (EIO), short (half of the request), or a signal (SIGKILL)
//
// Calls are counted from main on, or where GOUGE_FAULT_EARLY is set from the first of the dynamic loader on. Their
// numbers are written to the file GOUGE_FAULT_COUNTS, one "KIND N" a line. What the C library calls within itself
// (stdio) is not seen.

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

enum Kind { memory, map, thread, open_, read_, write_, sync_, place, remove_, close_, kKinds };
constexpr const char* kNames[kKinds] = {"memory", "map",  "thread", "open",   "read",
                                        "write",  "sync", "place",  "remove", "close"};

struct Named {
  const char* name;
  int number;
};
constexpr Named kErrors[] = {{"EIO", EIO},       {"ENOSPC", ENOSPC}, {"EINTR", EINTR},   {"ENOMEM", ENOMEM},
                             {"EAGAIN", EAGAIN}, {"EMFILE", EMFILE}, {"EACCES", EACCES}, {"EDQUOT", EDQUOT}};
constexpr Named kSignals[] = {{"SIGKILL", SIGKILL}, {"SIGTERM", SIGTERM}, {"SIGINT", SIGINT}};

enum class Happening { nothing, failure, cut };

// Plain data, set without any constructor: the first call may come before them all.
std::atomic<long> counts[kKinds];
std::atomic<bool> is_counting;
int chosen_kind = -1;
long chosen_call = 0;
bool is_lasting = false, is_cut = false;
int error_number = 0, signal_number = 0;

int number_called(const Named* first, const Named* last, const char* name) {
  const Named* found = std::find_if(first, last, [&](const Named& n) { return std::strcmp(n.name, name) == 0; });
  return found == last ? 0 : found->number;
}

void understand() {
  const char* text = std::getenv("GOUGE_FAULT");
  if (text == nullptr) return;
  char kind[16] = "", what[16] = "", plus = 0;
  if (std::sscanf(text, "%15[a-z]:%ld%c", kind, &chosen_call, &plus) < 2) std::abort();
  is_lasting = plus == '+';
  const char* last = std::strrchr(text, ':');
  std::strncpy(what, last + 1, sizeof what - 1);
  for (int k = 0; k < kKinds; ++k)
    if (std::strcmp(kNames[k], kind) == 0) chosen_kind = k;
  is_cut = std::strcmp(what, "short") == 0;
  error_number = number_called(std::begin(kErrors), std::end(kErrors), what);
  signal_number = number_called(std::begin(kSignals), std::end(kSignals), what);
  // A misspelt fault would be a trial in which nothing happens.
  if (chosen_kind < 0 || (!is_cut && error_number == 0 && signal_number == 0)) std::abort();
}

Happening happens(Kind kind) {
  if (!is_counting.load(std::memory_order_relaxed)) return Happening::nothing;
  const long call = ++counts[kind];
  if (kind != chosen_kind || (is_lasting ? call < chosen_call : call != chosen_call)) return Happening::nothing;
  if (signal_number != 0) {
    ::syscall(SYS_kill, ::getpid(), signal_number);
    return Happening::nothing;
  }
  if (is_cut) return Happening::cut;
  errno = error_number;
  return Happening::failure;
}

bool fails(Kind kind) { return happens(kind) == Happening::failure; }

void write_counts() {
  is_counting = false;
  const char* file = std::getenv("GOUGE_FAULT_COUNTS");
  if (file == nullptr) return;
  const long handle = ::syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  for (int k = 0; k < kKinds; ++k) {
    char line[64];
    const int length = std::snprintf(line, sizeof line, "%s %ld\n", kNames[k], counts[k].load());
    ::syscall(SYS_write, handle, line, length);
  }
  ::syscall(SYS_close, handle);
}

using Main = int(int, char**, char**);
Main* program_main;

int counted_main(int argc, char** argv, char** environment) {
  std::atexit(write_counts);
  is_counting = true;
  return program_main(argc, argv, environment);
}

template <class Call>
auto among_bytes(Kind kind, std::size_t count, const Call& call) -> ssize_t {
  const Happening what = happens(kind);
  if (what == Happening::failure) return -1;
  return static_cast<ssize_t>(call(what == Happening::cut ? (count + 1) / 2 : count));
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
  return fails(open_) ? -1 : static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}

mode_t mode_of(int flags, va_list rest) { return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0; }

}  // namespace

extern "C" {

int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(), void (*loader_fini)(),
                      void* stack_end) {
  using Start = int(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
  understand();
  is_counting = std::getenv("GOUGE_FAULT_EARLY") != nullptr;
  program_main = main;
  auto* start = reinterpret_cast<Start*>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(counted_main, argc, argv, init, fini, loader_fini, stack_end);
}

void* malloc(std::size_t size) { return fails(memory) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) { return fails(memory) ? nullptr : __libc_calloc(count, size); }
void* realloc(void* old, std::size_t size) { return fails(memory) ? nullptr : __libc_realloc(old, size); }
void* memalign(std::size_t alignment, std::size_t size) {
  return fails(memory) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** to, std::size_t alignment, std::size_t size) {
  void* got = memalign(alignment, size);
  if (got == nullptr) return ENOMEM;
  *to = got;
  return 0;
}

void* mmap(void* at, std::size_t size, int protection, int flags, int handle, off_t offset) {
  if (fails(map)) return MAP_FAILED;
  return reinterpret_cast<void*>(::syscall(SYS_mmap, at, size, protection, flags, handle, offset));
}

int pthread_create(pthread_t* made, const pthread_attr_t* attributes, void* (*run)(void*), void* argument) {
  using Create = int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  static auto* create = reinterpret_cast<Create*>(::dlsym(RTLD_NEXT, "pthread_create"));
  return fails(thread) ? EAGAIN : create(made, attributes, run, argument);
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(AT_FDCWD, path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, rest);
  va_end(rest);
  return open_at(folder, path, flags, mode);
}
int __open_2(const char* path, int flags) { return open_at(AT_FDCWD, path, flags, 0); }
int __openat_2(int folder, const char* path, int flags) { return open_at(folder, path, flags, 0); }

ssize_t read(int handle, void* bytes, std::size_t count) {
  return among_bytes(read_, count, [&](std::size_t n) { return ::syscall(SYS_read, handle, bytes, n); });
}
ssize_t __read_chk(int handle, void* bytes, std::size_t count, std::size_t) { return read(handle, bytes, count); }
ssize_t pread(int handle, void* bytes, std::size_t count, off_t at) {
  return among_bytes(read_, count, [&](std::size_t n) { return ::syscall(SYS_pread64, handle, bytes, n, at); });
}
ssize_t write(int handle, const void* bytes, std::size_t count) {
  return among_bytes(write_, count, [&](std::size_t n) { return ::syscall(SYS_write, handle, bytes, n); });
}
ssize_t writev(int handle, const iovec* pieces, int count) {
  return fails(write_) ? -1 : static_cast<ssize_t>(::syscall(SYS_writev, handle, pieces, count));
}

int fsync(int handle) { return fails(sync_) ? -1 : static_cast<int>(::syscall(SYS_fsync, handle)); }
int fdatasync(int handle) { return fails(sync_) ? -1 : static_cast<int>(::syscall(SYS_fdatasync, handle)); }

int rename(const char* from, const char* to) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int linkat(int from, const char* old_name, int to, const char* new_name, int flags) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_linkat, from, old_name, to, new_name, flags));
}
int unlink(const char* name) {
  return fails(remove_) ? -1 : static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, name, 0));
}
int rmdir(const char* name) {
  return fails(remove_) ? -1 : static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, name, AT_REMOVEDIR));
}
int mkdir(const char* name, mode_t mode) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, name, mode));
}
int fchmod(int handle, mode_t mode) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_fchmod, handle, mode));
}
int fchown(int handle, uid_t owner, gid_t group) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_fchown, handle, owner, group));
}
int ftruncate(int handle, off_t size) {
  return fails(place) ? -1 : static_cast<int>(::syscall(SYS_ftruncate, handle, size));
}

// The handle is gone all the same, as with a disk that reports its failure last.
int close(int handle) {
  const bool is_failing = fails(close_);
  const int reason = errno;
  const auto closed = static_cast<int>(::syscall(SYS_close, handle));
  if (!is_failing) return closed;
  errno = reason;
  return -1;
}

}  // extern "C"
