#pragma once

#include <string>

#include "lib/base/result.h"

// Libraries that only some runs need are in shared modules of the program: OpenCV for pictures, MPI under mpirun. Other
// runs do not load these libraries.

namespace gouge {

/// Returns the address of `function` in the shared module `file` (a name without a folder). The module is loaded if
/// necessary, and stays loaded. It is searched on the run path of the program: in a build beside the program, after
/// installation in the folder of its libraries. Cost: the first call loads the libraries that the module needs.
/// Errors   module-missing, with the reason that the system gives. out-of-memory, also if less than 512 MB of address
///          space are left (ulimit -v) and the module is not yet loaded.
[[nodiscard]] Result<void*> find_function(const std::string& file, const std::string& function);

}  // namespace gouge
