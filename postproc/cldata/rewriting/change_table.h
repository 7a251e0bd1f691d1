#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/path/path_change.h"
#include "lib/path/toolpath.h"
#include "postproc/program/edits.h"

namespace gouge {

/// The change of each move of a path, if it has one.
class ChangeTable {
 public:
  /// `changes` must outlive the table.
  ChangeTable(std::size_t moves, const std::vector<PathChange>& changes) : of_move_(moves, nullptr) {
    for (const PathChange& change : changes) of_move_[change.move] = &change;
  }

  /// Returns the change of a move; null: none.
  [[nodiscard]] const PathChange* operator[](std::size_t move) const { return of_move_[move]; }
  [[nodiscard]] bool is_changed(std::size_t move) const {
    return has_new_end(move) || has_insertion(move) || is_straightened(move) || has_new_arc(move) || is_rewritten(move);
  }
  /// Returns whether an arc or a hole gets a new description.
  [[nodiscard]] bool is_rewritten(std::size_t move) const {
    return of_move_[move] != nullptr && (of_move_[move]->has_arc() || of_move_[move]->hole_shift_mm);
  }
  [[nodiscard]] bool has_new_end(std::size_t move) const {
    return of_move_[move] != nullptr && of_move_[move]->new_end;
  }
  [[nodiscard]] bool has_new_arc(std::size_t move) const {
    return of_move_[move] != nullptr && of_move_[move]->new_arc;
  }
  [[nodiscard]] bool is_straightened(std::size_t move) const {
    return of_move_[move] != nullptr && of_move_[move]->is_straightened;
  }
  [[nodiscard]] bool has_insertion(std::size_t move) const {
    return of_move_[move] != nullptr && !of_move_[move]->inserted_before.empty();
  }

 private:
  std::vector<const PathChange*> of_move_;
};

/// The statements of a file that have no position of their own, and their replacements. A statement that describes a
/// straightened curve is removed. One that describes an arc becomes its new description, after the positions inserted
/// before it.
class ReplacedStatements {
 public:
  /// `path` must outlive the object.
  explicit ReplacedStatements(const Toolpath& path) : path_(path) {}

  /// Returns the replacement of `statement`; empty at first.
  [[nodiscard]] std::string& operator[](std::size_t statement) { return text_of_[statement]; }

  /// Returns the bytes of a statement in the file.
  [[nodiscard]] std::string_view bytes_of(std::size_t statement) const;
  /// Returns whether a statement begins with `word`. Returns false if a sequence number or label is before the word,
  /// because that belongs only to this statement.
  [[nodiscard]] bool begins_with(std::size_t statement, std::string_view word) const;

  /// Appends the edits of the statements that begin in the bytes [from, to) of the file.
  void append_edits(Edits& edits, std::size_t from, std::size_t to) const;

 private:
  const Toolpath& path_;
  std::map<std::size_t, std::string> text_of_;
};

}  // namespace gouge
