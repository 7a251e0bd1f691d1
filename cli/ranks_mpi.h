#pragma once

#include <memory>

#include "cli/ranks.h"

namespace gouge {

/// The processes of MPI_COMM_WORLD; null where the program was built without MPI. To be called once in a process.
[[nodiscard]] std::unique_ptr<Ranks> make_mpi_ranks();

}  // namespace gouge
