#include "toolmodels/import/read_any_tools.h"

#include <zip.h>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "lib/base/file_kind.h"
#include "lib/base/files.h"
#include "toolmodels/import/json_entry.h"

namespace gouge {

namespace {

constexpr const char* kExpected =
    "expected a tool library of gougecheck (JSON), Fusion (.json or .tools), FreeCAD (.fctl or .fctb), NX "
    "(tool_database.dat), CAMotics (.json) or LinuxCNC (.tbl)";

// Returns whether JSON is a library of this project: it has "tools", each with a "cutter", or it has "units".
bool is_ours(const nlohmann::json& root) {
  if (!root.is_object()) return false;
  if (root.contains("units")) return true;
  const auto tools = root.find("tools");
  if (tools == root.end() || !tools->is_array()) return false;
  return tools->empty() || std::any_of(tools->begin(), tools->end(), [](const nlohmann::json& tool) {
           return tool.is_object() && tool.contains("cutter");
         });
}

std::string with_remedy(const Diagnostic& diagnostic, const std::string& file) {
  const bool needs_option = diagnostic.message.find("--stickout") != std::string::npos ||
                            diagnostic.message.find("--unit") != std::string::npos;
  return diagnostic.message + (needs_option ? " to gougecheck tool import " + file + " -o LIB.json" : "");
}

Result<ReadTools> read_imported(const std::string& file, std::string_view bytes, ImportFormat format,
                                std::uint64_t max_bytes, SearchLog& searches, ImportOptions options) {
  ReadTools read;
  options.read_beside = [&](const std::string& name) -> Result<std::string> {
    Result<BesideFile> beside = read_beside(file, name, max_bytes, searches);
    if (!beside) return beside.error();
    read.besides.push_back(std::move(*beside));
    return read.besides.back().bytes;
  };
  Result<ImportedTools> made = import_tools(file, bytes, format, options);
  if (!made) {
    Diagnostic error = made.error();
    error.message = with_remedy(error, file);
    return error;
  }
  read.library = std::move(made->library);
  if (read.library.tools.empty()) {
    const auto first = std::ranges::find(made->notes, Severity::error, &Diagnostic::severity);
    const std::string reason =
        first == made->notes.end() || first->code == "import-empty" ? std::string() : ": " + with_remedy(*first, file);
    return make_error("library-empty", "no tool of this file can be used" + reason, file);
  }
  for (Diagnostic& note : made->notes) {
    note.message = with_remedy(note, file);
    if (note.severity == Severity::error) {
      note.severity = Severity::warning;
      note.message += "; it is left out";
    }
    read.library.notes.push_back(std::move(note));
  }
  return read;
}

}  // namespace

std::string describe_foreign_library(const std::string& file, std::string_view bytes) {
  if (detail::without_mark(bytes).empty()) return std::string("the file is empty; ") + kExpected;
  const std::string expected = std::string("; ") + kExpected;
  if (detail::is_json(bytes)) return "the JSON in this file is no tool library" + expected;
  if (bytes.starts_with("solid")) return "the file is a mesh (STL)" + expected;
  if (looks_like_cl_data(bytes)) return "the file is a toolpath (CL data)" + expected;
  const std::optional<FileKind> kind = recognise_file(file, bytes);
  if (!kind) return "the file is no tool library" + expected;
  const std::string is = "the file is " + std::string(kind->name);
  if (kind->family == FileFamily::stand_in) return is + "; " + std::string(kind->advice);
  return is + expected + ", so export the tools as one of these";
}

Result<ReadTools> read_any_tools(const std::string& file, std::string_view bytes, std::uint64_t max_bytes,
                                 SearchLog& searches, const ImportOptions& facts) {
  if (const std::optional<ImportFormat> format = recognise_format(bytes))
    return read_imported(file, bytes, *format, max_bytes, searches, facts);
  if (!detail::is_json(bytes)) return make_error("library-foreign", describe_foreign_library(file, bytes), file);
  const Result<JsonFile> json = parse_json(file, bytes, {"library-syntax", "library-duplicate-key", "a tool library"});
  if (json && !is_ours(json->root)) return make_error("library-foreign", describe_foreign_library(file, bytes), file);
  Result<ToolLibrary> library = read_tool_library(file, bytes);
  if (!library) return library.error();
  return ReadTools{std::move(*library), {}};
}

Result<ReadTools> read_tools_file(const std::string& file, std::uint64_t max_bytes) {
  const Result<std::string> bytes = read_file(file, max_bytes);
  if (!bytes) return bytes.error();
  SearchLog unused;
  return read_any_tools(file, *bytes, max_bytes, unused);
}

namespace {

constexpr std::size_t kLargest = std::size_t{256} << 20;

struct CloseArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

using Archive = std::unique_ptr<zip_t, CloseArchive>;

Diagnostic zip_error(const std::string& file, const std::string& what) { return make_error("import-zip", what, file); }

Archive open_archive(std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  return Archive(archive);
}

}  // namespace

bool is_zip(std::string_view bytes) { return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06"); }

Result<std::string> unzip_first(const std::string& file, std::string_view bytes, std::string_view ending) {
  const Archive archive = open_archive(bytes);
  if (!archive) return zip_error(file, "this zip archive is damaged; expected a tool library in it");
  const zip_int64_t entries = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < entries; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* name = zip_get_name(archive.get(), index, ZIP_FL_ENC_RAW);
    if (name == nullptr || !std::string_view(name).ends_with(ending)) continue;
    const std::unique_ptr<zip_file_t, CloseFile> entry(zip_fopen_index(archive.get(), index, 0));
    if (!entry) return zip_error(file, "the library in this zip archive cannot be opened; it may be encrypted");
    std::string content;
    std::array<char, 65536> block{};
    zip_int64_t got = 0;
    while ((got = zip_fread(entry.get(), block.data(), block.size())) > 0) {
      content.append(block.data(), static_cast<std::size_t>(got));
      if (content.size() > kLargest)
        return zip_error(file, "the library in this zip archive is larger than 256 MB; expected a tool library");
    }
    if (got < 0) return zip_error(file, "the library in this zip archive is damaged");
    return content;
  }
  return zip_error(file, "this zip archive holds no file whose name ends in " + std::string(ending) +
                             "; expected a tool library in it");
}

}  // namespace gouge
