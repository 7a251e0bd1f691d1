#include "tests/architecture/source_rules.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace gouge::architecture {
namespace {

constexpr std::size_t kLongestFile = 500, kLargestMedian = 150;

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }
bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}
bool is_code(const std::string& path) { return ends_with(path, ".h") || ends_with(path, ".cpp"); }
bool is_below_cli(const std::string& path) {
  return starts_with(path, "lib/") || starts_with(path, "toolmodels/") || starts_with(path, "postproc/");
}

/// The module a path lies in, or null.
const Module* module_of(const std::string& path, const std::vector<Module>& modules) {
  const Module* found = nullptr;
  for (const Module& room : modules) {
    if (starts_with(path, room.path + "/") && (found == nullptr || room.path.size() > found->path.size())) {
      found = &room;
    }
  }
  return found;
}

std::string layer_of(const std::string& room) { return room.substr(0, room.find('/')); }

bool may_import(const std::string& from, const std::string& to) {
  const std::string above = layer_of(from), below = layer_of(to);
  if (below == "lib") return true;
  if (above == "cli") return below == "toolmodels" || below == "postproc" || starts_with(to, "cli/");
  return above == below && above != "lib" && above != "samples";
}

void check_circles(const std::vector<Module>& modules, Complaints& complaints) {
  std::map<std::string, std::set<std::string>> open;
  for (const Module& room : modules) open[room.path] = {room.imports.begin(), room.imports.end()};
  for (bool removed = true; removed;) {
    removed = false;
    for (auto it = open.begin(); it != open.end();) {
      const bool is_leaf =
          std::none_of(it->second.begin(), it->second.end(), [&](const auto& r) { return open.count(r) != 0; });
      removed = removed || is_leaf;
      it = is_leaf ? open.erase(it) : std::next(it);
    }
  }
  for (const auto& [room, imports] : open) complaints.push_back(room + ": imports itself through other rooms");
}

}  // namespace

void complain(Complaints& complaints, const SourceFile& file, std::size_t line, const std::string& what) {
  complaints.push_back(file.path + ":" + std::to_string(line) + ": " + what);
}

Complaints check_modules(const std::vector<Module>& modules) {
  Complaints complaints;
  std::set<std::string> names;
  for (const Module& room : modules) names.insert(room.path);
  for (const Module& room : modules) {
    for (const std::string& import : room.imports) {
      if (names.count(import) == 0) {
        complaints.push_back(room.path + ": imports " + import + ", which is no module");
      } else if (!may_import(room.path, import)) {
        complaints.push_back(room.path + ": imports " + import + ", which does not lie below it");
      }
    }
  }
  check_circles(modules, complaints);
  return complaints;
}

Complaints check_includes(const std::vector<SourceFile>& files, const std::vector<Module>& modules) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const Module* own = module_of(file.path, modules);
    if (!is_code(file.path) || own == nullptr) continue;
    for (const Include& include : includes_of(file.text)) {
      if (!include.is_quoted) continue;
      const Module* target = module_of(include.target, modules);
      if (target == own) continue;
      if (target == nullptr) {
        complain(complaints, file, include.line, "includes " + include.target + ", which lies in no module");
      } else if (std::find(own->imports.begin(), own->imports.end(), target->path) == own->imports.end()) {
        complain(complaints, file, include.line,
                 "includes " + include.target + ", but " + own->path + " does not import " + target->path);
      }
    }
  }
  return complaints;
}

Complaints check_closed_headers(const std::vector<SourceFile>& files, const std::vector<Module>& modules) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!is_code(file.path) || starts_with(file.path, "tests/bench/")) continue;
    const bool is_test = starts_with(file.path, "tests/");
    const Module* own = module_of(is_test ? file.path.substr(6) : file.path, modules);
    for (const Include& include : includes_of(file.text)) {
      const Module* target = include.is_quoted ? module_of(include.target, modules) : nullptr;
      if (target == nullptr || target == own) continue;
      const std::string name = include.target.substr(target->path.size() + 1);
      const auto has = [](const std::vector<std::string>& all, const std::string& one) {
        return std::find(all.begin(), all.end(), one) != all.end();
      };
      if (!has(target->closed, name) || (own != nullptr && has(target->closed_for, own->path))) continue;
      complain(complaints, file, include.line,
               "includes " + include.target + ", which " + target->path + " keeps closed");
    }
  }
  return complaints;
}

