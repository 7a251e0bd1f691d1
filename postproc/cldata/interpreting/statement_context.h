#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lib/path/toolpath.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/language/arguments.h"
#include "postproc/cldata/language/dialect.h"
#include "postproc/cldata/language/statement.h"
#include "postproc/program/path_builder.h"

namespace gouge {

/// The present statement, its file, and the errors of both: the data that every state of the interpreter examines.
class StatementContext : public PathBuilder {
 public:
  StatementContext(Toolpath& path_read, const Dialect& of_file) : PathBuilder(path_read), dialect(of_file) {}

  /// Begins the next statement. `arguments` stay those of the previous one until they are split.
  void begin(const Statement& next);
  [[nodiscard]] const Statement& statement() const { return *statement_; }
  [[nodiscard]] std::string major() const { return std::string(statement_->major); }
  [[nodiscard]] std::string_view first_piece() const { return statement_->pieces.front(); }
  /// Returns the text from the major word to the end of its line. For a decoded statement, whose word is not in the
  /// file, that is its first piece.
  [[nodiscard]] std::string_view text_behind_major() const;
  [[nodiscard]] std::size_t line() const { return statement_->line; }

  /// Functions that read the arguments.
  [[nodiscard]] bool has(std::string_view word) const { return has_argument(arguments, word); }
  [[nodiscard]] bool has_numbers_alone(std::size_t count) const;
  [[nodiscard]] Vec3 vector(std::size_t first) const;
  /// Returns a hint at decimal commas for the end of an error; empty: a number has a point, or the numbers are not pairs.
  [[nodiscard]] std::string comma_hint() const;
  /// Returns whether all arguments are numbers. Otherwise reports an error, "`expected` in numbers", or refuses a part
  /// program.
  [[nodiscard]] bool check_all_numbers(std::string_view expected);

  /// Returns `reason` with the word and the line of the statement; `named` does so for another statement.
  [[nodiscard]] const char* because(const char* reason) { return named(reason, statement_->major, line()); }
  [[nodiscard]] const char* named(const char* reason, std::string_view word, std::size_t line = 0) {
    return reasons_.name(reason, word, line);
  }
  void count_unknown() { count_unknown(statement_->major); }
  void count_unknown(std::string_view major);
  /// Counts the statement as harmless because the user declared its word to be so.
  void count_declared() { declared_.add(line()); }
  [[nodiscard]] const Tally& declared() const { return declared_; }
  void fail(std::string code, std::string message);
  /// Refuses the file because it is not CL data. Of all errors only this one is kept, and further reading is useless.
  void refuse_part_program(std::string_view what) { refuse_part_program(what, line()); }
  void refuse_part_program(std::string_view what, std::size_t line);
  void give_up() { is_beyond_cutoff_ = true; }
  [[nodiscard]] bool is_beyond_cutoff() const { return is_beyond_cutoff_; }
  [[nodiscard]] bool has_errors() const { return !errors_.empty(); }
  [[nodiscard]] Diagnostics take_errors();

  const Dialect dialect;
  std::vector<Argument> arguments;  // of the statement

 private:
  const Statement* statement_ = nullptr;
  NamedReasons reasons_;
  Diagnostics errors_;
  std::size_t errors_not_listed_ = 0;
  bool is_beyond_cutoff_ = false;
  Tally declared_;
};

}  // namespace gouge
