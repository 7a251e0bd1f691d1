#pragma once

#include <cstddef>
#include <string>

namespace gouge {

/// Facts that the statements of a file establish about the whole file. Lines are counted from 1; 0: nowhere.
struct FileFacts {
  std::size_t end_line = 0;        ///< line of the last mark that ends a program or a block
  std::string cut_short;           ///< why the file may be cut short, as a sentence; empty: it seems whole
  std::size_t frame_line = 0;      ///< line of the last frame that is not that of the part
  bool has_turned_frame = false;   ///< whether one of its frames turns X, Y and Z
  std::size_t smoothing_line = 0;  ///< line of the first text for the control that lets it leave the path
  double smoothing_mm = 0;         ///< the largest distance that such text states
  std::size_t joint_law_line = 0;  ///< line of the first text by which the rotary joints run in proportion
  std::size_t offset_line = 0;     ///< line of the first text for the control that chooses a work offset
};

}  // namespace gouge
