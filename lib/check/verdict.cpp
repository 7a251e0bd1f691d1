#include "lib/check/verdict.h"

#include <array>

namespace gouge {

const char* state_name(MoveState state) {
  static constexpr std::array<const char*, 6> kNames = {"clean",  "near",        "gouge",
                                                        "buried", "not-checked", "not-certified"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace gouge
