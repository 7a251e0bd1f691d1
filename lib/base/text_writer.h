#pragma once

#include <functional>
#include <string_view>

namespace gouge {

/// Takes the next part of a text.
using PutText = std::function<void(std::string_view)>;
/// Gives a text from its beginning to its end, part by part: it may be longer than memory.
using TextWriter = std::function<void(const PutText&)>;

}  // namespace gouge
