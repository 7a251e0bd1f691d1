#include "lib/mesh/read_stl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/number_text.h"
#include "lib/mesh/ascii_stl.h"

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

// Words that CL data begins lines with, as any dialect writes them.
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

/// What `bytes` are, as the rest of a sentence that begins with "the file" ("is STEP, ..."), where they are certainly
/// no STL but something that people take for a mesh. Nothing for anything else: the header of a binary STL may hold any
/// words, so only `is_text`, no control characters at the beginning, lets words count. Looks at the first lines only.
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

constexpr std::size_t kHeaderSize = 84;
constexpr std::size_t kTriangleSize = TriangleList::kRecordSize;

bool is_text(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) {
    return (c >= ' ' && c != '\x7f') || c == '\t' || c == '\n' || c == '\r' || c == '\f' ||
           static_cast<unsigned char>(c) >= 0x80;
  });
}

// Anything wrong with the size of a binary file: the error, or a note about tolerated bytes.
Outcome check_size(std::string_view bytes, TriangleSoup& soup) {
  const std::size_t stated = TriangleList::word_at(bytes, 80);
  const std::size_t body = bytes.size() - kHeaderSize;
  if (stated == 0 && body < kTriangleSize) {
    return make_error("stl-no-triangles", "the binary STL holds no triangle; expected at least one", soup.name);
  }
  if (body / kTriangleSize < stated) {
    return make_error("stl-truncated",
                      "the header states " + count_text(stated, "triangle") + " (" +
                          std::to_string(kHeaderSize + kTriangleSize * stated) + " bytes) but the file holds " +
                          std::to_string(body / kTriangleSize) + " whole (" + std::to_string(bytes.size()) +
                          " bytes); it is cut off or not an STL, export or copy it again",
                      soup.name);
  }
  const std::string_view extra = bytes.substr(kHeaderSize + kTriangleSize * stated);
  if (extra.empty()) return Done{};
  const bool is_padding = std::all_of(extra.begin(), extra.end(), [](char c) { return c == '\0'; });
  if (extra.size() >= kTriangleSize && !is_padding) {
    return make_error("stl-trailing-data",
                      "the header states " + count_text(stated, "triangle") + " but " +
                          count_text(extra.size(), "byte") +
                          " follow them; expected the file to end there, export it again",
                      soup.name);
  }
  soup.notes.push_back(make_note("stl-trailing-bytes",
                                 count_text(extra.size(), "byte") + " after the last triangle ignored", soup.name));
  return Done{};
}

Result<TriangleSoup> parse_binary_stl(std::string_view bytes, const std::string& name,
                                      std::shared_ptr<const void> keep) {
  TriangleSoup soup;
  soup.name = name;
  soup.format = StlFormat::binary;
  if (const Outcome size = check_size(bytes, soup); !size) return size.error();
  const std::size_t count = TriangleList::word_at(bytes, 80);
  soup.triangles = TriangleList(bytes.substr(kHeaderSize, kTriangleSize * count), std::move(keep));
  for (std::size_t i = 0; i < count; ++i) {
    const TrianglePoints triangle = soup.triangles[i];
    const auto& [a, b, c] = triangle;
    if (!a.allFinite() || !b.allFinite() || !c.allFinite()) {
      return make_error("stl-bad-number",
                        "triangle " + std::to_string(i + 1) + " of " + std::to_string(count) +
                            " has a coordinate that is infinite or not a number; expected finite coordinates",
                        name);
    }
    detail::count_normal(soup, i, triangle, TriangleList::vector_at(bytes, kHeaderSize + kTriangleSize * i));
  }
  return soup;
}

}  // namespace

Result<TriangleSoup> parse_stl(std::string_view bytes, const std::string& name, std::shared_ptr<const void> keep,
                               const ProgressCall& progress) {
  if (bytes.empty()) {
    return make_error("stl-empty", "the file is empty (0 bytes); expected a binary or ASCII STL", name);
  }
  const bool has_header = bytes.size() >= kHeaderSize;
  if (has_header && bytes.size() == kHeaderSize + kTriangleSize * TriangleList::word_at(bytes, 80)) {
    return parse_binary_stl(bytes, name, std::move(keep));
  }
  if (detail::looks_like_ascii_stl(bytes)) return detail::parse_ascii_stl(bytes, name, progress);
  const bool is_plain = is_text(bytes.substr(0, 4096));
  if (const auto foreign = describe_foreign_mesh(bytes, is_plain))
    return make_error("stl-not-stl", "the file " + *foreign, name);
  if (is_plain) {
    return make_error("stl-not-stl", "the file is text but not ASCII STL; expected it to begin with 'solid'", name);
  }
  if (!has_header) {
    return make_error("stl-truncated",
                      "the file has " + count_text(bytes.size(), "byte") +
                          "; a binary STL has at least 84 and an ASCII one begins with 'solid'",
                      name);
  }
  return parse_binary_stl(bytes, name, std::move(keep));
}

}  // namespace gouge
