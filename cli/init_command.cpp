#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <ostream>
#include <span>
#include <string_view>

#include "cli/config_command.h"
#include "cli/options/parse_errors.h"
#include "cli/output/json_text.h"
#include "cli/program.h"
#include "cli/project_use.h"
#include "cli/terminal/print_diagnostics.h"
#include "lib/base/exit_code.h"
#include "lib/base/files.h"
#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "lib/base/printable_text.h"
#include "toolmodels/import/read_any_tools.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

bool has_word(const std::string& name, std::span<const char* const> words) {
  return std::ranges::any_of(words,
                             [&](const char* word) { return in_small_letters(name).find(word) != std::string::npos; });
}

/// The inputs in the working directory, recognised by the names of the files.
struct Folder {
  std::vector<std::string> parts, fixtures, heads, libraries, unclear;
};

// Words of names of files, in the languages of CAM users: English, German, French, Italian, Spanish, Portuguese.
constexpr auto kFixtureWords = std::to_array<const char*>(
    {"fixture", "vise",     "vice",  "clamp",   "jig",    "spann",      "vorrichtung", "schraubstock",
     "backe",   "etau",     "bride", "montage", "mors",   "morsa",      "staffa",      "attrezzatura",
     "mordaza", "utillaje", "brida", "garra",   "grampo", "dispositivo"});
constexpr auto kStockWords = std::to_array<const char*>({"stock", "blank", "rohteil", "brut", "grezzo"});
constexpr auto kHeadWords =
    std::to_array<const char*>({"head", "spindle", "spindel", "broche", "mandrino", "husillo", "cabezal", "fuso"});
constexpr auto kPartWords = std::to_array<const char*>({"part", "teil", "werkst", "piece", "pezzo", "pieza", "peca"});

bool is_library(const std::string& name) {
  constexpr std::uint64_t kMaxBytes = 10'000'000;
  return read_tools_file(name, kMaxBytes).has_value();
}

// Chooses the part where no name states it: the only STL file, or the only one with the name of a toolpath.
void choose_part(const std::vector<std::string>& names, const std::vector<std::string>& others, Folder& folder) {
  folder.unclear = others;
  if (!folder.parts.empty()) return;
  constexpr auto kNoToolpaths =
      std::to_array<std::string_view>({".stl", ".json", ".tools", ".fctl", ".png", ".pdf", ".html", ".txt", ".md"});
  std::vector<std::string> called;
  for (const std::string& stl : others) {
    const auto is_toolpath_of_it = [&](const std::string& name) {
      const std::string ending = in_small_letters(fs::path(name).extension().string());
      const bool may_be_path = std::ranges::find(kNoToolpaths, ending) == kNoToolpaths.end();
      return may_be_path && fs::path(name).stem() == fs::path(stl).stem();
    };
    if (std::ranges::any_of(names, is_toolpath_of_it)) called.push_back(stl);
  }
  if (others.size() == 1) called = others;
  if (called.size() != 1) return;
  folder.parts = called;
  std::erase(folder.unclear, called.front());
}

Folder look_around() {
  Folder folder;
  std::vector<std::string> names;
  std::error_code failed;
  for (fs::directory_iterator at(".", failed), end; !failed && at != end; at.increment(failed)) {
    std::error_code ignored;
    if (at->is_regular_file(ignored)) names.push_back(at->path().filename().string());
  }
  std::ranges::sort(names);
  std::vector<std::string> others;
  for (const std::string& name : names) {
    const std::string ending = in_small_letters(fs::path(name).extension().string());
    const bool may_be_library = ending == ".json" || ending == ".tools" || ending == ".fctl";
    if (may_be_library && name != kProjectFileName && is_library(name)) folder.libraries.push_back(name);
    if (ending != ".stl") continue;
    if (has_word(name, kFixtureWords)) {
      folder.fixtures.push_back(name);
    } else if (has_word(name, kHeadWords)) {
      folder.heads.push_back(name);
    } else {
      (has_word(name, kPartWords) && !has_word(name, kStockWords) ? folder.parts : others).push_back(name);
    }
  }
  choose_part(names, others, folder);
  return folder;
}

void put(Json& json, const std::string& key, const std::vector<std::string>& values) {
  if (values.empty() || json.contains(key)) return;
  if (values.size() == 1) {
    json[key] = values.front();
  } else {
    json[key] = values;
  }
}

