#include "postproc/cldata/reading/assume_file.h"

#include "lib/base/number_text.h"
#include "postproc/cldata/language/words.h"

namespace gouge {
namespace {

std::string unit_words(LengthUnit unit) { return unit == LengthUnit::inch ? "inch" : "mm"; }

Assumption unit_fact(const UnitGuess& guess) {
  Assumption fact{.subject = Subject::path_unit, .value = unit_words(guess.unit), .code = "path-unit"};
  fact.line = guess.line;
  switch (guess.source) {
    case UnitGuess::Source::stated:
      fact.basis = Basis::stated;
      fact.evidence = guess.word;
      break;
    case UnitGuess::Source::option:
      fact.basis = Basis::stated;
      fact.evidence = "--path-units";
      break;
    case UnitGuess::Source::feed_word:
      fact.basis = Basis::derived;
      fact.evidence = "the file states no unit; its feeds are in " + guess.word;
      break;
    case UnitGuess::Source::none:
      fact.basis = Basis::unknown;
      fact.evidence = "nothing in the file establishes the unit of its positions; mm was taken";
      break;
  }
  fact.remedy = "give --path-units mm or --path-units inch";
  return fact;
}

Assumption dialect_fact(const Dialect& dialect, bool is_given) {
  Assumption fact{.subject = Subject::dialect, .value = std::string(dialect.id), .code = "path-dialect"};
  fact.basis = is_given ? Basis::stated : dialect.is_fallback ? Basis::by_default : Basis::derived;
  fact.evidence = is_given              ? "--dialect"
                  : dialect.is_fallback ? "no mark of a writer was found; the file is read as plain APT"
                                        : "recognized by its content";
  fact.remedy = "give --dialect";
  if (is_given || dialect.other_id.empty()) return fact;
  fact.basis = Basis::contradicted;
  fact.line = dialect.other_line;
  fact.evidence = "the file has marks of " + std::string(dialect.id) + ", and a mark of " +
                  std::string(dialect.other_id) + " in line " + std::to_string(dialect.other_line);
  return fact;
}

Assumption completeness_fact(const FileFacts& facts) {
  Assumption fact{.subject = Subject::completeness, .value = "whole file", .code = "path-cut-short"};
  fact.remedy = "export it again, or state that it is whole with --assume complete";
  if (!facts.cut_short.empty()) {
    fact.basis = Basis::unknown;
    fact.evidence = facts.cut_short;
  } else if (facts.end_line > 0) {
    fact.basis = Basis::derived;
    fact.evidence = "the file has its end mark";
    fact.line = facts.end_line;
  } else {
    fact.basis = Basis::by_default;
    fact.evidence = "a file of this kind has no end mark";
  }
  return fact;
}

// Returns a word that is not understood, with the one that it was probably meant to be.
std::string with_similar(const std::string& word) {
  const std::string_view similar = similar_word(word);
  return similar.empty() ? word : word + " (did you mean " + std::string(similar) + "?)";
}

Assumption statements_fact(const Toolpath& path) {
  constexpr std::size_t kMaxNamed = 5;
  Assumption fact{.subject = Subject::statements, .value = "all understood", .code = "path-words"};
  fact.basis = Basis::derived;
  fact.evidence = count_text(path.statements.size(), "statement") + " understood";
  if (path.words_not_understood.empty()) return fact;
  std::size_t count = 0;
  std::vector<std::string> words;
  for (const auto& [word, times] : path.words_not_understood) {
    count += times;
    if (words.size() < kMaxNamed) words.push_back(with_similar(word));
  }
  const std::size_t more = path.words_not_understood.size() - words.size();
  if (more > 0) words.push_back(std::to_string(more) + " more");
  fact.basis = Basis::unknown;
  fact.value = count_text(count, "statement") + " not understood";
  fact.evidence = count_text(count, "statement") + " with words or arguments that are not understood: " + listed(words);
  fact.remedy = "declare words of your shop with --harmless-word; gougecheck path info lists them";
  return fact;
}

Assumption frame_fact(const FileFacts& facts) {
  Assumption fact{.subject = Subject::frame, .value = "part coordinates", .code = "path-frame"};
  fact.remedy = "state that positions are in part coordinates with --assume frame";
  if (facts.frame_line > 0) {
    fact.basis = Basis::derived;
    fact.value = "frame of the file";
    fact.evidence = "the file states its frame";
    fact.line = facts.frame_line;
  } else if (facts.offset_line > 0) {
    fact.evidence = "text for the control chooses a work offset, taken as that of the part";
    fact.line = facts.offset_line;
  } else {
    fact.evidence = "the file states no frame";
  }
  return fact;
}

}  // namespace

Assumptions assume_file(const Toolpath& path, const UnitGuess& unit, const Dialect& dialect, bool is_dialect_given,
                        const FileFacts& facts) {
  Assumptions all = {unit_fact(unit), dialect_fact(dialect, is_dialect_given), completeness_fact(facts),
                     statements_fact(path), frame_fact(facts)};
  for (Assumption& fact : all) fact.file = path.file;
  return all;
}

}  // namespace gouge
