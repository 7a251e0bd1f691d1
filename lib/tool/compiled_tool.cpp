#include "lib/tool/compiled_tool.h"

namespace gouge {

const char* body_name(Body body) {
  switch (body) {
    case Body::cutter:
      return "cutter";
    case Body::shank:
      return "shank";
    case Body::holder:
      return "holder";
    case Body::head:
      break;
  }
  return "head";
}

}  // namespace gouge
