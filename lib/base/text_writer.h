#pragma once

#include <functional>
#include <string_view>

namespace gouge {

/// A function that receives the next part of a text.
using PutText = std::function<void(std::string_view)>;
/// A function that produces a text from its beginning to its end, part by part: the text may be longer than memory.
using TextWriter = std::function<void(const PutText&)>;

}  // namespace gouge
