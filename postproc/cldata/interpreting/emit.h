#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/states.h"

// Makes moves of positions, and applies the effects of a statement on moves before it.

namespace gouge {

/// The moves to `position`: one, or those of a hole.
void emit(States& s, const Position& position);
/// A motion of unknown end stands where the last one ended, so that it is reported as a move not checked. It
/// is that of `statement`, or of the one being taken.
void emit_unread(States& s, const char* reason, std::size_t statement);
inline void emit_unread(States& s, const char* reason = Reasons::kUnread) { emit_unread(s, reason, s.in.index()); }
/// The last move has further readings: another way from `start` over `ends`, in part coordinates, of which the last is
/// where it ends. It is checked in all of them, and only where all are clean it is clean; else it is not checked, for
/// `reason`.
void emit_other_way(States& s, const Position& position, const Pose& start, std::span<const Pose> ends,
                    const char* reason);
/// A further reading of the positions that follow: along `curve` from where the tool stands, where it then still
/// stands.
void emit_curve_reading(States& s, const Move& curve);
/// The last move, an arc, may run the other way round as well.
void emit_turned_round(States& s);
/// Nothing is swept from the last position to the next.
void break_motion(States& s);

/// Moves [begin, end) are not checked, unless they have another reason.
void mark_moves_uncertain(States& s, std::size_t begin, std::size_t end, std::string_view reason);
/// A word with an OFF of its own switches `doubt`, for `reason`. An OFF that ends nothing makes moves doubtful: the
/// state it should end may have begun anywhere since the last tool, operation or OFF.
void switch_uncertainty(States& s, Uncertainty uncertainty, bool is_on, const char* reason);
void mark_run_uncertain(States& s, std::size_t begin);
/// The cycle in force should have ended.
void mark_cycle_uncertain(States& s);
/// A motion that is announced and not finished: where it ends unknown.
void drop_described_curve(States& s);
/// The statements of a NURBS are all read.
void end_nurbs(States& s);

// The steps of emit().
[[nodiscard]] Move make_move(States& s, const Position& position, MoveKind kind);
void append(States& s, Move move, const Position& position);
/// A move with its record, which changes no state.
void push_move(States& s, const Move& move, const Position& position);
void emit_hole(States& s, const Position& position, const DrillCycle& cycle);

}  // namespace gouge
