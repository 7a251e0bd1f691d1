#pragma once

namespace gouge {

/// The exit status of every command; docs/exit_codes.md states the same to users.
enum ExitCode : int {
  kExitClean = 0,       ///< checked and clean
  kExitGouges = 1,      ///< gouges, or gouges that remain after correction; defects of a mesh
  kExitUsage = 2,       ///< wrong command line
  kExitInput = 3,       ///< input unreadable or invalid
  kExitNotChecked = 4,  ///< not fully checked
  kExitInternal = 5,    ///< internal or resource failure; output unwritable
};

}  // namespace gouge
