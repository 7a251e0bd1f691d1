#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "postproc/cldata/interpreting/motion_records.h"
#include "postproc/cldata/interpreting/reasons.h"
#include "postproc/cldata/interpreting/states.h"

// Functions that make moves from positions, and apply the effects of a statement to earlier moves.

namespace gouge {

/// Resolves the tool. Its definitions up to here belong to the motion that begins.
void resolve_tool(States& s);
/// Emits the moves to `position`: one move, or those of a hole.
void emit(States& s, const Position& position);
/// Emits a motion with an unknown end. It stands at the end of the last motion, so that it is reported as a move that
/// is not checked. It belongs to `statement`, by default the present one.
void emit_unread(States& s, const char* reason, std::size_t statement);
inline void emit_unread(States& s, const char* reason = Reasons::kUnread) { emit_unread(s, reason, s.in.index()); }
/// Adds further readings of the last move: another way from `start` through `ends`, in part coordinates. The last of
/// `ends` is the end of the move. The move is clean only if all readings are clean; else it is not checked, for
/// `reason`.
void emit_other_way(States& s, const Position& position, const Pose& start, std::span<const Pose> ends,
                    const char* reason);
/// Adds a further reading of the positions that follow: a motion along `curve` from the position of the tool. The tool
/// stays there for the other reading.
void emit_curve_reading(States& s, const Move& curve);
/// Adds the reading that the last move, an arc, runs with the opposite sense.
void emit_turned_round(States& s);
/// Breaks the motion: nothing is swept from the last position to the next.
void break_motion(States& s);

/// Marks moves [begin, end) as not checked, unless they have another reason.
void mark_moves_uncertain(States& s, std::size_t begin, std::size_t end, std::string_view reason);
/// Switches an uncertainty for a word with its own OFF, for `reason`. An OFF without an ON makes moves uncertain: the
/// state that it ends may have begun anywhere since the last tool, operation or OFF.
void switch_uncertainty(States& s, Uncertainty uncertainty, bool is_on, const char* reason);
void mark_run_uncertain(States& s, std::size_t begin);
/// Marks moves as uncertain because the cycle in force should have ended.
void mark_cycle_uncertain(States& s);
/// Drops a motion that is announced but not finished; its end is unknown.
void drop_described_curve(States& s);
/// Ends a NURBS whose statements are all read.
void end_nurbs(States& s);

// Steps of emit().
[[nodiscard]] Move make_move(States& s, const Position& position, MoveKind kind);
void append(States& s, Move move, const Position& position);
/// Appends a move with its record, without a change of state.
void push_move(States& s, const Move& move, const Position& position);
void emit_hole(States& s, const Position& position, const DrillCycle& cycle);

}  // namespace gouge
