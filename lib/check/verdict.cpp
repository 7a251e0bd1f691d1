#include "lib/check/verdict.h"

namespace gouge {

const char* state_name(MoveState state) {
  switch (state) {
    case MoveState::clean:
      return "clean";
    case MoveState::near_miss:
      return "near";
    case MoveState::gouge:
      return "gouge";
    case MoveState::buried:
      return "buried";
    case MoveState::not_checked:
      return "not-checked";
    case MoveState::not_certified:
      break;
  }
  return "not-certified";
}

const char* against_name(Against against) { return against == Against::part ? "part" : "fixture"; }

}  // namespace gouge