Complaints check_heavy_libraries(const std::vector<SourceFile>& files) {
  struct Heavy {
    std::string prefix, room;
    std::size_t max_sources;
    std::set<std::string> users;
  };
  std::array<Heavy, 4> libraries = {Heavy{"CGAL/", "lib/validate/", 2, {}}, Heavy{"opencv2/", "postproc/image/", 1, {}},
                                    Heavy{"png.h", "postproc/image/", 1, {}},
                                    Heavy{"ft2build.h", "postproc/image/", 1, {}}};
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!is_code(file.path) || starts_with(file.path, "tests/")) continue;
    for (const Include& include : includes_of(file.text)) {
      for (Heavy& library : libraries) {
        if (!starts_with(include.target, library.prefix)) continue;
        // Numbers with bounds alone, which are light.
        if (include.target == "CGAL/Interval_nt.h" && file.path == "lib/verify/bounds.h") continue;
        library.users.insert(file.path);
        if (!starts_with(file.path, library.room) || ends_with(file.path, ".h")) {
          complain(complaints, file, include.line,
                   "includes " + include.target + ", which only a source of " + library.room + " may");
        }
      }
    }
  }
  for (const Heavy& library : libraries) {
    if (library.users.size() > library.max_sources) {
      complaints.push_back(library.prefix + " is included by " + std::to_string(library.users.size()) +
                           " files; it may be by " + std::to_string(library.max_sources));
    }
  }
  return complaints;
}

Complaints check_banned_words(const std::vector<SourceFile>& files) {
  static const std::array<const char*, 27> kBanned = {
      "cout", "cerr",  "clog",       "printf", "fprintf",   "puts",  "fputs", "putchar", "perror",
      "exit", "_Exit", "quick_exit", "abort",  "terminate", "throw", "hypot", "fma",     "stod",
      "stof", "atof",  "atoi",       "strtod", "sscanf",    "rand",  "srand", "system",  "setlocale"};
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!is_code(file.path) || !is_below_cli(file.path)) continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(without_comments_and_literals(file.text))) {
      ++number;
      if (starts_with(line, "#include")) continue;
      for (const char* word : kBanned) {
        // "throw;" hands on what another library threw.
        const bool is_handed_on = std::string(word) == "throw" && line.find("throw;") != std::string::npos;
        if (!is_handed_on && has_word(line, word)) {
          complain(complaints, file, number, std::string("uses ") + word + " below cli");
        }
      }
    }
  }
  return complaints;
}

Complaints check_seams(const std::vector<SourceFile>& files) {
  static const std::regex kMadeMotion(R"(\bMotion(\s+\w+)?[({]\s*(from|to|start|end|a|b|before|pose|\*|[\w.]+\.at\())");
  static const std::regex kParts(R"(Against::part\b|\bscene\w*(\.scene)?(->|\.)parts\b)"),
      kFixtures(R"(Against::fixture\b|\bscene\w*(\.scene)?(->|\.)fixtures\b|&ToolVariants::against_fixture)");
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!is_code(file.path) || !starts_with(file.path, "lib/") || starts_with(file.path, "lib/verify/")) continue;
    const std::string code = without_comments_and_literals(file.text);
    std::size_t number = 0;
    for (const std::string& line : lines_of(code)) {
      ++number;
      if (!starts_with(file.path, "lib/motion/") && std::regex_search(line, kMadeMotion))
        complain(complaints, file, number, "makes a motion from poses; ask a MotionLaw (lib/motion)");
    }
    if (file.path != "lib/check/contact_rule.h" && std::regex_search(code, kParts) &&
        std::regex_search(code, kFixtures))
      complain(complaints, file, 1,
               "names both kinds of obstacles; go by the contact table (lib/check/contact_rule.h)");
  }
  return complaints;
}

