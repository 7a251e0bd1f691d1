#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

// Just enough reading of C++ and CMake text for the rules of the house.

namespace gouge::architecture {

struct SourceFile {
  std::string path;  ///< from the repository's root, with forward slashes
  std::string text;
};

struct Include {
  std::size_t line = 0;
  std::string target;  ///< between the quotes or brackets
  bool is_quoted = false;
};

/// One gouge_module(...) call.
struct Module {
  std::string path;
  std::vector<std::string> imports;
  std::vector<std::string> closed;  ///< headers that only the modules of `closed_for` may include besides itself
  std::vector<std::string> closed_for;
};

[[nodiscard]] std::vector<std::string> lines_of(std::string_view text);

/// The text with comments and the contents of string and character literals blanked; line ends stay.
[[nodiscard]] std::string without_comments_and_literals(std::string_view text);

[[nodiscard]] std::vector<Include> includes_of(std::string_view text);

/// Returns whether `word` stands in `text` as a whole identifier (a leading "std::" in `word` included).
[[nodiscard]] bool has_word(std::string_view text, std::string_view word);

/// String literals that have the form of a message code: "stl-empty", "path-number", ... (kinds listed in the
/// source).
[[nodiscard]] std::set<std::string> message_codes_of(std::string_view text);

/// The first cells of the rows of a document's tables, in back quotes, that have the form of a message code.
[[nodiscard]] std::set<std::string> documented_codes_of(std::string_view markdown);

/// Targets of the links and pictures of a Markdown text that lead to files: no addresses, no anchors.
[[nodiscard]] std::vector<std::string> file_links_of(std::string_view markdown);

/// Words in back quotes that have the form of a path below one of the repository's folders.
[[nodiscard]] std::vector<std::string> quoted_paths_of(std::string_view markdown);

[[nodiscard]] std::vector<Module> modules_of(std::string_view cmake_text);

}  // namespace gouge::architecture
