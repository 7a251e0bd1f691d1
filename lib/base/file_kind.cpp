#include "lib/base/file_kind.h"

#include <algorithm>
#include <array>

#include "lib/base/files.h"
#include "lib/base/letters.h"

namespace gouge {
namespace {

using enum FileFamily;

constexpr std::string_view kUnpack = "unpack it first", kSaveAsAscii = "save it as ASCII or UTF-8";

struct KnownBeginning {
  std::string_view text;
  FileKind kind;
};

constexpr FileKind kStep{"a STEP file", solid}, kIges{"an IGES file", solid}, kCatia{"a CATIA part", solid},
    kParasolid{"a Parasolid file", solid}, kAcis{"an ACIS file", solid}, kJt{"a JT file", solid},
    kCreoOrNx{"a part of NX or Creo", solid}, kSolidworks{"a SolidWorks part", solid},
    kInventor{"an Inventor part", solid}, kSolidEdge{"a Solid Edge part", solid}, kFusion{"a Fusion design", solid},
    kFreeCad{"a FreeCAD document", solid}, kDwg{"a drawing (DWG)", solid}, kDxf{"a drawing (DXF)", solid},
    kRhino{"a Rhino model", solid}, kCompound{"a compound file, as of SolidWorks, Inventor or old Office", solid},
    kPly{"a PLY mesh", mesh}, kOff{"an OFF mesh", mesh}, kObj{"an OBJ mesh", mesh}, kGltf{"a glTF mesh", mesh},
    k3mf{"a 3MF mesh", mesh}, kZip{"a ZIP archive", archive}, kRar{"a RAR archive", archive},
    kMac{"a property file of macOS, not the file itself", stand_in, "give the file without ._ before its name"},
    kPointer{"a pointer of Git LFS, not the file itself", stand_in, "get the file with 'git lfs pull'"};

constexpr auto kBeginnings = std::to_array<KnownBeginning>({
    {"version https://git-lfs.github.com/", kPointer},
    {{"\x00\x05\x16\x07", 4}, kMac},
    {{"\x00\x05\x16\x00", 4}, kMac},
    {"ISO-10303-21", kStep},
    {"V5_CFV2", kCatia},
    {"SPLMSSTR", {"an NX part", solid}},
    {"#UGC:2", {"a Creo part", solid}},
    {"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", kParasolid},
    {{"PS\x00\x00", 4}, kParasolid},
    {"3D Geometry File Format", kRhino},
    {"AC10", kDwg},
    {"\xd0\xcf\x11\xe0", kCompound},
    {"glTF", kGltf},
    {"ply\n", kPly},
    {"ply\r", kPly},
    {"PK\x03\x04", kZip},
    {"PK\x05\x06", kZip},
    {"Rar!", kRar},
    {"7z\xbc\xaf", {"a 7z archive", archive}},
    {"\x1f\x8b", {"a compressed file (gzip)", stand_in, kUnpack}},
    {"BZh", {"a compressed file (bzip2)", stand_in, kUnpack}},
    {"\xfd"
     "7zXZ",
     {"a compressed file (xz)", stand_in, kUnpack}},
    {"\x28\xb5\x2f\xfd", {"a compressed file (zstd)", stand_in, kUnpack}},
    {"\xff\xfe", {"UTF-16 text", stand_in, kSaveAsAscii}},
    {"\xfe\xff", {"UTF-16 text", stand_in, kSaveAsAscii}},
    {"%PDF", {"a PDF document", document}},
    {"{\\rtf", {"an RTF document", document}},
    {"\x89PNG", {"a picture (PNG)", document}},
    {"\xff\xd8\xff", {"a picture (JPEG)", document}},
    {"GIF8", {"a picture (GIF)", document}},
    {"SQLite format 3", {"a database (SQLite)", document}},
    {"\x7f"
     "ELF",
     {"a program (ELF)", document}},
    {"MZ\x90", {"a program of Windows", document}},
    {"<!DOCTYPE html", {"a web page (HTML)", text}},
    {"<html", {"a web page (HTML)", text}},
    {"BEGIN TOOL",
     {"a tool table of Heidenhain, which has lengths and no shapes", stand_in,
      "give it with --tool-lengths, and the shapes with --tools LIB.json"}},
    {"<<<<<<< ", {"a file with conflict markers of git", stand_in, "resolve the conflict, then use it"}},
    {"<", {"XML", text}},
    {"{", {"JSON", text}},
});

struct KnownEnding {
  std::string_view ending;
  FileKind kind;
};

constexpr auto kEndings = std::to_array<KnownEnding>({
    {".step", kStep},         {".stp", kStep},          {".iges", kIges},         {".igs", kIges},
    {".catpart", kCatia},     {".catproduct", kCatia},  {".x_t", kParasolid},     {".x_b", kParasolid},
    {".xmt_txt", kParasolid}, {".sat", kAcis},          {".sab", kAcis},          {".jt", kJt},
    {".prt", kCreoOrNx},      {".sldprt", kSolidworks}, {".sldasm", kSolidworks}, {".ipt", kInventor},
    {".iam", kInventor},      {".par", kSolidEdge},     {".psm", kSolidEdge},     {".f3d", kFusion},
    {".f3z", kFusion},        {".fcstd", kFreeCad},     {".dwg", kDwg},           {".dxf", kDxf},
    {".3dm", kRhino},         {".ply", kPly},           {".off", kOff},           {".obj", kObj},
    {".glb", kGltf},          {".gltf", kGltf},         {".3mf", k3mf},           {".zip", kZip},
    {".rar", kRar},
});

// IGES has cards of 80 columns. Column 73 of the first ones is S, and a number follows.
bool is_iges(std::string_view bytes) {
  constexpr std::size_t kSection = 72, kCard = 80;
  if (bytes.size() < kCard || bytes[kSection] != 'S') return false;
  const std::string_view number = bytes.substr(kSection + 1, kCard - kSection - 1);
  return number.find_first_not_of(" 0") == 6 && number.back() == '1';
}

bool begins_with(std::string_view bytes, std::string_view beginning) {
  return bytes.size() >= beginning.size() && std::equal(beginning.begin(), beginning.end(), bytes.begin(),
                                                        [](char a, char b) { return small(a) == small(b); });
}

std::optional<FileKind> recognise_bytes(std::string_view bytes) {
  if (is_iges(bytes)) return kIges;
  bytes = without_byte_order_mark(bytes);
  const std::string_view text = bytes.substr(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  for (const KnownBeginning& one : kBeginnings)
    if (begins_with(text, one.text)) return one.kind;
  return std::nullopt;
}

std::optional<FileKind> recognise_name(std::string_view path) {
  const std::string_view file = path.substr(path.rfind('/') + 1);
  if (file.starts_with("._")) return kMac;
  for (const KnownEnding& one : kEndings)
    if (has_ending(file, one.ending)) return one.kind;
  // Creo appends a version: bracket.prt.3
  const std::size_t last = file.find_last_not_of("0123456789");
  const bool is_version = last != std::string_view::npos && last + 1 < file.size() && file[last] == '.';
  if (is_version && has_ending(file.substr(0, last), ".prt")) return FileKind{"a Creo part", solid};
  return std::nullopt;
}

}  // namespace

std::optional<FileKind> recognise_file(std::string_view path, std::string_view bytes) {
  const std::optional<FileKind> kind = recognise_bytes(bytes), named = recognise_name(path);
  // The name states which one of several formats in a ZIP archive or a compound file it is.
  const bool is_open = !kind || kind->family == archive || kind->name == kCompound.name;
  return is_open && named ? named : kind;
}

std::string describe_stand_in(std::string_view path, std::string_view bytes) {
  const std::optional<FileKind> kind = recognise_file(path, bytes);
  if (!kind || kind->family != FileFamily::stand_in) return {};
  return "is " + std::string(kind->name) + "; " + std::string(kind->advice);
}

bool begins_a_line(std::string_view text, std::span<const std::string_view> words) {
  constexpr std::size_t kLinesLookedAt = 50;
  for (std::size_t lines = 0; !text.empty() && lines < kLinesLookedAt; ++lines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (std::ranges::any_of(words, [&](std::string_view word) { return line.starts_with(word); })) return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool looks_like_cl_data(std::string_view text) {
  constexpr auto kWords = std::to_array<std::string_view>(
      {"GOTO/", "GOTO /", "TOOL PATH/", "PARTNO", "LOADTL", "CUTTER", "MULTAX", "UNITS"});
  return begins_a_line(text, kWords);
}

}  // namespace gouge