Complaints check_formats(const std::vector<SourceFile>& files) {
  constexpr std::string_view kTable = "postproc/formats/toolpath_format.cpp";
  Complaints complaints;
  for (const std::string folder : {"postproc/cldata/nccs/", "postproc/cldata/nci/"}) {
    const std::string include = "#include \"" + folder;
    for (const SourceFile& file : files) {
      const bool may_include =
          starts_with(file.path, folder) || starts_with(file.path, "tests/") || file.path == kTable;
      if (!is_code(file.path) || may_include) continue;
      std::size_t number = 0;
      for (const std::string& line : lines_of(file.text)) {
        ++number;
        if (starts_with(line, include)) {
          complain(complaints, file, number,
                   "names a format; ask the table of formats (postproc/formats/toolpath_format.h)");
        }
      }
    }
  }
  return complaints;
}

Complaints check_tolerances(const std::vector<SourceFile>& files) {
  static const std::regex kSmall(R"((^|[^\w.])[0-9.]+e-(0?[4-9]|[1-9][0-9]+)\b)");
  static const std::regex kShared(R"((^|[^\w.])(1e-9|1e-10|1e-12|1e-14|1\.2e-7)\b)");
  Complaints complaints;
  for (const SourceFile& file : files) {
    const bool is_free = starts_with(file.path, "lib/verify/") || starts_with(file.path, "tests/") ||
                         starts_with(file.path, "samples/") || file.path == "lib/base/tolerance.h";
    if (!is_code(file.path) || is_free) continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(without_comments_and_literals(file.text))) {
      ++number;
      const bool is_named = line.find("constexpr") != std::string::npos;
      if (std::regex_search(line, kShared)) {
        complain(complaints, file, number, "has a tolerance that lib/base/tolerance.h names");
      } else if (!is_named && std::regex_search(line, kSmall)) {
        complain(complaints, file, number, "has a small number without a name; see lib/base/tolerance.h");
      }
    }
  }
  return complaints;
}

/// Complains about each line of `files` in which `foreign` is found: that it `uses` the word `instead`.
static Complaints complain_of_words(const std::vector<SourceFile>& files, const std::regex& foreign,
                                    const std::string& uses, const std::string& instead) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!is_code(file.path) || file.path == instead) continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(without_comments_and_literals(file.text))) {
      ++number;
      std::smatch found;
      if (std::regex_search(line, found, foreign)) {
        complain(complaints, file, number, uses + " " + found.str() + " instead of " + instead);
      }
    }
  }
  return complaints;
}

Complaints check_random_numbers(const std::vector<SourceFile>& files) {
  static const std::regex kForeign(
      R"(_distribution\b|\bmt19937|\brandom_device\b|\bstd::shuffle\b|::Random\(|\bs?rand\()");
  return complain_of_words(files, kForeign, "draws with", "tests/support/scatter.h");
}

Complaints check_temporary_folders(const std::vector<SourceFile>& files) {
  static const std::regex kForeign(R"(\bTempDir\b|\btemp_directory_path\b)");
  std::vector<SourceFile> tests;
  std::ranges::copy_if(files, std::back_inserter(tests), [](const SourceFile& file) {
    return file.path.starts_with("tests/") && !file.path.starts_with("tests/bench/") &&
           !file.path.starts_with("tests/fuzz/");
  });
  return complain_of_words(tests, kForeign, "makes files with", "tests/support/temporary_folder.h");
}

