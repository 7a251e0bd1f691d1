#pragma once

#include <cstddef>

namespace gouge {

/// How often something was seen in a file, and the line of the first.
struct Tally {
  std::size_t count = 0, first_line = 0;

  void add(std::size_t line) {
    if (count++ == 0) first_line = line;
  }
};

}  // namespace gouge
