#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

// Kinds of files that users give in place of a part, a toolpath or a tool library. Readers name them in their errors.

namespace gouge {

/// Byte order mark that some editors write before UTF-8 text; it is not part of the text.
inline constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Returns the text without a byte order mark before it.
[[nodiscard]] constexpr std::string_view without_byte_order_mark(std::string_view text) {
  return text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
}

enum class FileFamily : std::uint8_t {
  solid,     ///< exact geometry of a CAD system
  mesh,      ///< triangles in a format other than STL
  archive,   ///< holds other files
  document,  ///< a picture, a text document, a database
  text,      ///< structured text: JSON, XML, HTML
  stand_in   ///< holds nothing of the file whose name it has; `advice` states how to get that file
};

struct FileKind {
  std::string_view name;  ///< with its article: "a STEP file"
  FileFamily family = FileFamily::document;
  std::string_view advice = {};  ///< what to do, where it is the same for every reader; empty: the reader states it
};

/// Returns the kind of a file by its first bytes, or by its name if they do not state it, such as bracket.CATPart. Returns
/// nothing for STL, toolpaths, tool libraries of this project, and kinds that are not known. Examines at most the first
/// 100 bytes.
[[nodiscard]] std::optional<FileKind> recognise_file(std::string_view path, std::string_view bytes);

/// Describes a file of the family stand_in for an error: "is NAME; ADVICE". Empty for any other file.
[[nodiscard]] std::string describe_stand_in(std::string_view path, std::string_view bytes);

/// Returns whether one of the words begins one of the first 50 lines, behind blanks.
[[nodiscard]] bool begins_a_line(std::string_view text, std::span<const std::string_view> words);

/// Returns whether text is CL data, by a word that begins one of its first lines.
[[nodiscard]] bool looks_like_cl_data(std::string_view text);

}  // namespace gouge
