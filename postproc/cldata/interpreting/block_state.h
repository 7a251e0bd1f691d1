#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gouge {

/// The blocks of a file: TOOL PATH to END-OF-PATH of NX, or sections that each have a frame (CAMplete). If some blocks
/// state a frame, a block that states none has lost it. So have the statements between two blocks.
class BlockState {
 public:
  /// Begins another block before move `move`.
  void begin(std::size_t move) {
    close(move);
    ++number_;
  }
  /// Marks the present block, which begins in a line, as one that has an end, and its own frame, tool and axis.
  void open(std::size_t line) {
    if (is_open_ && unended_line_ == 0) unended_line_ = open_line_;
    is_open_ = true;
    open_line_ = line;
  }
  void end() {
    is_open_ = false;
    is_between_ = true;
  }
  void leave_between() { is_between_ = false; }
  void note_frame_between() { is_frame_between_ = true; }
  /// Returns whether a frame was stated between two blocks, and resets this fact.
  [[nodiscard]] bool take_frame_between() { return std::exchange(is_frame_between_, false); }
  /// Notes a frame that is stated before move `move`. It belongs to the block if it precedes all positions of the
  /// block, as files write it.
  void note_frame(std::size_t move) { has_frame_ = has_frame_ || begin_ == move; }
  /// Notes a frame other than that of the part: then each block must state its frame.
  void require_frames() { needs_frames_ = true; }

  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool is_open() const { return is_open_; }
  /// Returns the line of the first block that another one follows without its end; 0: there is none.
  [[nodiscard]] std::size_t unended_line() const { return unended_line_; }
  [[nodiscard]] bool is_between() const { return is_between_; }
  [[nodiscard]] bool has_positions(std::size_t moves) const { return number_ > 0 && begin_ < moves; }
  /// Returns [begin, end) of the moves in blocks that have lost their frame, at the end of a file of `moves` moves.
  [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> without_frame(std::size_t moves) {
    close(moves);
    return needs_frames_ ? without_frame_ : std::vector<std::pair<std::size_t, std::size_t>>{};
  }

 private:
  void close(std::size_t moves) {
    if (has_positions(moves) && !has_frame_) without_frame_.emplace_back(begin_, moves);
    has_frame_ = false;
    begin_ = moves;
  }

  std::size_t number_ = 0;
  std::size_t begin_ = 0;  // the first move of the block
  std::size_t open_line_ = 0, unended_line_ = 0;
  bool is_open_ = false, is_between_ = false, is_frame_between_ = false;
  bool has_frame_ = false, needs_frames_ = false;
  std::vector<std::pair<std::size_t, std::size_t>> without_frame_;
};

}  // namespace gouge
