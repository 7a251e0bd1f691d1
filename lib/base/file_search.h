#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Searches for files that need not be there. Readers find such files by find_files alone, which notes every search: a
// result depends on a file that is absent too.

namespace gouge {

/// The rule by which the files of a folder fit a name.
enum class SearchRule {
  /// A program that another one calls. O77 fits each file of that number, with zeros and an ending such as .nc or none:
  /// o00077.NC. Another name fits the file of this name, with such an ending or none. A name with an ending fits one file.
  program_beside,
  /// A file that a tool library names. The places are the folder, then the folder Bit beside it, where FreeCAD keeps
  /// such files. If neither has exactly this name, upper and lower case count as equal.
  named_by_tools
};

/// Returns the name of a rule, which is the role of its files in a result (docs/formats/report_json.md).
[[nodiscard]] const char* rule_name(SearchRule rule);
[[nodiscard]] std::optional<SearchRule> search_rule_called(std::string_view name);

struct FileSearch {
  SearchRule rule = SearchRule::program_beside;
  std::string folder;  ///< empty: the working directory
  std::string name;

  auto operator<=>(const FileSearch&) const = default;
};

/// A search with the files that it found.
struct DoneSearch {
  FileSearch search;
  std::vector<std::string> found;

  auto operator<=>(const DoneSearch&) const = default;
};
using SearchLog = std::vector<DoneSearch>;

/// Returns the files that fit, in the order of their names, and adds the search to `log`. Of a file that a tool library
/// names, several mean that the name is ambiguous.
[[nodiscard]] std::vector<std::string> find_files(const FileSearch& search, SearchLog& log);

/// Returns the files that fit now, to compare them with those of an earlier search.
[[nodiscard]] std::vector<std::string> repeat_search(const FileSearch& search);

/// Returns the place of the search, for messages: the folder with the name.
[[nodiscard]] std::string place_of(const FileSearch& search);

}  // namespace gouge
