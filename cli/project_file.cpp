#include "cli/project_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/commands/job_words.h"
#include "cli/options/joint_options.h"
#include "cli/options/parse_errors.h"
#include "lib/json/json_file.h"

namespace gouge {
namespace {

namespace fs = std::filesystem;

bool is_allowed(const CLI::Option& option) {
  return !option.get_lnames().empty() &&
         std::ranges::find(project_options(), option.get_lnames().front(), &OptionKind::key) != project_options().end();
}

std::optional<std::string> why_not_in_project(const CLI::Option& option) {
  if (is_allowed(option)) return std::nullopt;
  if (option.get_group() == kOutputGroup)
    return "names an output or says what it replaces, which no project file may; say it on the command line";
  return "cannot stand in a project file; say it on the command line";
}

const WordRules& project_rules() {
  static const WordRules rules{"project-option", why_not_in_project, "a project file cannot name standard input"};
  return rules;
}

/// An open file, closed by the destructor.
class Handle {
 public:
  explicit Handle(const std::string& path) : number_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Handle() {
    if (number_ >= 0) ::close(number_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

// Reads a file that only its owner can write. The handle ensures that the examined file is the one that is read, even
// if the name changes its meaning.
Result<std::string> read_own_file(const std::string& name) {
  constexpr std::size_t kMost = 1'000'000;
  const auto unreadable = [&](const std::string& why) {
    return make_error("project-unreadable", why + "; expected a project file, or --no-config to do without", name);
  };
  const Handle handle(name);
  struct stat facts {};
  if (handle.number() < 0 || ::fstat(handle.number(), &facts) != 0) return unreadable(std::strerror(errno));
  if (!S_ISREG(facts.st_mode)) return unreadable("this is no file");
  const bool is_mine = facts.st_uid == ::geteuid();
  if (!is_mine || (facts.st_mode & S_IWOTH) != 0) {
    return make_error(
        "project-foreign",
        std::string(is_mine ? "everybody may write this project file" : "this project file belongs to somebody else") +
            "; expected one of your own that others cannot write, or --no-config to do without",
        name);
  }
  std::string bytes;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(handle.number(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return unreadable(std::strerror(errno));
    if (count == 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > kMost) return unreadable("this file has more than 1 MB");
  }
}

bool is_own_folder(const fs::path& folder) {
  struct stat facts {};
  return ::stat(folder.c_str(), &facts) == 0 && facts.st_uid == ::geteuid();
}

// Returns the home folder of the user; empty if none is stated.
fs::path home_folder() {
  const char* const home = std::getenv("HOME");
  return home == nullptr ? fs::path() : fs::path(home).lexically_normal();
}

/// Returns the folders to search, from the working directory up, named relative to it: "", "../", ... The last one is
/// the root of the repository. Without a repository it is the home folder, or the folder below the first one of another
/// user.
std::vector<std::string> folders_to_search() {
  std::error_code failed;
  fs::path at = fs::current_path(failed);
  if (failed) return {};
  const fs::path home = home_folder();
  std::vector<std::string> folders = {""};
  std::optional<std::size_t> without_repository;  // number of folders
  for (std::string above;; above += "../") {
    if (fs::exists(at / ".git", failed)) return folders;
    const bool is_top = !at.has_parent_path() || at == at.parent_path();
    if (!without_repository && (is_top || at == home || !is_own_folder(at.parent_path())))
      without_repository = folders.size();
    if (is_top) break;
    at = at.parent_path();
    folders.push_back(above + "../");
  }
  folders.resize(*without_repository);
  return folders;
}

}  // namespace

std::string ProjectOption::value() const {
  std::string text;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    text += (text.empty() ? "" : ", ") + (equals == std::string::npos ? "yes" : word.substr(equals + 1));
  }
  return text;
}

const ProjectOption* ProjectFile::option(const std::string& key) const {
  const auto found = std::ranges::find(options, key, &ProjectOption::key);
  return found == options.end() ? nullptr : &*found;
}

const std::vector<OptionKind>& project_options() {
  static const std::vector<OptionKind> kinds = [] {
    std::vector<OptionKind> all;
    add_project_options(reading_options(), all);
    add_project_options(job_options(), all);
    add_project_options(joint_options(), all);
    add_project_options(stock_options(), all);
    add_project_options(left_stock_options(), all);
    add_project_options(check_options(), all);
    add_project_options(correct_options(), all);
    return all;
  }();
  return kinds;
}

std::vector<std::string> project_keys() {
  std::vector<std::string> keys;
  for (const OptionKind& kind : project_options()) keys.push_back(key_of_option(kind.key));
  return keys;
}

Result<std::optional<ProjectFile>> find_project_file() {
  for (const std::string& folder : folders_to_search()) {
    const std::string name = folder + kProjectFileName;
    struct stat facts {};
    if (::lstat(name.c_str(), &facts) != 0) continue;
    const Result<std::string> bytes = read_own_file(name);
    if (!bytes) return bytes.error();
    Result<ProjectFile> project = read_project_file(name, folder, *bytes);
    if (!project) return project.error();
    return std::optional(std::move(*project));
  }
  return std::optional<ProjectFile>();
}

Result<ProjectFile> read_project_file(const std::string& name, const std::string& folder, const std::string& bytes) {
  const Result<JsonFile> json = parse_json(name, bytes, {"project-syntax", "project-duplicate-key", "a project file"});
  if (!json) return json.error();
  if (!json->root.is_object())
    return make_error("project-syntax", "this is no object; expected {\"part\": \"part.stl\", ...}", name, 1);
  ProjectFile project;
  project.input = describe_input("project", name, bytes);
  const std::vector<std::string> keys = project_keys();
  for (const auto& [given, value] : json->root.items()) {
    const std::string key = option_of_key(given);
    const std::size_t line = json->lines.at("/" + given);
    const bool is_of_check = option_table("check").get_option_no_throw("--" + key) != nullptr;
    const bool is_known = is_of_check || option_table("correct").get_option_no_throw("--" + key) != nullptr;
    if (key == kNoConfig)
      return make_error("project-option", "\"" + key + "\" cannot stand in a project file; say it on the command line",
                        name, line);
    if (!is_known) {
      const std::string nearest = nearest_name(key, keys);
      return make_error("project-option",
                        "\"" + key +
                            "\" is no option of check or correct; expected the long name of one without its --" +
                            (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"),
                        name, line);
    }
    JobWords words(is_of_check ? "check" : "correct", folder, project_rules());
    if (const Outcome added = words.add(key, value); !added)
      return make_error(added.error().code, added.error().message, name, line);
    if (!words.words().empty()) project.options.push_back({key, words.words(), line});
  }
  std::ranges::sort(project.options, {}, [&](const ProjectOption& option) {
    return std::ranges::find(keys, key_of_option(option.key)) - keys.begin();
  });
  return project;
}

}  // namespace gouge
