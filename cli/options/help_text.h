#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/word_list.h"

namespace CLI {
class FormatterBase;
}

namespace gouge {

/// `text` in lines of at most `width` characters, broken at blanks, each but the first after `indent` blanks, which
/// count. Line breaks of the text stay, and lines that begin with a blank are examples and stay as they are.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// Lays out --help in 80 columns, whatever the length of the texts.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> make_help_formatter();

}  // namespace gouge
