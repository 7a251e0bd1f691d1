#pragma once

#include <optional>
#include <vector>

#include "lib/tilt/tilt_space.h"

namespace gouge {

/// The tilts of all positions of a run, one each.
using TiltSequence = std::vector<Tilt>;

struct LatticeResult {
  std::optional<TiltSequence> sequence;
  /// Without a sequence: a position at which no examined tilt is free. Nothing if every position has free tilts but no
  /// sequence connects them.
  std::optional<std::size_t> blocked;
  /// Without a sequence: a position that stays as programmed and prevents any sequence (TiltSpace::holds_back).
  std::optional<std::size_t> held_back;
};

/// Stored results of searches for the tilts of a position.
struct KnownTilts {
  enum State : char { kUnknown, kFree, kRefused };
  RefusingPoints refusing;
  std::vector<State> states;    ///< of the tilts of the finest lattice, by column and row; empty: none is known
  std::vector<State> unraised;  ///< the states from the search in which the tip could not rise
};

/// Finds a sequence of tilts that is certified free at every position and on every motion between neighbours.
///
/// Tilts are the points of a square lattice over the allowed range. The first lattice is coarse. A finer one follows
/// near the result of the coarse one, or everywhere if the coarse one found nothing. Layers are positions of the run,
/// few at first. Dynamic programming finds the cheapest sequence through them: sum of |tilt|^2 ds / blend^2 + |change
/// of tilt|^2 / ds. Only the cheapest sequence is examined: first its tilts at the layers, then all its positions and
/// motions. A tilt that is not free is removed. If the sequence is not free at a position between layers, that position
/// becomes a layer. If it is not free on a motion between two layers, that motion is excluded. Then the search repeats.
///
/// At the position `doubtful` possibly no tilt is free. It is examined before all others. If no tilt is free there, the
/// search ends at once.
/// The list `known` has one entry for each position and is empty at first. Alternatively it comes from a search in the
/// same space, except that the tip could not rise.
/// Ensures  The sequence is the same at any number of threads.
/// Cost     Checks of about a tenth of the tilts of each layer; there are about a hundred layers. At a position without
///          a free tilt, checks of all its tilts.
/// Source   Layers of postures: Plakhotnik and Lauwers 2014. Only the motions of the best sequence are proved: Dellin
///          and Srinivasa 2016 (LazySP).
[[nodiscard]] LatticeResult find_tilts(const TiltSpace& space, unsigned threads, std::optional<std::size_t> doubtful,
                                       std::vector<KnownTilts>& known);

}  // namespace gouge
