#include "postproc/gcode/running/program_language.h"

#include <algorithm>

#include "lib/base/number_text.h"

namespace gouge {
namespace {

/// Returns the number in "line 12: ...".
long long line_of(const std::string& word) {
  constexpr std::size_t kNumberAt = std::string_view("line ").size();
  return word.size() < kNumberAt ? 0 : parse_integer(word.substr(kNumberAt, word.find(':') - kNumberAt)).value_or(0);
}

}  // namespace

std::vector<std::string> words_by_line(const Toolpath& path) {
  std::vector<std::string> words;
  for (const auto& [word, times] : path.words_not_understood) words.push_back(word);
  std::ranges::stable_sort(words, {}, line_of);
  return words;
}

void note_further_word(const std::string& reason, std::size_t line, const ProgramInput& input) {
  constexpr std::size_t kMaxWords = 20;
  auto& words = input.path.words_not_understood;
  const auto is_same = [&](const auto& word) { return word.first.ends_with(": " + reason); };
  if (words.size() < kMaxWords && std::ranges::none_of(words, is_same))
    ++words["line " + std::to_string(line) + ": " + reason];
}

void lose_program(const std::string& reason, std::size_t line, const ProgramInput& input) {
  if (input.motion.is_rest_unknown()) return;
  ++input.path.words_not_understood["line " + std::to_string(line) + ": " + reason];
  input.motion.doubt(ProgramDoubt::rest, "line " + std::to_string(line) + " is not understood: " + reason);
  input.path.notes.push_back(make_warning("gcode-word",
                                          reason +
                                              "; nothing after it is checked: correct the program, or state a word "
                                              "that neither moves nor changes anything with --harmless-word",
                                          input.path.file, line));
  input.motion.go_unchecked(MoveKind::feed, AxisPlace{}, {});
}

}  // namespace gouge
