#pragma once

#include <string>

#include "cli/options/command_doc.h"

namespace gouge {

/// Returns the manual page of a command (section 1, in the man macros of roff). It has name, synopsis, description,
/// commands, options by group, examples, notes, and see also.
[[nodiscard]] std::string write_man(const CommandDoc& command);

/// Returns "gougecheck-tool-import"; with ".1" this is the name of the page's file.
[[nodiscard]] std::string man_name(const CommandDoc& command);

}  // namespace gouge
