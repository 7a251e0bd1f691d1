#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>

// Why moves are not checked, with the word and the line that are behind it: "...: CAMERA in line 74".

namespace gouge {

/// The word a statement begins with, as it is reported to the user: in capitals, cut to 24 letters; "(no word)" and
/// "(line of numbers)" where it has none.
[[nodiscard]] std::string word_as_reported(std::string_view major);

class NamedReasons {
 public:
  /// Of each pair of reason and word so many lines are named; texts for further ones name the word alone, so that
  /// a file that repeats a statement has no list of all its lines.
  static constexpr std::size_t kMostLines = 20;

  /// `reason` with the word and the line of its statement (0: the word alone). The text is never freed, as
  /// Move::not_checked_reason requires; equal texts are one text.
  [[nodiscard]] const char* name(std::string_view reason, std::string_view major, std::size_t line = 0);

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> lines_named_;
};

}  // namespace gouge
