#include <cxxabi.h>
#include <execinfo.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>
#include <typeinfo>

#include "cli/run.h"
#include "cli/terminal/end_note.h"
#include "cli/terminal/terminal.h"
#include "lib/base/exit_code.h"
#include "lib/base/temporary_name.h"

namespace {

void report(std::string_view text) {
  // A failed write cannot be reported.
  [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text.data(), text.size());
}

// Ends the program with its message and kExitInternal, not with SIGABRT, after an exception that no code can catch.
// Examples are lack of memory in a destructor of the JSON library, or in a static initialiser of another library.
// Broken assertions still abort, because their core dump is the evidence of a bug. Allocates nothing, as no memory may
// be left.
[[noreturn]] void end_orderly() noexcept {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && (*thrown == typeid(std::bad_alloc) || *thrown == typeid(std::bad_array_new_length))) {
    report("gougecheck: error: out of memory; nothing more was written [out-of-memory]\n");
  } else {
    report("gougecheck: error: internal failure: ");
    report(thrown == nullptr ? "terminated" : thrown->name());
    report(" [internal]\n");
  }
  gouge::remove_temporary_names();
  ::_exit(gouge::kExitInternal);
}

// Loads the unwinder library. Otherwise glibc loads it when an ending thread first unwinds the stack, and aborts if
// there is no memory for it.
void load_unwinder() {
  void* frame = nullptr;
  ::backtrace(&frame, 1);
}

// Removes temporary names, and prints how to go on. The second signal, raised when this handler returns, takes the
// default action, so a parent that waits for the program sees which signal ended it.
void tidy_up_and_end(int signal) {
  gouge::remove_temporary_names();
  gouge::print_end_note();
  ::raise(signal);
}

// Makes SIGINT (ctrl-C), SIGTERM and SIGHUP remove the temporary names of outputs before they end the program. An
// ignored signal (nohup) stays ignored.
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

void before_all(int, char**, char**) { std::set_terminate(end_orderly); }

// Runs before the constructors of the libraries, which may run out of memory too.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = before_all;

}  // namespace

int main(int argc, char** argv) {
  load_unwinder();
  gouge::prepare_standard_streams();
  tidy_up_on_signals();
  return gouge::run(argc, argv, std::cout, std::cerr);
}
