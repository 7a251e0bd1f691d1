#pragma once

#include "toolmodels/tool_library.h"

namespace gouge::fuzz {

/// What was read or imported is a library that is written and read back as the same text, and whose tools compile to
/// sound forms, or are refused with a reason. Ends the program where that is not so.
void require_sound(const ToolLibrary& library);

}  // namespace gouge::fuzz
