#pragma once

#include "postproc/cldata/interpreting/states.h"

// Handlers of the words: one function for each word that concerns more than one state, and a table from word to
// function.

namespace gouge {

using WordHandler = void (*)(States&);

/// Returns the function that takes the statement of `s.in`, whose arguments are split.
[[nodiscard]] WordHandler handler_of(Word word);

// motion_words.cpp
void take_goto(States& s);
void take_from(States& s);
void take_godlta(States& s);
void take_gohome(States& s);
void take_rapid(States& s);
void take_retract(States& s);
void take_clear_plane(States& s);
void take_fedrat(States& s);
void take_cutcom(States& s);

// curve_words.cpp
void take_arc(States& s);
void take_unread_curve(States& s);
void take_tlon(States& s);
void take_arc_record(States& s);
void take_arc_slope(States& s);
void take_helical(States& s);
/// Takes BEGIN NURBS_.. to END NURBS of CATIA. Returns whether the statement is part of it, and was taken.
[[nodiscard]] bool take_control_nurbs(States& s);

// nurbs_state.cpp
void take_movnrb(States& s);

// part_program.cpp
void take_index(States& s);
void take_copy(States& s);

// cycle_state.cpp
void take_cycle(States& s);

// tool_state.cpp
void take_tool_number(States& s);
void take_load(States& s);

// control_words.cpp
void take_insert(States& s);
void settle_insert(States& s, Word next);
void take_prefun(States& s);
void take_auxfun(States& s);
void take_setup(States& s);
void take_select(States& s);
void take_opskip(States& s);

// frame_state.cpp
void set_frame(States& s, const RigidTransform& to_part, bool says_axis = false);
void note_creo_csys(States& s);
void take_csys(States& s);
void take_camera(States& s);
void take_mcs(States& s);
void take_mcsys(States& s);
void take_msys(States& s);
void take_rotabl(States& s);
void take_trntyp(States& s);
void take_trans(States& s);
void take_mode(States& s);
void take_tlaxis(States& s);
void take_units(States& s);

// block_words.cpp
void take_tool_path(States& s);
void take_end_of_path(States& s);
void take_operation(States& s);
void take_fini(States& s);
void end_program(States& s);
void take_free_text(States& s);
void take_pprint(States& s);
void take_ppword(States& s);
void take_syn(States& s);
void take_comment(States& s);

// unread_words.cpp
void take_harmless(States& s);
void take_part_program(States& s);
void take_unknown(States& s);
void take_unread_motion(States& s);
void take_repeat(States& s);
void take_unread_frame(States& s);
void take_unread_tool(States& s);

}  // namespace gouge
