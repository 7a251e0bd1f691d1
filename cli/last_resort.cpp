#include "cli/last_resort.h"

#include <cxxabi.h>
#include <unistd.h>

#include <exception>
#include <new>
#include <string_view>
#include <typeinfo>

#include "cli/exit_code.h"

namespace gouge {
namespace {

void tell(std::string_view text) {
  // Nobody is left to hear that this failed.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

// Allocates nothing, as there may be nothing to allocate. Outputs that are not whole have no name yet or are
// removed by the next run.
[[noreturn]] void end_orderly() noexcept {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && (*thrown == typeid(std::bad_alloc) || *thrown == typeid(std::bad_array_new_length))) {
    tell("gougecheck: error: out of memory; nothing more was written [out-of-memory]\n");
  } else {
    tell("gougecheck: error: internal failure: ");
    tell(thrown == nullptr ? "terminated" : thrown->name());
    tell(" [internal]\n");
  }
  ::_exit(kExitInternal);
}

}  // namespace

void end_orderly_on_terminate() noexcept {
  std::set_terminate(end_orderly);
}

}  // namespace gouge
