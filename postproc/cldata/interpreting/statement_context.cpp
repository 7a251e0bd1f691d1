#include "postproc/cldata/interpreting/statement_context.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/number_text.h"
#include "postproc/cldata/language/text.h"

namespace gouge {
namespace {

constexpr std::size_t kErrorsListed = 20;
constexpr std::size_t kUnknownWordsListed = 200;
constexpr const char* kOtherWords = "(other words)";

bool begins_with_letter(std::string_view text) { return !text.empty() && is_letter(text.front()); }

bool is_number_word(std::string_view text) {
  return starts_with_ignoring_case(text, "nan") || starts_with_ignoring_case(text, "inf");
}

}  // namespace

std::string_view StatementContext::text_behind_major() const {
  if (statement_->is_decoded) return first_piece();
  const std::string_view all = path.source, major = statement_->major;
  const auto after = static_cast<std::size_t>(major.data() - all.data()) + major.size();
  return all.substr(after, all.find('\n', after) - after);
}

void StatementContext::begin(const Statement& next) {
  statement_ = &next;
  add_statement({next.line, next.first_byte, next.last_byte});
}

bool StatementContext::has_numbers_alone(std::size_t count) const {
  return arguments.size() == count && find_word_argument(arguments) == nullptr;
}

Vec3 StatementContext::vector(std::size_t first) const {
  return {*arguments[first].number, *arguments[first + 1].number, *arguments[first + 2].number};
}

std::string StatementContext::comma_hint() const {
  constexpr std::size_t kFewest = 4;  // two numbers, such as 1,5 and 2,25
  const auto is_whole = [](const Argument& one) { return one.number && one.text.find('.') == std::string_view::npos; };
  const bool may_be_commas =
      arguments.size() >= kFewest && arguments.size() % 2 == 0 && std::ranges::all_of(arguments, is_whole);
  return may_be_commas ? "; write a decimal point, not a comma, if that is meant" : "";
}

bool StatementContext::check_all_numbers(std::string_view expected) {
  const Argument* word = find_word_argument(arguments);
  if (word == nullptr) return true;
  if (begins_with_letter(word->text) && !is_number_word(word->text) && path.moves.empty()) {
    refuse_part_program(major() + "/" + std::string(word->text));
    return false;
  }
  const std::string what = word->text.empty() ? "an empty argument" : quoted_text(word->text);
  fail("path-number", major() + ": " + what + " is not a finite number; " + std::string(expected) + " in numbers");
  return false;
}

void StatementContext::count_unknown(std::string_view major) {
  std::string word = word_as_reported(major);
  auto& words = path.words_not_understood;
  if (words.size() >= kUnknownWordsListed && !words.contains(word)) word = kOtherWords;
  ++words[word];
}

void StatementContext::fail(std::string code, std::string message) {
  if (errors_.size() >= kErrorsListed) {
    ++errors_not_listed_;
    return;
  }
  errors_.push_back(make_error(std::move(code), std::move(message), path.file, line()));
}

void StatementContext::refuse_part_program(std::string_view what, std::size_t line) {
  errors_not_listed_ = 0;
  errors_ = {make_error("path-part-program",
                        "is an APT part program (" + quoted_text(what) +
                            "); expected CL data with positions in numbers: run it through an APT system and check the "
                            "CL file that gives",
                        path.file, line)};
  is_beyond_cutoff_ = true;
}

Diagnostics StatementContext::take_errors() {
  if (errors_not_listed_ > 0) {
    errors_.push_back(
        make_error("path-more-errors", "and " + std::to_string(errors_not_listed_) + " more errors", path.file));
  }
  return std::exchange(errors_, {});
}

}  // namespace gouge
