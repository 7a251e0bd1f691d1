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
#include "postproc/formats/read_toolpath.h"
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

enum class Role { path, part, tools };

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

/// A file whose content states no role: a STEP file, an empty file, the toolpath of a dialect without marks.
struct DoubtfulFile {
  std::string name;
  std::optional<FileFamily> family;      ///< none: the kind is not known
  std::optional<Diagnostic> path_error;  ///< error of the reader of toolpaths; none: it may be a toolpath
};

using FileRole = std::variant<Role, DoubtfulFile>;

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
  if (looks_like_stl(*beginning, fs::file_size(file, ignored)) || has_ending(file, ".stl")) return FileRole(Role::part);
  if (beginning->empty()) {
    const ReadOutcome read = read_toolpath(file, SourceText(std::string()));
    const bool is_table = has_ending(file, ".json");
    return FileRole(DoubtfulFile{file, is_table ? std::optional(FileFamily::text) : std::nullopt, read.errors.front()});
  }
  if (is_tool_library(file)) return FileRole(Role::tools);
  if (!recognise_dialect(*beginning).is_fallback || looks_like_cl_data(*beginning)) return FileRole(Role::path);
  const std::optional<std::string> format = describe_foreign(file, *beginning);
  if (const auto kind = recognise_file(file, *beginning))
    return FileRole(
        DoubtfulFile{file, kind->family, make_error("path-not-cl-data", format.value_or("is no toolpath"), file)});
  if (format) return make_error("path-not-cl-data", *format, file);
  return FileRole(DoubtfulFile{file, std::nullopt, std::nullopt});
}

struct Files {
  std::vector<std::string> paths, parts, libraries;
  std::vector<DoubtfulFile> doubtful;
  std::optional<Diagnostic> path_error;  ///< of the toolpath; none: it has not been found wrong

  [[nodiscard]] std::vector<std::string>& of(Role role) {
    return role == Role::path ? paths : role == Role::part ? parts : libraries;
  }
};

bool is_geometry(const DoubtfulFile& file) {
  return file.family == FileFamily::solid || file.family == FileFamily::mesh;
}

bool is_document(const DoubtfulFile& file) {
  return file.family == FileFamily::text || file.family == FileFamily::document;
}

using Place = std::vector<DoubtfulFile>::iterator;

/// Takes a doubtful file as the one that is missing in a role, so that its reader names the fault of the file.
void assign(Files& files, Place chosen, Role role) {
  files.of(role).push_back(chosen->name);
  files.doubtful.erase(chosen);
}

void assign_path(Files& files) {
  if (!files.paths.empty() || files.doubtful.empty()) return;
  Place chosen = std::ranges::find_if_not(files.doubtful, is_geometry);
  if (chosen == files.doubtful.end()) chosen = files.doubtful.begin();
  files.path_error = chosen->path_error;
  assign(files, chosen, Role::path);
}

void assign_part(Files& files) {
  if (!files.parts.empty() || files.doubtful.empty()) return;
  Place chosen = std::ranges::find_if(files.doubtful, is_geometry);
  if (chosen == files.doubtful.end()) chosen = std::ranges::find_if_not(files.doubtful, is_document);
  assign(files, chosen == files.doubtful.end() ? files.doubtful.begin() : chosen, Role::part);
}

void assign_tools(Files& files) {
  if (!files.libraries.empty()) return;
  const Place chosen = std::ranges::find_if_not(files.doubtful, is_geometry);
  if (chosen != files.doubtful.end()) assign(files, chosen, Role::tools);
}

Diagnostic wrong_files(const std::string& message) {
  return make_error("usage", message + "; expected " + kProgramName + " PATH PART.stl [TOOLS] [OPTIONS]");
}

/// Returns the error about files that have no role, once the doubtful ones were assigned.
std::optional<Diagnostic> find_wrong(const Files& files) {
  if (files.paths.empty()) return wrong_files("none of the files is a toolpath");
  if (!files.doubtful.empty())
    return make_error("file-unrecognised",
                      "is neither a toolpath nor an STL file nor a tool library that is recognised; expected " +
                          std::string(kProgramName) + " PATH PART.stl [TOOLS] [OPTIONS]",
                      files.doubtful.front().name);
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

using Words = std::vector<std::string>;

bool is_given(const std::string& name, Words::const_iterator option, const Words& words) {
  return std::any_of(option, words.end(),
                     [&](const std::string& word) { return word == name || word.starts_with(name + "="); });
}

/// Returns the words of the command `check` for these files. `option` is the first word that names none.
Words words_for(const Files& files, Words::const_iterator option, const Words& words) {
  Words made = {words.front(), "check"};
  if (!files.paths.empty()) made.push_back(files.paths.front());
  for (const std::string& part : files.parts) made.insert(made.end(), {"--part", part});
  for (const DoubtfulFile& file : files.doubtful) made.insert(made.end(), {"--part", file.name});
  for (const std::string& library : files.libraries) made.insert(made.end(), {"--tools", library});
  if (!is_given("--report", option, words) && !files.paths.empty() && files.paths.front() != kStandardInput)
    made.insert(made.end(), {"--report", report_beside(files.paths.front())});
  made.insert(made.end(), option, words.end());
  return made;
}

}  // namespace

ShortLine expand_short_line(const Words& words, const Words& commands) {
  const bool has_command = words.size() < 2 || std::ranges::find(commands, words[1]) != commands.end();
  if (has_command || !is_file_name(words[1])) return {words, std::nullopt};
  const auto option = std::find_if(words.begin() + 1, words.end(),
                                   [](const std::string& word) { return word.size() > 1 && word.front() == '-'; });
  Files files;
  std::optional<Diagnostic> error;
  for (auto word = words.begin() + 1; word != option; ++word) {
    const Result<FileRole> role = role_of(*word);
    if (!role && !error) error = role.error();
    if (!role)
      files.doubtful.push_back({*word, std::nullopt, std::nullopt});
    else if (const auto* doubtful = std::get_if<DoubtfulFile>(&*role))
      files.doubtful.push_back(*doubtful);
    else
      files.of(std::get<Role>(*role)).push_back(*word);
  }
  assign_path(files);
  if (!is_given("--part", option, words)) assign_part(files);
  // Without a part, the command line would be refused before a reader could state this.
  if (!error && files.parts.empty()) error = files.path_error;
  assign_tools(files);
  if (!error) error = find_wrong(files);
  return {words_for(files, option, words), error};
}

}  // namespace gouge
