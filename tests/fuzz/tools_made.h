#pragma once

#include "toolmodels/tool_library.h"

namespace gouge::fuzz {

/// A library that was read or imported is written and read back as the same text, and its tools compile to
/// sound forms, or are refused with a reason. Ends the program where that is not so.
void require_sound(const ToolLibrary& library);

}  // namespace gouge::fuzz
