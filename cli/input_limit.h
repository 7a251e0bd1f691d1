#pragma once

#include <cstdint>
#include <string>

#include "lib/base/files.h"

namespace CLI {
class App;
}

namespace gouge {

/// --max-input of a command, in bytes: no file it reads may have more.
struct InputLimit {
  std::uint64_t most_bytes = kMaxInputBytes;
};

/// The parser refuses what is no size, so that `limit` is always usable.
void add_input_limit(CLI::App& command, InputLimit& limit);

}  // namespace gouge
