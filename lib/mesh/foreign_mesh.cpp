#include "lib/mesh/foreign_mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>

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

}  // namespace

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

}  // namespace gouge
