#include "lib/mesh/read_stl.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/mesh/ascii_stl.h"
#include "lib/mesh/binary_stl.h"

namespace gouge {
namespace {

constexpr std::size_t kLinesLookedAt = 50;

struct Beginning {
  std::string_view text, sentence;
};

constexpr std::array<Beginning, 5> kBinaries = {{
    {"PK\x03\x04", "is a ZIP archive (3MF is one too); unpack it, or save the part as STL"},
    {"\x89PNG", "is a picture (PNG); expected an STL file"},
    {"\xff\xd8\xff", "is a picture (JPEG); expected an STL file"},
    {"%PDF", "is a PDF document; expected an STL file"},
    {"\x1f\x8b", "is compressed (gzip); unpack it first"},
}};

constexpr std::array<Beginning, 5> kTexts = {{
    {"ISO-10303-21", "is STEP, exact geometry without triangles; save the part as STL in the CAD system"},
    {"ply", "is a PLY mesh; save it as STL"},
    {"OFF", "is an OFF mesh; save it as STL"},
    {"<?xml", "is XML; expected an STL file"},
    {"{", "is JSON; expected an STL file"},
}};

// Words that begin lines of CL data in any dialect.
constexpr std::array<std::string_view, 7> kPathWords = {"GOTO",   "TOOL PATH/", "PARTNO", "LOADTL",
                                                        "CUTTER", "MULTAX",     "UNITS"};

constexpr std::array<std::string_view, 2> kObjWords = {"v ", "mtllib "};

std::string_view without_blanks_before(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

template <std::size_t n>
bool begins_with_one(std::string_view line, const std::array<std::string_view, n>& words) {
  for (const std::string_view word : words) {
    if (line.starts_with(word)) return true;
  }
  return false;
}

/// Returns the format of `bytes`, as the rest of a sentence that begins with "the file" ("is STEP, ..."). Returns a
/// name only if the bytes certainly are another format that users mistake for STL; else nothing. The header of a binary
/// STL may hold any words. So words are tested only if `is_text`: the first bytes have no control characters. Examines
/// only the first lines.
std::optional<std::string> describe_foreign_mesh(std::string_view bytes, bool is_text) {
  for (const Beginning& beginning : kBinaries) {
    if (bytes.starts_with(beginning.text)) return std::string(beginning.sentence);
  }
  if (!is_text) return std::nullopt;
  const std::string_view text = without_blanks_before(bytes);
  for (const Beginning& beginning : kTexts) {
    if (text.starts_with(beginning.text)) return std::string(beginning.sentence);
  }
  for (std::size_t at = 0, lines = 0; at < text.size() && lines < kLinesLookedAt; ++lines) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = without_blanks_before(text.substr(at, end - at));
    at = end + 1;
    if (begins_with_one(line, kPathWords)) return "is a toolpath (CL data); expected an STL file";
    if (begins_with_one(line, kObjWords)) return "is an OBJ mesh; save it as STL";
  }
  return std::nullopt;
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
  if (detail::has_binary_stl_size(bytes)) return detail::parse_binary_stl(bytes, name, std::move(keep));
  if (const std::optional<std::string> text = ascii_of_utf16(bytes)) return parse_utf16_stl(*text, name, progress);
  if (detail::looks_like_ascii_stl(bytes)) return detail::parse_ascii_stl(bytes, name, progress);
  const bool is_plain = is_text(bytes.substr(0, 4096));
  if (const auto foreign = describe_foreign_mesh(bytes, is_plain))
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

}  // namespace gouge
