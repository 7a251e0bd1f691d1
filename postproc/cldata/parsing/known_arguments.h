#pragma once

#include <span>

#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/words.h"

namespace gouge {

/// True where the reader of `word` knows every argument, or looks at all of them itself. Text in single quotes is a
/// name. One that is not known may change what the statement means, or belong to a statement that was joined to it.
[[nodiscard]] bool are_known_arguments(Word word, std::span<const Argument> arguments);

}  // namespace gouge
