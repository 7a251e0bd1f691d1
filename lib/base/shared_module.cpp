#include "lib/base/shared_module.h"

#include <dlfcn.h>

namespace gouge {
namespace {

Diagnostic missing(const std::string& file) {
  const char* reason = ::dlerror();
  const std::string why = reason == nullptr ? "no reason given" : reason;
  if (why.find("cannot allocate") != std::string::npos || why.find("out of memory") != std::string::npos)
    return make_error("out-of-memory", "no memory to load " + file + ": " + why);
  return make_error("module-missing", "a part of the program cannot be loaded: " + why +
                                          "; expected it where it was built or installed with the program: install "
                                          "both together");
}

}  // namespace

Result<void*> find_function(const std::string& file, const std::string& function) {
  void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) return missing(file);
  void* address = ::dlsym(module, function.c_str());
  if (address == nullptr) return missing(file);
  return address;
}

}  // namespace gouge
