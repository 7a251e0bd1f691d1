#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "lib/check/closest_approach.h"
#include "lib/check/path_fit.h"
#include "lib/check/verdict.h"
#include "lib/path/assumption.h"
#include "lib/path/toolpath.h"

namespace gouge {

/// A body that gouges an obstacle in a move whose verdict names another body or another obstacle.
struct FurtherContact {
  std::size_t move = 0;
  Body body = Body::cutter;
  Against against = Against::part;
  double depth_mm = 0;             ///< depth of the witness in the body alone; 0: it is open whether the body gouges
  double depth_upper_mm = 0;       ///< infinite: there is no bound
  std::optional<Witness> witness;  ///< none: it is open whether the body gouges

  [[nodiscard]] bool is_of_same_pair(const FurtherContact& other) const {
    return body == other.body && against == other.against;
  }
};

/// Clean moves that turn a rotary joint, and how many of them are clean wherever the joints are between their ends.
struct AnyTurnCounts {
  std::size_t rapids = 0, proved_rapids = 0;  ///< examined with the whole tool
  std::size_t others = 0, proved_others = 0;  ///< feeds and others, examined without the cutter
};

/// A move that meets remaining stock.
struct StockContact {
  std::size_t move = 0;
  double clear_until = 0;        ///< proved clear before this instant, in [0, 1]
  double contact_at = 0;         ///< instant of a witness, the earliest that was found
  std::size_t cut_move = kNone;  ///< the earlier cut that came nearest to the witness of the move; kNone: none
  std::size_t cut_line = 0;      ///< its line, with cut_move
  std::string cut_file{};        ///< its file if that is a program that ran before; empty: that of the move
  double missed_by_mm = 0;       ///< distance of that cut from it, as a search finds it; with cut_move
};

/// The check against remaining stock.
struct StockFacts {
  double tolerance_mm = 0, resolution_mm = 0;
  std::size_t examined = 0, clear = 0;  ///< moves
  std::vector<StockContact> contacts;   ///< in path order
};

/// A place of a part's surface where more material than asked may be left.
struct ExcessPlaceFacts {
  double height_mm = 0;                               ///< highest column of material that is proved; 0: none is
  double height_upper_mm = 0;                         ///< no column of the place is higher
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();  ///< foot of that column; without a height a point of the place
  std::size_t part = 0, facet = 0;                    ///< index in Scene::parts, and in the file of that part
  double area_mm2 = 0, area_upper_mm2 = 0;            ///< of the surface with more than asked
  std::size_t unknown_move = kNone;                   ///< without a height: a move that leaves it open; kNone: none
  std::size_t unknown_line = 0;                       ///< its line, with unknown_move
  std::string unknown_file{};                         ///< its file if that is a program that ran before; else empty

  [[nodiscard]] bool is_proved() const { return height_mm > 0; }
};

/// A piece of a part's surface with the material above its middle, for pictures.
struct LeftPatch {
  std::array<Vec3, 3> corners{};
  double height_mm = 0;
};

/// The material that the whole program leaves on the parts.
struct ExcessFacts {
  double asked_mm = 0, resolution_mm = 0;
  double surface_mm2 = 0;                ///< area of the parts
  std::vector<ExcessPlaceFacts> places;  ///< proved ones first, the highest first
  std::vector<LeftPatch> patches;        ///< all pieces with more than asked; empty unless pictures are made

  [[nodiscard]] std::size_t proved() const {
    return static_cast<std::size_t>(
        std::count_if(places.begin(), places.end(), [](const ExcessPlaceFacts& place) { return place.is_proved(); }));
  }
};

/// The result for a whole path. verdicts.size() == toolpath.moves.size(); every move has exactly one state.
struct CheckResult {
  MoveVerdicts verdicts;
  std::vector<Event> events;            ///< in path order
  std::vector<FurtherContact> further;  ///< in path order, those of a move by depth; empty if only moves were checked
  StateCounts counts;
  double worst_depth_mm = 0;
  std::size_t worst_move = static_cast<std::size_t>(-1);
  double worst_overcut_mm = 0;                      ///< largest overcut of a gouge; 0 if none was measured
  double largest_gap_mm = 0;                        ///< largest depth_upper - depth over gouging moves, without
                                                    ///< those into stock
  std::uint64_t evaluations = 0;                    ///< number of computed bounds; the same on every run
  Assumptions assumptions;                          ///< facts on which the verdict rests; empty if only moves were
                                                    ///< checked
  std::optional<ClosestApproach> closest_approach;  ///< none: not measured, or nothing to measure
  std::optional<AnyTurnCounts> any_turn;            ///< none: not examined, or no clean move turns a rotary joint
  std::optional<StockFacts> stock;                  ///< none: not requested
  std::optional<ExcessFacts> excess;                ///< none: not requested
  PathFit fit;                                      ///< Kind::fits if it was not requested

  /// Returns the further contacts of a move.
  [[nodiscard]] std::span<const FurtherContact> further_of(std::size_t move) const;
};

/// Computes the events, the counts and the worst move of a result anew from its verdicts.
///
/// Neighbouring moves with the same state, tool, operation, body and counterpart form one event; events are in path
/// order. Buried moves form one event only if they have the same reason. Clean and not-checked moves are in no event.
void summarise(const Toolpath& toolpath, CheckResult& result);

}  // namespace gouge
