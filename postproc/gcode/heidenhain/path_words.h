#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "postproc/gcode/heidenhain/klartext_table.h"
#include "postproc/gcode/heidenhain/klartext_words.h"

namespace gouge {

/// A coordinate as a block states it.
struct PathCoordinate {
  double value = 0;
  bool is_step = false;   ///< IX: from the last position
  std::string parameter;  ///< the Q parameter that is the value; empty: a number
};

enum class PathCompensation : std::uint8_t { none, left, right };

/// The words of a path block by their places.
struct PathWords {
  std::array<std::optional<PathCoordinate>, 3> xyz, abc;
  std::optional<PathCoordinate> polar_radius, polar_angle;
  std::optional<double> radius, feed;
  std::optional<bool> is_clockwise;  ///< DR
  bool is_rapid = false;             ///< FMAX
  std::optional<PathCompensation> compensation;
  std::vector<const KlartextFunction*> functions;

  [[nodiscard]] bool has_linear() const { return xyz[0] || xyz[1] || xyz[2]; }
  [[nodiscard]] bool has_rotary() const { return abc[0] || abc[1] || abc[2]; }
  /// Returns the function with a meaning; null: the block has none.
  [[nodiscard]] const KlartextFunction* function(KlartextMeaning meaning) const;
};

/// Words that a statement allows besides F and M.
struct PathForm {
  bool has_coordinates = false, has_compensation = false, has_polar = false, has_radius = false, has_direction = false;
};

/// Sorts words behind the first one. Returns why they are not understood: a word that the form does not allow, a word twice,
/// a word without its number, or an M function without a row that `harmless` does not name ("M200"). Empty: all have a place.
[[nodiscard]] std::string take_path_words(std::span<const KlartextWord> words, const PathForm& form,
                                          const std::vector<std::string>& harmless, PathWords& taken);

}  // namespace gouge
