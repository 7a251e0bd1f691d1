#include "lib/path/toolpath.h"

namespace gouge {

const char* kind_name(MoveKind kind) {
  switch (kind) {
    case MoveKind::feed:
      return "feed";
    case MoveKind::rapid:
      return "rapid";
    case MoveKind::arc:
      return "arc";
    case MoveKind::cycle:
      break;
  }
  return "cycle";
}

}  // namespace gouge
