#include "tests/laws/mutation_bases.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "postproc/formats/read_toolpath.h"
#include "tests/laws/loose_statements.h"
#include "tests/laws/motion_coverage.h"
#include "tests/laws/motion_expander.h"
#include "tests/support/source_folder.h"

namespace gouge::laws {
namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(folder)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::filesystem::path> modal_files() { return files_in(source_folder() + "/tests/corpus/modal"); }

std::vector<std::filesystem::path> real_files() {
  constexpr std::array<std::string_view, 3> kNoText{".cl", ".tbl", ".md"};
  std::vector<std::filesystem::path> files = files_in(source_folder() + "/../shared/data/toolpaths");
  std::erase_if(files, [&](const std::filesystem::path& file) {
    return std::find(kNoText.begin(), kNoText.end(), file.extension().string()) != kNoText.end();
  });
  return files;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::optional<MutationBase> mutation_base(const std::string& name, const std::string& bytes) {
  MutationBase base{name, bytes, "", {}, false};
  const ReadOutcome read = read_toolpath(name, bytes);
  if (!read.toolpath) return std::nullopt;
  base.dialect = read.toolpath->dialect;
  base.is_tool_given = read.toolpath->tools.empty();
  for (const PathTool& tool : read.toolpath->tools) {
    if (!tool.cutter && tool.number) base.library_tools.insert(*tool.number);
  }
  return base;
}

std::vector<std::string> segments(const std::string& bytes, std::size_t statements, std::size_t count) {
  const std::vector<LooseStatement> all = loose_statements(bytes);
  std::vector<std::size_t> line_begins{0};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] == '\n') line_begins.push_back(i + 1);
  }
  line_begins.push_back(bytes.size());
  const auto text = [&](std::size_t first, std::size_t last) {  // statements [first, last)
    if (first >= last) return std::string();
    const std::size_t begin = line_begins[all[first].line - 1];
    return bytes.substr(begin, line_begins[all[last - 1].last_line] - begin);
  };
  std::size_t header = 0;
  while (header < all.size() && all[header].word != "GOTO" && all[header].word != "FROM") ++header;
  std::vector<std::string> found;
  for (std::size_t k = 0; k < count && header + k * statements + 1 < all.size(); ++k) {
    const std::size_t first = header + k * statements, last = std::min(first + statements, all.size() - 1);
    found.push_back(text(0, header) + text(first, last) + text(all.size() - 1, all.size()));
  }
  return found;
}

std::string violation(const MutationBase& base, const Toolpath& path, const std::string& bytes) {
  for (const std::string& dialect : std::set<std::string>{base.dialect, path.dialect}) {
    const Expansion expansion = expand_motions(bytes, dialect, base.library_tools);
    if (!expansion.uncertainties.empty())
      return "line " + std::to_string(expansion.uncertainties.front().line) + ": " +
             expansion.uncertainties.front().why;
    if (const auto missing = first_not_swept(expansion, path)) return "not swept: " + *missing;
  }
  return "";
}

bool is_wholly_checked(const MutationBase& base, const Toolpath& path) {
  return is_wholly_checked(path, base.library_tools, base.is_tool_given);
}

}  // namespace gouge::laws
