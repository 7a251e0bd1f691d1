#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace gouge {

/// The blocks of a file: TOOL PATH to END-OF-PATH of NX, or sections that each have a frame (CAMplete). Where some
/// blocks state a frame, one that states none has lost it; so has what stands between two blocks.
class BlockState {
 public:
  /// Another block begins before move `move`.
  void begin(std::size_t move) {
    close(move);
    ++number_;
  }
  /// The one that was begun has an end, and frame, tool and axis of its own.
  void open() { is_open_ = true; }
  void end() {
    is_open_ = false;
    is_between_ = true;
  }
  void leave_between() { is_between_ = false; }
  void note_frame_between() { is_frame_between_ = true; }
  /// Returns true once, where a frame was stated between two blocks.
  [[nodiscard]] bool take_frame_between() { return std::exchange(is_frame_between_, false); }
  /// A frame is stated before move `move`. It is the block's if it stands before its positions, as files write it.
  void note_frame(std::size_t move) { has_frame_ = has_frame_ || begin_ == move; }
  /// A frame that is not the part's own: blocks have to state theirs.
  void require_frames() { needs_frames_ = true; }

  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] bool is_open() const { return is_open_; }
  [[nodiscard]] bool is_between() const { return is_between_; }
  [[nodiscard]] bool has_positions(std::size_t moves) const { return number_ > 0 && begin_ < moves; }
  /// At the end of a file of `moves` moves: [begin, end) of those in blocks that have lost their frame.
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
  std::size_t begin_ = 0;  // its first move
  bool is_open_ = false, is_between_ = false, is_frame_between_ = false;
  bool has_frame_ = false, needs_frames_ = false;
  std::vector<std::pair<std::size_t, std::size_t>> without_frame_;
};

}  // namespace gouge
