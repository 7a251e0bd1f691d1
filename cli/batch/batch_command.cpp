#include "cli/batch/batch_command.h"

#include "cli/batch/batch_once.h"
#include "cli/batch/watch_command.h"
#include "cli/terminal/print_diagnostics.h"

namespace gouge {

int run_batch(const BatchArguments& arguments, std::ostream& out, std::ostream& err) {
  if (arguments.watch.empty() == arguments.files.empty())
    return fail(err, {make_error("usage",
                                 "gougecheck batch needs JOBS or --watch, and not both; see gougecheck batch --help")});
  if (!arguments.watch.empty()) return run_watch(arguments, out, err);
  return run_batch_once(arguments, WatchRun::none, out, err).status;
}

}  // namespace gouge
