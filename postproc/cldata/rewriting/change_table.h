#pragma once

#include <cstddef>
#include <vector>

#include "lib/path/path_change.h"

namespace gouge {

/// The change of each move of a path, where it has one.
class ChangeTable {
 public:
  /// `changes` must outlive the table.
  ChangeTable(std::size_t moves, const std::vector<PathChange>& changes) : of_move_(moves, nullptr) {
    for (const PathChange& change : changes) of_move_[change.move] = &change;
  }

  /// Null: none.
  [[nodiscard]] const PathChange* operator[](std::size_t move) const { return of_move_[move]; }
  [[nodiscard]] bool is_changed(std::size_t move) const {
    return has_new_end(move) || has_insertion(move) || is_straightened(move) || has_new_arc(move) || is_rewritten(move);
  }
  /// An arc or a hole is to be described anew.
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

}  // namespace gouge
