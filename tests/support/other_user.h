#pragma once

#include <grp.h>
#include <sys/wait.h>
#include <unistd.h>

namespace gouge::testing_support {

inline constexpr unsigned kNobody = 65534;

/// Runs `act` in a process of its own. If the tests run as root, the process belongs to the user without rights.
/// Returns the result of `act`, 0 to 255, or -1 if the process did not end by itself. Expectations in `act` are lost,
/// so return their results.
template <class Act>
[[nodiscard]] int as_nobody(const Act& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    const bool is_nobody =
        ::geteuid() != 0 || (::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
    ::_exit(is_nobody ? act() : 255);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace gouge::testing_support
