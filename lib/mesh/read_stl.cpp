#include "lib/mesh/read_stl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/file_kind.h"
#include "lib/base/number_text.h"
#include "lib/mesh/ascii_stl.h"
#include "lib/mesh/binary_stl.h"

namespace gouge {
namespace {

std::string_view without_blanks_before(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

std::string advice_for(const FileKind& kind) {
  switch (kind.family) {
    case FileFamily::solid:
      return "exact geometry without triangles; save the part as STL in the CAD system";
    case FileFamily::mesh:
      return "save it as STL";
    case FileFamily::archive:
      return "unpack it, or save the part as STL";
    case FileFamily::document:
    case FileFamily::text:
      return "expected an STL file";
    case FileFamily::stand_in:
      return std::string(kind.advice);
  }
  return {};
}

std::string described(const FileKind& kind) {
  return "is " + std::string(kind.name) + (kind.family == FileFamily::solid ? ", " : "; ") + advice_for(kind);
}

/// Returns the format of text, as the rest of a sentence that begins with "the file"; nothing if it is not known.
/// Examines only the first lines.
std::optional<std::string> describe_lines(std::string_view text) {
  if (text.starts_with("OFF")) return "is an OFF mesh; save it as STL";
  if (looks_like_cl_data(text)) return "is a toolpath (CL data); expected an STL file";
  constexpr std::array<std::string_view, 2> kObjWords = {"v ", "mtllib "};
  if (begins_a_line(text, kObjWords)) return "is an OBJ mesh; save it as STL";
  return std::nullopt;
}

bool begins_with_word(std::string_view bytes) {
  constexpr std::size_t kWord = 4;
  return std::ranges::all_of(bytes.substr(0, kWord), [](char c) { return c >= ' ' && c <= '~'; });
}

/// Returns the format of a file that is neither an STL by its size nor begins with 'solid', as describe_lines does. The
/// header of a binary STL may hold any words. So words count only if `is_text`, when the first bytes have no control
/// characters, or if the name of the file states a kind.
std::optional<std::string> describe_foreign_mesh(const std::string& name, std::string_view bytes, bool is_text) {
  const std::optional<FileKind> kind = recognise_file(name, bytes);
  const bool is_named = recognise_file(name, {}).has_value();
  if (kind && (is_text || is_named || !begins_with_word(bytes))) return described(*kind);
  return is_text ? describe_lines(without_blanks_before(bytes)) : std::nullopt;
}

bool is_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    return (c >= ' ' && c != '\x7f') || c == '\t' || c == '\n' || c == '\r' || c == '\f' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

bool is_plain_ascii(char c) { return (c >= ' ' && c <= '~') || c == '\t' || c == '\n' || c == '\r'; }

// Returns whether, in the first 16 bytes, the bytes at `first`, `first` + 2, ... are ASCII characters and the others
// are zero.
bool alternates(std::string_view bytes, std::size_t first) {
  constexpr std::size_t kBytesLookedAt = 16;
  if (bytes.size() < kBytesLookedAt) return false;
  for (std::size_t at = 0; at < kBytesLookedAt; at += 2)
    if (!is_plain_ascii(bytes[at + first]) || bytes[at + 1 - first] != '\0') return false;
  return true;
}

// Returns the text of a UTF-16 file; letters outside ASCII, which only names may contain, become '?'. Returns nothing
// for any other file.
std::optional<std::string> ascii_of_utf16(std::string_view bytes) {
  const bool is_big = bytes.starts_with("\xfe\xff") || alternates(bytes, 1);
  const bool is_little = bytes.starts_with("\xff\xfe") || alternates(bytes, 0);
  if (is_big == is_little) return std::nullopt;
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
    const char high = bytes[is_big ? at : at + 1];
    const char low = bytes[is_big ? at + 1 : at];
    const bool is_mark = at == 0 && (high == '\xfe' && low == '\xff');
    if (!is_mark) text += high == '\0' && static_cast<unsigned char>(low) < 0x80 ? low : '?';
  }
  if (bytes.size() % 2 != 0) text += '?';
  return text;
}

Result<TriangleSoup> parse_utf16_stl(std::string_view text, const std::string& name, const ProgressCall& progress) {
  if (!detail::looks_like_ascii_stl(text)) {
    return make_error("stl-not-stl", "the file is UTF-16 text but not ASCII STL; expected it to begin with 'solid'",
                      name);
  }
  Result<TriangleSoup> soup = detail::parse_ascii_stl(text, name, progress);
  if (soup) soup->notes.push_back(make_note("stl-utf16", "the file is UTF-16 text; read as ASCII", name));
  return soup;
}

}  // namespace

Result<TriangleSoup> parse_stl(std::string_view bytes, const std::string& name, std::shared_ptr<const void> keep,
                               const ProgressCall& progress) {
  if (bytes.empty()) {
    return make_error("stl-empty", "the file is empty (0 bytes); expected a binary or ASCII STL", name);
  }
  if (detail::has_binary_stl_size(bytes, bytes.size())) return detail::parse_binary_stl(bytes, name, std::move(keep));
  if (const std::optional<std::string> text = ascii_of_utf16(bytes)) return parse_utf16_stl(*text, name, progress);
  if (detail::looks_like_ascii_stl(bytes)) return detail::parse_ascii_stl(bytes, name, progress);
  const bool is_plain = is_text(bytes.substr(0, 4096));
  if (const auto foreign = describe_foreign_mesh(name, bytes, is_plain))
    return make_error("stl-not-stl", "the file " + *foreign, name);
  if (is_plain) {
    return make_error("stl-not-stl", "the file is text but not ASCII STL; expected it to begin with 'solid'", name);
  }
  if (!detail::has_binary_stl_header(bytes)) {
    return make_error("stl-truncated",
                      "the file has " + count_text(bytes.size(), "byte") +
                          "; a binary STL has at least 84 and an ASCII one begins with 'solid'",
                      name);
  }
  return detail::parse_binary_stl(bytes, name, std::move(keep));
}

bool looks_like_stl(std::string_view beginning, std::uint64_t size) {
  return detail::has_binary_stl_size(beginning, size) || detail::looks_like_ascii_stl(beginning);
}

}  // namespace gouge
