#include "cli/last_resort.h"

#include <cxxabi.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <new>
#include <string_view>
#include <typeinfo>

#include "lib/base/exit_code.h"
#include "lib/base/temporary_name.h"

namespace gouge {
namespace {

void report(std::string_view text) {
  // Nobody is left to hear that this failed.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

// Allocates nothing, as there may be nothing to allocate.
[[noreturn]] void end_orderly() noexcept {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && (*thrown == typeid(std::bad_alloc) || *thrown == typeid(std::bad_array_new_length))) {
    report("gougecheck: error: out of memory; nothing more was written [out-of-memory]\n");
  } else {
    report("gougecheck: error: internal failure: ");
    report(thrown == nullptr ? "terminated" : thrown->name());
    report(" [internal]\n");
  }
  remove_temporary_names();
  ::_exit(kExitInternal);
}

// The second one, which comes when this handler returns, finds the usual action: whoever waits for the program sees
// which signal ended it.
void tidy_up_and_end(int signal) {
  remove_temporary_names();
  ::raise(signal);
}

}  // namespace

void tidy_up_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old {
    }, own{};
    if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler == SIG_IGN) continue;
    own.sa_handler = tidy_up_and_end;
    own.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigfillset(&own.sa_mask);
    ::sigaction(signal, &own, nullptr);
  }
}

void end_orderly_on_terminate() noexcept { std::set_terminate(end_orderly); }

}  // namespace gouge
