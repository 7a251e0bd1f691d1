#pragma once

#include <string>

#include "lib/base/result.h"

// Libraries that only some runs need are in shared modules of the program: OpenCV for pictures, MPI under mpirun. Other
// runs need not load the libraries behind them.

namespace gouge {

/// Returns the address of `function` in the shared module `file` (a name without a folder). The module is loaded if it
/// is not yet, and stays loaded. It is searched on the run path of the program: beside it in a build, in the folder of
/// its libraries once installed. Cost: that of loading the libraries the module needs, the first time.
/// Errors   It reports module-missing, with the system's reason. It reports out-of-memory also where less than 512 MB
///          of address space are left (ulimit -v) and the module is not yet loaded.
[[nodiscard]] Result<void*> find_function(const std::string& file, const std::string& function);

}  // namespace gouge