Complaints check_file_searches(const std::vector<SourceFile>& files) {
  static const std::regex kForeign(
      R"(\b(recursive_)?directory_iterator\b|\b(fs|filesystem)::(exists|is_regular_file|is_directory|status)\b|\bopendir\b|\bscandir\b)");
  constexpr auto kReaders = std::to_array<const char*>(
      {"lib/", "toolmodels/", "postproc/", "cli/job/", "cli/library/", "cli/machine/", "cli/options/", "cli/tools/"});
  constexpr auto kOthers =
      std::to_array<const char*>({"lib/base/file_search.cpp", "lib/base/files.cpp", "lib/base/staged_file.cpp",
                                  "cli/job/mesh_copies.cpp",  // files that the program writes
                                  "postproc/report_files/own_files.cpp",
                                  "lib/base/similar_name.cpp",   // a message about a file that is not there
                                  "postproc/image/font.cpp",     // fonts of the system
                                  "cli/job/claimed_result.cpp",  // inputs of a result that is verified
                                  "cli/options/mesh_limits.cpp",
                                  "cli/options/stock_arguments.cpp"});  // the words of options, read again in each run
  std::vector<SourceFile> readers;
  std::ranges::copy_if(files, std::back_inserter(readers), [&](const SourceFile& file) {
    return std::ranges::any_of(kReaders, [&](const char* folder) { return file.path.starts_with(folder); }) &&
           std::ranges::find(kOthers, file.path) == kOthers.end();
  });
  return complain_of_words(readers, kForeign, "looks for files with", "lib/base/file_search.h");
}

Complaints check_shape(const std::vector<SourceFile>& files) {
  Complaints complaints;
  std::vector<std::size_t> lengths;
  for (const SourceFile& file : files) {
    if (!is_code(file.path)) continue;
    const std::vector<std::string> lines = lines_of(file.text);
    lengths.push_back(lines.size());
    if (lines.size() > kLongestFile) {
      complain(complaints, file, lines.size(), "is longer than " + std::to_string(kLongestFile) + " lines");
    }
    if (ends_with(file.path, ".h") && (lines.empty() || lines.front() != "#pragma once")) {
      complain(complaints, file, 1, "a header begins with #pragma once");
    }
  }
  if (lengths.empty()) return complaints;
  std::sort(lengths.begin(), lengths.end());
  const std::size_t median = lengths[lengths.size() / 2];
  if (median > kLargestMedian) {
    complaints.push_back("the median length of a file is " + std::to_string(median) + " lines; at most " +
                         std::to_string(kLargestMedian) + " is wanted");
  }
  return complaints;
}

Complaints check_stray_text(const std::vector<SourceFile>& files) {
  // Put together here so that this file does not complain about itself.
  static const std::array<std::string, 3> kNotes = {std::string("TO") + "DO", std::string("FIX") + "ME",
                                                    std::string("XX") + "X"};
  static const std::array<std::string, 3> kPlaces = {std::string("/wo") + "rk/", std::string("/ro") + "ot/",
                                                     std::string("/.lib") + "rary"};
  Complaints complaints;
  for (const SourceFile& file : files) {
    std::size_t number = 0;
    for (const std::string& line : lines_of(file.text)) {
      ++number;
      for (const std::string& note : kNotes) {
        if (has_word(line, note)) complain(complaints, file, number, "has a " + note);
      }
      for (const std::string& place : kPlaces) {
        if (line.find(place) != std::string::npos) complain(complaints, file, number, "names " + place);
      }
    }
  }
  return complaints;
}

Complaints check_type_names(const std::vector<SourceFile>& files) {
  static const std::regex kDefinition(
      R"(^(?:struct|class|enum class|enum) (?:[A-Z_]+_EXPORT )?(\w+(?:::\w+)*)[^;()]*\{.*$)");
  static const std::regex kNamespace(R"(^namespace ([\w:]+) \{)");
  std::map<std::string, std::string> first;
  Complaints complaints;
  for (const SourceFile& file : files) {
    if (!file.path.ends_with(".h") || file.path.starts_with("tests/") || file.path.starts_with("samples/")) continue;
    std::string space;
    std::size_t number = 0;
    for (const std::string& line : lines_of(file.text)) {
      ++number;
      std::smatch match;
      if (std::regex_search(line, match, kNamespace)) space = match[1].str() + "::";
      if (!std::regex_match(line, match, kDefinition)) continue;
      const auto [known, is_new] = first.emplace(space + match[1].str(), file.path);
      if (!is_new) complain(complaints, file, number, "defines " + match[1].str() + " again, after " + known->second);
    }
  }
  return complaints;
}

}  // namespace gouge::architecture
