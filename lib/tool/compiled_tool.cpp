#include "lib/tool/compiled_tool.h"

#include <array>

namespace gouge {

const char* body_name(Body body) {
  static constexpr std::array<const char*, 4> kNames = {"cutter", "shank", "holder", "head"};
  return kNames[static_cast<std::size_t>(body)];
}

}  // namespace gouge
