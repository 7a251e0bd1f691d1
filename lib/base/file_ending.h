#pragma once

#include <algorithm>
#include <string_view>

namespace gouge {

/// Whether a file's name has something before `ending` and then that, in any case. `ending`: in small letters, with its dot.
[[nodiscard]] inline bool has_ending(std::string_view file, std::string_view ending) {
  return file.size() > ending.size() && std::equal(ending.rbegin(), ending.rend(), file.rbegin(), [](char e, char f) {
           return e == (f >= 'A' && f <= 'Z' ? static_cast<char>(f - 'A' + 'a') : f);
         });
}

}  // namespace gouge
