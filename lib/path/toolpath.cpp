#include "lib/path/toolpath.h"

#include <array>

namespace gouge {

const char* kind_name(MoveKind kind) {
  static constexpr std::array<const char*, 4> kNames = {"feed", "rapid", "arc", "cycle"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace gouge
