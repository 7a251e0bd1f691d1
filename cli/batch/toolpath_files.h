#pragma once

#include <string>
#include <vector>

#include "lib/base/diagnostic.h"
#include "lib/base/result.h"

namespace gouge {

/// Returns whether the options of a batch state a control, so that its toolpaths are programs of a machine.
[[nodiscard]] bool are_of_programs(const std::vector<std::string>& words);

/// Returns whether a file has an ending of toolpaths: of programs of a machine if `are_programs`, else of CL data.
[[nodiscard]] bool has_toolpath_ending(const std::string& file, bool are_programs);

/// Replaces each folder in `places` by the toolpaths in it and below it, sorted by their names. Toolpaths have a known
/// ending: that of a program of a machine if `are_programs`, else that of CL data. Hidden files and folders, and the
/// folder `output`, are passed over. Links to folders are followed, and links that lead nowhere are toolpaths without a
/// file. Errors: usage, if a folder has no toolpath; folder-unreadable.
[[nodiscard]] Result<std::vector<std::string>> expand_folders(const std::vector<std::string>& places,
                                                              const std::string& output, bool are_programs);

/// Folders in which toolpaths may lie.
struct FoldersFound {
  std::vector<std::string> folders;  ///< a folder, and those below it, as expand_folders looks into them
  Diagnostics unreadable;            ///< errors of those that cannot be read (folder-unreadable)
};
[[nodiscard]] FoldersFound folders_in(const std::string& folder, const std::string& output);

/// Returns a name for each toolpath, by which it can be told from the others. It is the name of the file without its
/// ending. Equal names get the ending, or else the names of the folders that differ: "rough-op10". Names of one file
/// that is given twice stay equal.
[[nodiscard]] std::vector<std::string> names_of_toolpaths(const std::vector<std::string>& paths);

}  // namespace gouge
