#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "lib/path/toolpath.h"
#include "postproc/program/edits.h"

namespace gouge {

/// The statements of a file and what some of them become that have no position of their own: nothing, where they
/// describe what is straightened; or what describes an arc, with the positions before it.
class ReplacedStatements {
 public:
  /// `path` must outlive the object.
  explicit ReplacedStatements(const Toolpath& path) : path_(path) {}

  /// What `statement` becomes; empty at first.
  [[nodiscard]] std::string& operator[](std::size_t statement) { return text_of_[statement]; }

  /// As the file has it.
  [[nodiscard]] std::string_view bytes_of(std::size_t statement) const;
  /// False where a sequence number or label, which belongs to its statement alone, stands before the word.
  [[nodiscard]] bool begins_with(std::size_t statement, std::string_view word) const;

  /// Appends the edits of the statements that begin in the bytes [from, to) of the file.
  void append_edits(Edits& edits, std::size_t from, std::size_t to) const;

 private:
  const Toolpath& path_;
  std::map<std::size_t, std::string> text_of_;
};

}  // namespace gouge
