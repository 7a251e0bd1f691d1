#include "tests/support/source_folder.h"

namespace gouge {

std::string source_folder() { return GOUGE_SOURCE_DIR; }

}  // namespace gouge
