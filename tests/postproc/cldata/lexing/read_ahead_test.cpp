#include "postproc/cldata/lexing/read_ahead.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/base/files.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/lexing/lexer.h"
#include "tests/support/scatter.h"
#include "tests/support/source_folder.h"

namespace gouge::read_ahead_test {
namespace {

/// All that a statement says, with its split arguments.
std::string described(const Statement& s) {
  std::string text = std::to_string(s.line) + " " + std::to_string(s.first_byte) + " " + std::to_string(s.last_byte) +
                     " " + std::to_string(static_cast<int>(s.word)) + " " + std::string(s.major) + " " +
                     std::to_string(s.is_unterminated) + std::to_string(s.hides_comment) +
                     std::to_string(s.is_decoded) + std::to_string(s.has_axes) + std::to_string(s.is_continuation);
  for (const std::string_view piece : s.pieces) text += "|" + std::string(piece);
  std::vector<Argument> arguments;
  split_arguments(s, arguments);
  for (const Argument& argument : arguments) {
    text += ";" + std::string(argument.text) + "=";
    if (argument.number) text += std::to_string(*argument.number);
  }
  return text;
}

std::vector<std::string> all_of(StatementSource& source) {
  std::vector<std::string> all;
  Statement statement;
  while (source.next(statement)) all.push_back(described(statement));
  return all;
}

std::vector<std::string> read_in_order(std::string_view bytes) { return all_of(*open_text(bytes, 0, 1)); }

std::vector<std::string> read_ahead_of(std::string_view bytes, std::size_t at_once) {
  return all_of(*read_ahead(open_text(bytes, 0, 1), at_once));
}

TEST(ReadAhead, GivesTheStatementsOfEveryFileInOrder) {
  test::Scatter random(1);
  std::size_t files = 0;
  for (const char* const folder : {"/tests/corpus", "/tests/fuzz/corpus"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() + folder)) {
      if (!entry.is_regular_file()) continue;
      const Result<std::string> bytes = read_file(entry.path());
      ASSERT_TRUE(bytes) << entry.path();
      ++files;
      const std::vector<std::string> expected = read_in_order(*bytes);
      for (const std::size_t size : {std::size_t{1}, std::size_t{2}, 1 + random.below(300), kStatementsAtOnce})
        EXPECT_EQ(read_ahead_of(*bytes, size), expected) << entry.path() << ", " << size << " at once";
    }
  }
  EXPECT_GT(files, 50U);
}

// Statements of one or many lines, short and longer than a batch, at random places.
TEST(ReadAhead, GivesLongStatementsAmongShortOnes) {
  test::Scatter random(2);
  std::string text;
  for (int i = 0; i < 3000; ++i) {
    text += random.is(0.25) ? "RAPID\nGOTO/" : "GOTO/";
    const std::size_t numbers = 3 * (random.is(0.02) ? 5000 : 1 + random.below(2));
    for (std::size_t k = 0; k < numbers; ++k)
      text += (k == 0 ? "" : random.is(0.1) ? ",$\n" : ", ") + std::to_string(random.in(0, 100));
    text += random.is(0.01) ? "$$ remark\n" : "\n";
  }
  const std::vector<std::string> expected = read_in_order(text);
  for (const std::size_t size : {1U, 5U, 256U}) EXPECT_EQ(read_ahead_of(text, size), expected) << size << " at once";
}

TEST(ReadAhead, EndsWhenTheCallerStops) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "GOTO/1,2,3\n";
  const auto source = read_ahead(open_text(text, 0, 1));
  Statement statement;
  ASSERT_TRUE(source->next(statement));
  EXPECT_EQ(statement.line, 1U);
}

TEST(ReadAhead, GivesNothingAfterTheEnd) {
  const auto source = read_ahead(open_text("GOTO/1,2,3\n", 0, 1));
  Statement statement;
  ASSERT_TRUE(source->next(statement));
  EXPECT_FALSE(source->next(statement));
  EXPECT_FALSE(source->next(statement));
}

struct ThrowingSource final : StatementSource {
  [[nodiscard]] bool next(Statement& /*statement*/) override { throw std::runtime_error("no memory"); }
};

TEST(ReadAhead, PassesAnExceptionOn) {
  const auto source = read_ahead(std::make_unique<ThrowingSource>());
  Statement statement;
  EXPECT_THROW((void)source->next(statement), std::runtime_error);
}

}  // namespace
}  // namespace gouge::read_ahead_test
