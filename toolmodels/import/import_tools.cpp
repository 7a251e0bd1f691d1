#include "toolmodels/import/import_tools.h"

#include "lib/base/file_kind.h"
#include "toolmodels/import/json_entry.h"
#include "toolmodels/import/quantity.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {
namespace {

// Returns whether a line of the text begins as the first class of an NX library. A holder_database.dat may begin with a
// FORMAT before any class.
bool has_class_line(std::string_view text) {
  for (const std::string_view word : {"#CLASS", "FORMAT LIBRF"}) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1))
      if (at == 0 || text[at - 1] == '\n') return true;
  }
  return false;
}

std::optional<ImportFormat> format_of(const nlohmann::json& root) {
  if (detail::is_fusion_library(root)) return ImportFormat::fusion;
  if (detail::is_freecad_bit(root)) return ImportFormat::freecad;
  // Our own library also has "tools", but it always has "units" too.
  if (detail::is_freecad_library(root) && !root.contains("units")) return ImportFormat::freecad;
  if (detail::is_camotics_table(root)) return ImportFormat::camotics;
  return std::nullopt;
}

JsonKind any_library() { return detail::imported_kind("a tool library of Fusion or FreeCAD"); }

}  // namespace

std::optional<ImportFormat> recognise_format(std::string_view bytes) {
  bytes = without_byte_order_mark(bytes);
  if (is_zip(bytes)) return ImportFormat::fusion;
  if (!detail::is_json(bytes) && is_linuxcnc_table(bytes)) return ImportFormat::linuxcnc;
  if (!detail::is_json(bytes)) return has_class_line(bytes) ? std::optional(ImportFormat::nx) : std::nullopt;
  const Result<JsonFile> json = parse_json({}, bytes, any_library());
  return json ? format_of(json->root) : std::nullopt;
}

namespace {

bool is_own_library(const nlohmann::json& root) {
  const auto is_tool = [](const nlohmann::json& one) { return one.is_object() && one.contains("cutter"); };
  return root.is_object() && root.contains("tools") && root.at("tools").is_array() &&
         std::ranges::any_of(root.at("tools"), is_tool);
}

}  // namespace

Result<ImportedTools> import_tools(const std::string& file, std::string_view bytes, std::optional<ImportFormat> format,
                                   const ImportOptions& options) {
  bytes = without_byte_order_mark(bytes);
  if (!format) format = recognise_format(bytes);
  if (!format && detail::is_json(bytes)) {
    const Result<JsonFile> json = parse_json(file, bytes, any_library());
    if (!json) return json.error();
    if (is_own_library(json->root))
      return make_error("import-format", "is a tool library of gougecheck already; give it with --tools", file);
  }
  if (!format)
    return make_error("import-format",
                      describe_foreign_library(file, bytes) + "; if it is one of these, say which with --format", file);
  switch (*format) {
    case ImportFormat::fusion:
      return import_fusion(file, bytes, options);
    case ImportFormat::freecad:
      return import_freecad(file, bytes, options);
    case ImportFormat::camotics:
      return import_camotics(file, bytes, options);
    case ImportFormat::linuxcnc:
      return import_linuxcnc(file, bytes, options);
    case ImportFormat::nx:
      break;
  }
  return import_nx(file, bytes, options);
}

}  // namespace gouge
