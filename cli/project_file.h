#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/job_options.h"
#include "cli/options/option_table.h"
#include "lib/base/result.h"

namespace gouge {

inline constexpr const char* kProjectFileName = "gougecheck.json";
inline constexpr const char* kNoConfig = "no-config";  ///< option that reads no project file

/// One option that a project file sets.
struct ProjectOption {
  std::string key;                 ///< long name of the option, without --
  std::vector<std::string> words;  ///< "--fixture=a.stl", "--fixture=b.stl"
  std::size_t line = 0;

  /// Returns the value for display: "a.stl, b.stl"; "yes" for a flag.
  [[nodiscard]] std::string value() const;
};

struct ProjectFile {
  InputFile input;                     ///< named relative to the working directory: "../gougecheck.json"
  std::vector<ProjectOption> options;  ///< in the order of project_keys

  [[nodiscard]] const ProjectOption* option(const std::string& key) const;
};

/// Returns all options that a project file may set, in the order of the tables.
[[nodiscard]] const std::vector<OptionKind>& project_options();

/// Returns the keys of these options in a project file.
[[nodiscard]] std::vector<std::string> project_keys();

/// Finds the project file for the working directory. It is the nearest one from there up to the root of the repository
/// (the folder with .git). Without a repository only the working directory is searched. Returns none if there is no
/// such file.
/// Errors: project-foreign if it belongs to another user or everybody may write it, project-unreadable.
[[nodiscard]] Result<std::optional<ProjectFile>> find_project_file();

/// Reads the options of a project file with the name `name`, whose files are below `folder`.
/// Errors, with the line: project-syntax, project-duplicate-key, project-option, json-too-deep, json-too-long. The code
/// project-option means that there is no such option, no project file may set it, or its value is of the wrong kind.
[[nodiscard]] Result<ProjectFile> read_project_file(const std::string& name, const std::string& folder,
                                                    const std::string& bytes);

}  // namespace gouge
