#include "cli/short_line.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <variant>

#include "cli/options/help_text.h"
#include "cli/output/output_file.h"
#include "lib/base/file_kind.h"
#include "lib/base/files.h"
#include "lib/base/input_file.h"
#include "lib/mesh/read_stl.h"
#include "postproc/cldata/reading/foreign_file.h"
#include "postproc/formats/toolpath_format.h"
#include "postproc/report/report_model.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardInput = "-";

// A word with a dot or a slash is the name of a file, not a command that is misspelt.
bool is_file_name(const std::string& word) {
  std::error_code ignored;
  if (word == kStandardInput) return true;
  return !word.starts_with('-') && (word.find_first_of("./") != std::string::npos || fs::exists(word, ignored));
}

/// Unknown: perhaps the toolpath of a dialect without marks.
enum class Role { path, part, tools, unknown };

Result<std::string> read_beginning(const std::string& file) {
  constexpr std::size_t kBeginning = 65536;
  Result<InputReader> reader = InputReader::open(file, kMaxInputBytes);
  if (!reader) return reader.error();
  std::string bytes(kBeginning, '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const Result<std::size_t> count = reader->read(bytes.data() + size, bytes.size() - size);
    if (!count) return count.error();
    if (*count == 0) break;
    size += *count;
  }
  bytes.resize(size);
  return bytes;
}

bool is_tool_library(const std::string& file) {
  constexpr std::uint64_t kMaxLibrary = 10'000'000;
  const Result<ReadTools> tools = read_tools_file(file, kMaxLibrary);
  if (tools) return true;
  const std::string& code = tools.error().code;
  return code != "library-foreign" && code != "input-too-large" && code != "import-zip";
}

/// A file of a kind that no reader accepts, such as a STEP file.
struct ForeignFile {
  std::string name;
  FileKind kind;
  std::string description;  ///< as the reader of toolpaths gives it
};

using FileRole = std::variant<Role, ForeignFile>;

Result<FileRole> role_of(const std::string& file) {
  if (file == kStandardInput) return FileRole(Role::path);
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status))
    return make_error("file-is-folder",
                      "is a folder; expected a toolpath, or gougecheck batch with the toolpaths of a folder", file);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return make_error("usage",
                      "'" + file + "' is a pipe or a device; expected gougecheck check with the option that it is for");
  const Result<std::string> beginning = read_beginning(file);
  if (!beginning) return beginning.error();
  if (beginning->empty())
    return make_error("usage", "'" + file + "' is empty; expected a toolpath, an STL or a tool library");
  if (looks_like_stl(*beginning, fs::file_size(file, ignored)) || has_ending(file, ".stl")) return FileRole(Role::part);
  if (is_tool_library(file)) return FileRole(Role::tools);
  if (!recognise_dialect(*beginning).is_fallback || looks_like_cl_data(*beginning)) return FileRole(Role::path);
  const std::optional<std::string> format = describe_foreign(file, *beginning);
  if (const auto kind = recognise_file(file, *beginning))
    return FileRole(ForeignFile{file, *kind, format.value_or("is no toolpath")});
  if (format) return make_error("path-not-cl-data", *format, file);
  return FileRole(Role::unknown);
}

struct Files {
  std::vector<std::string> paths, parts, libraries, unknown;
  std::vector<ForeignFile> foreign;

  [[nodiscard]] std::vector<std::string>& of(Role role) {
    switch (role) {
      case Role::path:
        return paths;
      case Role::part:
        return parts;
      case Role::tools:
        return libraries;
      case Role::unknown:
        break;
    }
    return unknown;
  }
};