// Returns the options as typed. Options that a project file must not have cause an error when it is read.
Result<Json> typed_options(const std::vector<std::string>& words) {
  std::vector<std::string> line = {"check"};
  line.insert(line.end(), words.begin(), words.end());
  Program program;
  CLI::App& command = *program.app.get_subcommand("check");
  for (CLI::Option* option : command.get_options()) option->required(false);
  try {
    program.app.parse(std::vector<std::string>(line.rbegin(), line.rend()));
  } catch (const CLI::ParseError& error) {
    return describe_parse_error(program.app, error);
  }
  if (!program.arguments.check.job.path.empty())
    return make_error("usage", "'" + printable(program.arguments.check.job.path) +
                                   "' is one argument too many; init takes options of check alone");
  if (const auto wrong = find_wrong_value(program.arguments.check)) return *wrong;
  Json json = Json::object();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0 || option->get_lnames().empty()) continue;
    const std::string& key = option->get_lnames().front();
    if (option->get_items_expected_max() == 0) {
      json[key] = true;
    } else if (option->get_type_name() == "LENGTH" && parse_number(option->results().front())) {
      json[key] = *parse_number(option->results().front());
    } else {
      put(json, key, option->results());
    }
  }
  return json;
}

// Describes that nothing was found and no option is given. An empty file would only hinder the next attempt.
Diagnostic describe_nothing(const Folder& folder) {
  std::string message =
      "nothing to write: this folder has no part (the only .stl in it, one with the name of a toolpath, or with 'part' in "
      "its name), no fixture ('fixture', 'vise', 'clamp' or 'jig'), no head ('head' or 'spindle') and no single tool library (.json, .tools, "
      ".fctl)";
  if (!folder.unclear.empty()) message += ", and of its .stl files it is unclear which is the part";
  return make_error("init-nothing", message + "; give options of check, such as gougecheck init --part PART.stl");
}

// Names a file that is not there yet. It is no error: the project may be prepared before its files.
void note_missing(const ProjectOption& option, std::ostream& out) {
  constexpr std::string_view kFiles[] = {"part", "fixture", "head", "tools"};
  if (std::ranges::find(kFiles, option.key) == std::end(kFiles)) return;
  const std::string begin = "--" + option.key + "=";
  for (const std::string& word : option.words) {
    const std::string file = word.substr(word.starts_with(begin) ? begin.size() : 0);
    std::error_code ignored;
    const bool is_there = fs::exists(file, ignored) || fs::exists(file.substr(0, file.find(',')), ignored);
    if (!is_there) out << "no such file yet: " << printable(file) << " (the project names it all the same)\n";
  }
}

// Returns whether a file of the folder stands in a value of the project: "plate.stl", "./plate.stl" or
// "plate.stl,clearance=1".
bool stands_in(const Json& value, const std::string& file) {
  if (value.is_structured()) return std::ranges::any_of(value, [&](const Json& one) { return stands_in(one, file); });
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  const auto is_it = [&](const std::string& name) {
    std::error_code ignored;
    return fs::path(name).lexically_normal() == fs::path(file) ||
           (!name.empty() && fs::equivalent(name, file, ignored));
  };
  return is_it(text) || is_it(text.substr(0, text.find(',')));
}

// Names the files of the folder that stand nowhere in the project.
void note_unused(const Folder& folder, const Json& json, std::ostream& out) {
  const auto note = [&](const std::vector<std::string>& files, const std::string& why) {
    for (const std::string& file : files)
      if (!stands_in(json, file)) out << "not used: " << printable(file) << " (" << why << ")\n";
  };
  note(folder.unclear, "a part, a fixture?");
  note(folder.parts, "a part?");
  note(folder.fixtures, "a fixture?");
  note(folder.heads, "a head?");
  if (!json.contains("tools")) note(folder.libraries, "one of several tool libraries");
}

}  // namespace

int run_init(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
  const std::string name = kProjectFileName;
  std::error_code ignored;
  if (fs::symlink_status(name, ignored).type() != fs::file_type::not_found)
    return fail(err, {make_error("usage", name + " exists already and is left as it is; edit it, or remove it first")});
  Result<Json> json = typed_options(words);
  if (!json) return fail(err, {json.error()});
  const Folder folder = look_around();
  put(*json, "part", folder.parts);
  put(*json, "fixture", folder.fixtures);
  put(*json, "head", folder.heads);
  if (folder.libraries.size() == 1) put(*json, "tools", folder.libraries);
  if (json->empty()) return fail(err, {describe_nothing(folder)});
  const std::string text = json->dump(2) + "\n";
  const Result<ProjectFile> project = read_project_file(name, "", text);
  if (!project) return fail(err, {make_error("usage", project.error().message)});
  const Outcome written = write_file(name, text);
  if (!written) return fail(err, {written.error()}, kExitInternal);
  out << "wrote " << name << "\n";
  for (const ProjectOption& option : project->options)
    out << "  " << padded(option.key, 12) << " " << printable(option.value()) << "\n";
  for (const ProjectOption& option : project->options) note_missing(option, out);
  if (!json->contains("part")) out << "no part: name it with \"part\", the STL of the finished shape\n";
  note_unused(folder, *json, out);
  return kExitClean;
}

}  // namespace gouge
