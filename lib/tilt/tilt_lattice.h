#pragma once

#include <optional>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Tilts of all positions of a run, one each.
using TiltSequence = std::vector<Tilt>;

struct LatticeResult {
  std::optional<TiltSequence> sequence;
  /// Where there is none: a position at which no tilt that was examined is free. None where tilts are free everywhere
  /// but no way leads from each to the next.
  std::optional<std::size_t> blocked;
  /// Where there is none: a position that stays as programmed and lets there be none (TiltSpace::holds_back).
  std::optional<std::size_t> held_back;
};

/// Cached results of searches about the tilts of a position.
struct KnownTilts {
  enum State : char { kUnknown, kFree, kRefused };
  RefusingPoints refusing;
  std::vector<State> states;    ///< of the finest lattice's tilts, by column and row; empty: of none
  std::vector<State> unraised;  ///< the same before the tip might rise
};

/// Finds a sequence of tilts that is certified free at every position and on every motion between two that follow each
/// other.
///
/// Tilts are those of a square lattice over all that is allowed. It is coarse at first, and finer about the result of
/// the coarse one or where that found nothing. Layers are positions of the run, few at first. Dynamic programming finds
/// the cheapest way through them: sum of |tilt|^2 ds / blend^2 + |change of tilt|^2 / ds. Only the cheapest way is
/// examined, first its tilts at the layers, then every position and motion of it. A tilt that is not free is left out.
/// A position where the way is not free becomes a layer of its own, and such a motion is struck out. Then the way is
/// sought again.
///
/// At the position `doubtful` perhaps no tilt is free. It is examined before all others. Where no tilt is free, the
/// search ends at once.
/// The list `known` is of each position, empty at first. Or it is of a search in the same space in which only the tip
/// might not rise.
/// Ensures  The same sequence at any number of threads.
/// Cost     Checks of about a tenth of the tilts of each layer, of which there are some hundred. Where none is free, of
///          all.
/// Source   Layers of postures: Plakhotnik and Lauwers 2014. Only the winner's motions are proved: Dellin and Srinivasa
///          2016 (LazySP).
[[nodiscard]] LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful,
                                       std::vector<KnownTilts>& known);

}  // namespace gouge
