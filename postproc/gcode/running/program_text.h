#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "lib/base/paged_memory.h"
#include "lib/path/toolpath.h"

namespace gouge {

using SourceStatements = PagedVector<SourceStatement>;

/// The lines of a program that are not blank, and which of them are blocks: those between the percent signs, if it has
/// any.
class ProgramText {
 public:
  /// Both must outlive the object.
  ProgramText(std::string_view text, const SourceStatements& lines);

  [[nodiscard]] std::size_t begin() const { return begin_; }
  [[nodiscard]] std::size_t end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return lines_.size(); }
  /// Returns a line without its end.
  [[nodiscard]] std::string_view line(std::size_t index) const;
  [[nodiscard]] std::size_t number(std::size_t index) const { return lines_[index].line; }
  [[nodiscard]] bool has_end_mark() const { return end_ < lines_.size(); }

  /// Returns the first line in [from, until) that begins with a letter and a whole number, such as O1234 or N100, after
  /// the mark for block delete. None: there is none, or with `is_unique` there are several.
  [[nodiscard]] std::optional<std::size_t> find_label(char letter, int number, std::size_t from, std::size_t until,
                                                      bool is_unique) const;

 private:
  std::string_view text_;
  const SourceStatements& lines_;
  std::size_t begin_ = 0, end_ = 0;
};

/// A program that holds its own text, such as one beside the file.
class StoredProgram {
 public:
  explicit StoredProgram(std::string bytes);
  StoredProgram(const StoredProgram&) = delete;
  StoredProgram& operator=(const StoredProgram&) = delete;
  ~StoredProgram() = default;

  [[nodiscard]] const ProgramText& text() const { return text_; }

 private:
  std::string bytes_;
  SourceStatements lines_;
  ProgramText text_;
};

/// Programs may call each other to this depth.
inline constexpr std::size_t kMaxCalls = 64;
/// Blocks that may run beyond those of the file: loops that do not end are ended here. With sanitizers a block takes a
/// hundred times as long.
#if defined(GOUGE_SANITIZED)
inline constexpr std::size_t kMaxRepeatedBlocks = 20'000;
#else
inline constexpr std::size_t kMaxRepeatedBlocks = 2'000'000;
#endif

/// Returns " in line 12", or for 0 " in the blocks at the start (--start)", which are no lines of the program.
[[nodiscard]] std::string in_line(std::size_t line);

/// Adds the lines of a text that are not blank, without a byte order mark before them. Cost: one pass at the
/// speed of memory.
void add_lines(std::string_view text, SourceStatements& lines);

}  // namespace gouge
