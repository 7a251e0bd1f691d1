#include "tests/architecture/wording_rules.h"

#include <algorithm>
#include <array>
#include <regex>
#include <string>
#include <string_view>

namespace gouge::architecture {
namespace {

constexpr std::array<std::string_view, 8> kOpenings = {"What", "Whether", "Of", "Who", "Whose", "How", "Which", "Why"};
constexpr std::array<std::string_view, 9> kPrivate = {"nobody",    "whoever", "told apart", "held against", "as ever",
                                                      "let go of", "sees to", "looked at",  "in vain"};

bool has_ending(std::string_view path, std::string_view ending) { return path.ends_with(ending); }

bool is_product(std::string_view path) {
  return path.starts_with("lib/") || path.starts_with("cli/") || path.starts_with("postproc/") ||
         path.starts_with("toolmodels/");
}

/// The text of a comment that is all of a line or ends it; empty: there is none.
std::string_view comment_of(std::string_view line) {
  const std::size_t at = line.find("//");
  if (at == std::string_view::npos || line.substr(0, at).find('"') != std::string_view::npos) return {};
  const std::size_t begin = line.find_first_not_of("/<! ", at);
  return begin == std::string_view::npos ? std::string_view() : line.substr(begin);
}

bool is_comment_alone(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin != std::string_view::npos && line.substr(begin).starts_with("//");
}

std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return all;
}

void find_private_words(const SourceFile& file, std::size_t number, std::string_view text, Complaints& complaints) {
  const std::string all = " " + lower(text) + " ";
  for (const std::string_view word : kPrivate) {
    const std::size_t at = all.find(word);
    if (at == std::string::npos) continue;
    const auto is_letter = [&](std::size_t i) { return all[i] >= 'a' && all[i] <= 'z'; };
    if (is_letter(at - 1) || is_letter(at + word.size())) continue;
    complain(complaints, file, number, "uses \"" + std::string(word) + "\"; see docs/conventions.md");
  }
}

void check_header(const SourceFile& file, Complaints& complaints) {
  bool continues = false;
  std::size_t number = 0;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    const std::string_view comment = comment_of(line);
    if (!continues) {
      const std::string_view first = comment.substr(0, comment.find(' '));
      if (std::find(kOpenings.begin(), kOpenings.end(), first) != kOpenings.end())
        complain(complaints, file, number, "begins a comment with \"" + std::string(first) + "\"; begin with a verb");
    }
    continues = !comment.empty() && is_comment_alone(line);
    find_private_words(file, number, comment, complaints);
  }
}

// A text in a source of the command line may be help or a message.
void check_texts(const SourceFile& file, Complaints& complaints) {
  static const std::regex literal("\"((?:[^\"\\\\]|\\\\.)*)\"");
  std::size_t number = 0;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    if (is_comment_alone(line)) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), literal), end; it != end; ++it)
      find_private_words(file, number, (*it)[1].str(), complaints);
  }
}

void check_limits(const SourceFile& file, Complaints& complaints) {
  static const std::regex limit("\\bk(Most|Least)[A-Z]");
  std::size_t number = 0;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    if (std::regex_search(line, limit)) complain(complaints, file, number, "names a limit; expected kMax or kMin");
  }
}

void check_page(const SourceFile& file, Complaints& complaints) {
  std::size_t number = 0;
  bool is_code = false;
  for (const std::string& line : lines_of(file.text)) {
    ++number;
    if (line.starts_with("```")) is_code = !is_code;
    if (!is_code) find_private_words(file, number, line, complaints);
  }
}

}  // namespace

Complaints check_wording(const std::vector<SourceFile>& files) {
  Complaints complaints;
  for (const SourceFile& file : files) {
    const bool is_header = has_ending(file.path, ".h"), is_source = has_ending(file.path, ".cpp");
    if (is_product(file.path) && is_header) check_header(file, complaints);
    if (file.path.starts_with("cli/") && is_source) check_texts(file, complaints);
    if (is_product(file.path) && (is_header || is_source)) check_limits(file, complaints);
    const bool is_page = file.path == "README.md" || (file.path.starts_with("docs/") && has_ending(file.path, ".md"));
    if (is_page && file.path != "docs/CHANGELOG.md") check_page(file, complaints);
  }
  return complaints;
}

}  // namespace gouge::architecture