/// Takes foreign files beside a toolpath as the part or the tools that are missing. Their readers then name the kind of
/// the file, with advice.
void assign_foreign(Files& files) {
  if (files.paths.empty()) return;
  for (const ForeignFile& file : std::exchange(files.foreign, {})) {
    const FileFamily family = file.kind.family;
    const bool is_solid = family == FileFamily::solid || family == FileFamily::mesh;
    const bool is_document = family == FileFamily::text || family == FileFamily::document;
    const bool can_be_tools = files.libraries.empty() && !is_solid;
    const bool can_be_part = files.parts.empty();
    const Role role = can_be_tools && (is_document || !can_be_part) ? Role::tools
                      : can_be_part                                 ? Role::part
                                                                    : Role::unknown;
    files.of(role).push_back(file.name);
  }
}

Diagnostic wrong_files(const std::string& message) {
  return make_error("usage", message + "; expected " + kProgramName + " PATH PART.stl [TOOLS] [OPTIONS]");
}

/// Returns the error about files of which none is a toolpath. A foreign file may stand in the place of one.
Diagnostic describe_missing_path(const Files& files) {
  const std::string none = "none of the files is a toolpath";
  if (files.foreign.empty()) return wrong_files(none);
  const auto& [name, kind, description] = files.foreign.front();
  const bool is_alone = files.parts.empty() && files.libraries.empty() && files.foreign.size() == 1;
  return is_alone ? make_error("path-not-cl-data", description, name)
                  : wrong_files(none + ": " + name + " " + description);
}

std::optional<Diagnostic> find_wrong(const Files& files) {
  if (!files.unknown.empty())
    return wrong_files(listed(files.unknown, " and ") + (files.unknown.size() == 1 ? " is" : " are") +
                       " neither a toolpath nor an STL file nor a tool library that is recognised");
  if (files.paths.empty()) return describe_missing_path(files);
  if (files.paths.size() > 1)
    return make_error("usage",
                      listed(files.paths, " and ") + " are toolpaths; expected one, or gougecheck batch with all");
  if (files.parts.size() > 1)
    return make_error("usage", listed(files.parts, " and ") +
                                   " are STL files; expected one, the part, and others with --fixture or --stock");
  if (files.libraries.size() > 1) return wrong_files(listed(files.libraries, " and ") + " are tool libraries");
  return std::nullopt;
}

std::string report_beside(const std::string& path) {
  return (fs::path(path).parent_path() / split_toolpath_name(path).stem).string() + "_report";
}

}  // namespace

Result<std::vector<std::string>> expand_short_line(const std::vector<std::string>& words,
                                                   const std::vector<std::string>& commands) {
  const bool has_command = words.size() < 2 || std::ranges::find(commands, words[1]) != commands.end();
  if (has_command || !is_file_name(words[1])) return words;
  const auto option = std::find_if(words.begin() + 1, words.end(),
                                   [](const std::string& word) { return word.size() > 1 && word.front() == '-'; });
  Files files;
  for (auto word = words.begin() + 1; word != option; ++word) {
    const auto role = role_of(*word);
    if (!role) return role.error();
    if (const auto* foreign = std::get_if<ForeignFile>(&*role))
      files.foreign.push_back(*foreign);
    else
      files.of(std::get<Role>(*role)).push_back(*word);
  }
  // The only candidate is read as a toolpath, with the messages of its reader.
  if (files.paths.empty() && files.unknown.size() == 1) files.paths = std::exchange(files.unknown, {});
  assign_foreign(files);
  if (const auto wrong = find_wrong(files)) return *wrong;
  const std::string& path = files.paths.front();
  std::vector<std::string> made = {words.front(), "check", path};
  for (const std::string& part : files.parts) made.insert(made.end(), {"--part", part});
  for (const std::string& library : files.libraries) made.insert(made.end(), {"--tools", library});
  const bool has_report = std::any_of(
      option, words.end(), [](const std::string& word) { return word == "--report" || word.starts_with("--report="); });
  if (!has_report && path != kStandardInput) made.insert(made.end(), {"--report", report_beside(path)});
  made.insert(made.end(), option, words.end());
  return made;
}

}  // namespace gouge
