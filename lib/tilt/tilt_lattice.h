#pragma once

#include <optional>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// Tilts of all positions of a run, one each.
using TiltSequence = std::vector<Tilt>;

struct LatticeResult {
  std::optional<TiltSequence> sequence;
  /// Where there is none: a position at which no tilt that was examined is free, or none, as they are free everywhere
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

/// A sequence of tilts that is certified free at every position and on every motion between two that follow each other.
///
/// Tilts of a square lattice over all that is allowed, coarse at first, finer about what the coarse one found or where it
/// found nothing. Layers are positions of the run, few at first; dynamic programming finds the cheapest way through them:
/// sum of |tilt|^2 ds / blend^2 + |change of tilt|^2 / ds. Only what that way takes is examined, first its tilts at the
/// layers, then every position and motion of it. A tilt that is not free is left out, a position where the way is not
/// becomes a layer of its own, a motion that is not is struck out, and the way is sought again.
/// `doubtful`: a position where no tilt may be free; it is examined before all others. Where it is not, that is stated at
/// once.
/// `known`: of each position, empty at first; or of a search in the same space, but that the tip might not rise.
/// Ensures  The same sequence at any number of threads.
/// Cost     Checks of about a tenth of the tilts of each layer, of which there are some hundred; where none is free of
///          all.
/// Source   Layers of postures: Plakhotnik and Lauwers 2014; only the winner's motions are proved: Dellin and Srinivasa
///          2016 (LazySP).
[[nodiscard]] LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful,
                                       std::vector<KnownTilts>& known);

}  // namespace gouge
