#include "tests/architecture/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

namespace gouge::architecture {
namespace {

bool is_identifier(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Position after the literal that begins at `i` (a quote character).
std::size_t end_of_literal(std::string_view text, std::size_t i) {
  const char quote = text[i];
  for (++i; i < text.size() && text[i] != quote; ++i) {
    if (text[i] == '\\') ++i;
  }
  return i + 1;
}

/// Position after the raw literal R"x(...)x" whose quote is at `i`.
std::size_t end_of_raw_literal(std::string_view text, std::size_t i) {
  const std::size_t open = text.find('(', i);
  if (open == std::string_view::npos) return text.size();
  const std::string close = ")" + std::string(text.substr(i + 1, open - i - 1)) + "\"";
  const std::size_t end = text.find(close, open);
  return end == std::string_view::npos ? text.size() : end + close.size();
}

bool is_message_code(const std::string& word) {
  static const std::array<const char*, 15> kKinds = {"cgal-",    "cutter-", "file-",  "folder-", "jobs-",
                                                     "library-", "merge-",  "mesh-",  "path-",   "picture-",
                                                     "report-",  "stl-",    "store-", "tool-",   "write-"};
  static const std::set<std::string> kOptionNames = {"stl-units", "tool-library", "write-stock"};
  if (kOptionNames.count(word) != 0 || word.empty() || word.back() == '-') return false;
  for (const char c : word) {
    if (c != '-' && std::islower(static_cast<unsigned char>(c)) == 0) return false;
  }
  return std::any_of(kKinds.begin(), kKinds.end(), [&](const char* kind) { return word.rfind(kind, 0) == 0; });
}

/// The texts between pairs of `open` and `close`, in order.
std::vector<std::string> all_between(std::string_view text, std::string_view open, std::string_view close) {
  std::vector<std::string> all;
  for (std::size_t i = text.find(open); i != std::string_view::npos; i = text.find(open, i + 1)) {
    const std::size_t begin = i + open.size(), end = text.find(close, begin);
    if (end == std::string_view::npos) break;
    all.emplace_back(text.substr(begin, end - begin));
  }
  return all;
}

std::set<std::string> codes_between(std::string_view text, std::string_view open, std::string_view close) {
  std::set<std::string> codes;
  for (const std::string& word : all_between(text, open, close)) {
    if (is_message_code(word)) codes.insert(word);
  }
  return codes;
}

}  // namespace

std::set<std::string> message_codes_of(std::string_view text) { return codes_between(text, "\"", "\""); }

std::set<std::string> documented_codes_of(std::string_view markdown) { return codes_between(markdown, "\n| `", "`"); }

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream stream{std::string(text)};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string without_comments_and_literals(std::string_view text) {
  std::string out(text);
  const auto blank = [&out](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to && i < out.size(); ++i) {
      if (out[i] != '\n') out[i] = ' ';
    }
  };
  std::size_t i = 0;
  while (i < text.size()) {
    std::size_t end = i + 1;
    if (text.substr(i, 2) == "//") {
      end = std::min(text.find('\n', i), text.size());
    } else if (text.substr(i, 2) == "/*") {
      end = text.find("*/", i);
      end = end == std::string_view::npos ? text.size() : end + 2;
    } else if (text[i] == '"' && i > 0 && text[i - 1] == 'R') {
      end = end_of_raw_literal(text, i);
    } else if (text[i] == '"' || (text[i] == '\'' && (i == 0 || !is_identifier(text[i - 1])))) {
      end = end_of_literal(text, i);
    } else {
      i = end;
      continue;
    }
    blank(i, end);
    i = end;
  }
  return out;
}

std::vector<Include> includes_of(std::string_view text) {
  std::vector<Include> includes;
  std::size_t number = 0;
  for (const std::string& line : lines_of(text)) {
    ++number;
    std::size_t i = line.find_first_not_of(" \t");
    if (i == std::string::npos || line[i] != '#') continue;
    i = line.find_first_not_of(" \t", i + 1);
    if (i == std::string::npos || line.compare(i, 7, "include") != 0) continue;
    i = line.find_first_of("\"<", i);
    if (i == std::string::npos) continue;
    const std::size_t end = line.find_first_of("\">", i + 1);
    includes.push_back({number, line.substr(i + 1, end - i - 1), line[i] == '"'});
  }
  return includes;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t i = text.find(word); i != std::string_view::npos; i = text.find(word, i + 1)) {
    const std::size_t end = i + word.size();
    if ((i == 0 || !is_identifier(text[i - 1])) && (end >= text.size() || !is_identifier(text[end]))) return true;
  }
  return false;
}

std::vector<std::string> file_links_of(std::string_view markdown) {
  std::vector<std::string> files;
  for (const std::string& link : all_between(markdown, "](", ")")) {
    const std::string file = link.substr(0, link.find('#'));
    if (!file.empty() && file.find("://") == std::string::npos) files.push_back(file);
  }
  return files;
}

std::vector<std::string> quoted_paths_of(std::string_view markdown) {
  std::vector<std::string> paths;
  for (const std::string& part : all_between(markdown, "`", "`")) {
    const bool is_path = part.find_first_of(" \n<>*(") == std::string::npos && part.find('/') != std::string::npos;
    const bool is_ours = part.rfind("lib/", 0) == 0 || part.rfind("toolmodels/", 0) == 0 ||
                         part.rfind("postproc/", 0) == 0 || part.rfind("cli/", 0) == 0 ||
                         part.rfind("tests/", 0) == 0 || part.rfind("docs/", 0) == 0;
    if (is_path && is_ours) paths.push_back(part);
  }
  return paths;
}

std::vector<Module> modules_of(std::string_view cmake_text) {
  std::vector<Module> modules;
  const std::string_view call = "gouge_module(";
  for (std::size_t i = cmake_text.find(call); i != std::string_view::npos; i = cmake_text.find(call, i + 1)) {
    const std::size_t end = std::min(cmake_text.find(')', i), cmake_text.size());
    std::istringstream words{std::string(cmake_text.substr(i + call.size(), end - i - call.size()))};
    Module room;
    words >> room.path;
    std::string keyword;
    for (std::string word; words >> word;) {
      if (word == "SOURCES" || word == "HEADERS" || word == "IMPORTS" || word == "LIBRARIES" || word == "CLOSED" ||
          word == "CLOSED_FOR") {
        keyword = word;
      } else if (keyword == "IMPORTS") {
        room.imports.push_back(word);
      } else if (keyword == "CLOSED") {
        room.closed.push_back(word);
      } else if (keyword == "CLOSED_FOR") {
        room.closed_for.push_back(word);
      }
    }
    modules.push_back(room);
  }
  return modules;
}

}  // namespace gouge::architecture
