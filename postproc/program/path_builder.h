#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "lib/path/toolpath.h"

// Builder of toolpaths for the readers of all formats.

namespace gouge {

/// Number of occurrences of a fact in a file, and the line of the first one.
struct Tally {
  std::size_t count = 0, first_line = 0;

  void add(std::size_t line) {
    if (count++ == 0) first_line = line;
  }
};

/// A toolpath during the reading of its file, statement by statement.
class PathBuilder {
 public:
  /// Requires Toolpath::file and Toolpath::source. `path_read` must outlive the object.
  explicit PathBuilder(Toolpath& path_read) : path(path_read) {}

  void add_statement(const SourceStatement& statement);
  /// Returns the index of the last statement, in Toolpath::statements.
  [[nodiscard]] std::size_t index() const { return path.statements.size() - 1; }
  [[nodiscard]] std::size_t moves() const { return path.moves.size(); }

  /// Adds a note of how often a fact occurs in the file: the number with `noun`, then `rest`. Adds nothing if it does
  /// not occur.
  void report(Severity severity, const char* code, const Tally& seen, std::string_view noun, std::string_view rest);

  /// Gives `all` memory for `more` items, or for as many as the rest of the file is expected to have. Growth by
  /// doubling would need three times the memory during the copy.
  template <class Things>
  void make_room(Things& all, std::size_t more = 1) const {
    const std::size_t needed = all.size() + more;
    if (needed > all.capacity()) all.reserve(expected_count(needed));
  }

  Toolpath& path;

 private:
  [[nodiscard]] std::size_t expected_count(std::size_t until_here) const;

  std::size_t read_bytes_ = 0;
};

/// The operation of later positions. An operation without a position does not appear in the path.
class OperationState {
 public:
  explicit OperationState(PathBuilder& builder) : builder_(builder) {}

  void name(std::string text, std::size_t line) {
    name_ = std::move(text);
    line_ = line;
    is_new_ = true;
  }
  /// Returns, at a motion, the index of its operation in Toolpath::operations, or kNone.
  [[nodiscard]] std::size_t resolve() {
    if (!std::exchange(is_new_, false)) return index_;
    index_ = builder_.path.operations.size();
    builder_.make_room(builder_.path.operations);
    builder_.path.operations.push_back({name_, line_});
    return index_;
  }
  [[nodiscard]] std::size_t index() const { return index_; }

 private:
  PathBuilder& builder_;
  std::string name_;
  std::size_t line_ = 0;
  bool is_new_ = false;
  std::size_t index_ = kNone;
};

}  // namespace gouge
