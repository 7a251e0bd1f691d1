#include <iostream>

#include "cli/last_resort.h"
#include "cli/run.h"
#include "cli/standard_output.h"

namespace {

void before_all(int, char**, char**) { gouge::end_orderly_on_terminate(); }

// Before the constructors of the libraries, which may run out of memory as well.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = before_all;

}  // namespace

int main(int argc, char** argv) {
  gouge::prepare_standard_streams();
  gouge::tidy_up_on_signals();
  return gouge::run(argc, argv, std::cout, std::cerr);
}
