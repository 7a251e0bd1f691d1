#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/base/diagnostic.h"

namespace gouge {

/// Returns the name that begins with `word`, if one alone does and more than a file ending follows. Else it is the one that
/// differs least by letters that are missing, added, wrong or swapped. Of equals it is that with the longest common
/// beginning, then with the most common letters, then the first. Empty where more than two letters differ, or three of a
/// word of more than eight. Cost: the product of the lengths, for each name.
[[nodiscard]] std::string find_similar_name(std::string_view word, const std::vector<std::string>& names);

/// Returns the error file-not-found of `path`. It names the target of a broken link, the folder that does not exist
/// either, or a file in the folder with a similar name. Of equally similar files it is the first by name. Cost: a listing
/// of the folder, at most 10,000 entries of it.
[[nodiscard]] Diagnostic describe_missing_file(const std::string& path);

}  // namespace gouge
