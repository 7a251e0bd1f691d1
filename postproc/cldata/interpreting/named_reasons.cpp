#include "postproc/cldata/interpreting/named_reasons.h"

#include <mutex>
#include <set>

#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kLongestMajor = 24;

// Of the whole process: moves outlive the reader that names their reasons, and are copied without it.
const char* kept(std::string text) {
  static std::mutex mutex;
  static std::set<std::string> texts;
  const std::lock_guard lock(mutex);
  return texts.insert(std::move(text)).first->c_str();
}

}  // namespace

std::string word_as_reported(std::string_view major) {
  if (major.empty()) return "(no word)";
  const char c = major.front();
  if ((c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.') return "(line of numbers)";
  std::string word = shown_text(major, kLongestMajor);
  for (char& letter : word) letter = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  return word;
}

const char* NamedReasons::name(std::string_view reason, std::string_view major, std::size_t line) {
  std::string word = word_as_reported(major);
  std::string text = std::string(reason) + ": " + word;
  if (line == 0) return kept(std::move(text));
  std::size_t& lines = lines_named_[{std::string(reason), std::move(word)}];
  if (lines < kMostLines) {
    ++lines;
    text += " in line " + std::to_string(line);
  }
  return kept(std::move(text));
}

}  // namespace gouge
