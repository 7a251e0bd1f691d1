#include "lib/base/shared_module.h"

#include <dlfcn.h>
#include <sys/mman.h>

namespace gouge {
namespace {

// Memory that OpenCV, MPI and their libraries request while they are loaded. Some of the libraries (OpenBLAS) retry
// forever if memory is refused, so the program requests this memory before it loads them.
constexpr std::size_t kAddressSpaceToLoad = 512'000'000;

bool has_address_space_to_load() {
  void* start = ::mmap(nullptr, kAddressSpaceToLoad, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return start != MAP_FAILED && ::munmap(start, kAddressSpaceToLoad) == 0;
}

// Returns whether the message is about memory. A segment that cannot be mapped has two possible causes: its folder is
// mounted without permission to execute, or there is no memory for it.
bool tells_of_memory(const std::string& why) {
  const auto says = [&](const char* words) { return why.find(words) != std::string::npos; };
  return says("cannot allocate") || says("Cannot allocate") || says("out of memory") ||
         (says("failed to map segment") && !says("not permitted"));
}

Diagnostic no_memory(const std::string& file, const std::string& why) {
  return make_error("out-of-memory", "no memory to load " + file + ": " + why);
}

Diagnostic missing(const std::string& file) {
  const char* reason = ::dlerror();
  const std::string why = reason == nullptr ? "no reason given" : reason;
  if (tells_of_memory(why)) return no_memory(file, why);
  return make_error("module-missing", "a part of the program cannot be loaded: " + why +
                                          "; expected it where it was built or installed with the program: install "
                                          "both together");
}

}  // namespace

Result<void*> find_function(const std::string& file, const std::string& function) {
  void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD);
  if (module == nullptr) {
    ::dlerror();
    if (!has_address_space_to_load()) return no_memory(file, "less than 512 MB of address space are left");
    module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  }
  if (module == nullptr) return missing(file);
  void* address = ::dlsym(module, function.c_str());
  if (address == nullptr) return missing(file);
  return address;
}

}  // namespace gouge
