#include "postproc/cldata/interpreting/word_handlers.h"

#include <array>
#include <cstddef>
#include <utility>

namespace gouge {
namespace {

constexpr std::size_t kWords = 256;

constexpr auto kRows = std::to_array<std::pair<Word, WordHandler>>({
    {Word::comment, take_comment},
    {Word::harmless, take_harmless},
    {Word::free_text, take_free_text},
    {Word::pprint, take_pprint},
    {Word::insert, take_insert},
    {Word::tprint, [](States& s) { s.tool.take_name(s.in.first_piece()); }},
    {Word::operation, take_operation},
    {Word::part_program, take_part_program},
    {Word::curve, take_unread_curve},
    {Word::arc_record, take_arc_record},
    {Word::arc_slope, take_arc_slope},
    {Word::auxfun, take_auxfun},
    {Word::camera, take_camera},
    {Word::circle, take_arc},
    {Word::copy, take_copy},
    {Word::csys, take_csys},
    {Word::cntrl, [](States& s) { s.nurbs.take_control_point(); }},
    {Word::cutcom, take_cutcom},
    {Word::cutter, [](States& s) { s.tool.take_cutter(s.frame.mm_per_unit(), s.previous_word == Word::insert); }},
    {Word::cycle, take_cycle},
    {Word::end_of_path, take_end_of_path},
    {Word::fedrat, take_fedrat},
    {Word::fini, take_fini},
    {Word::flute_length, [](States& s) { s.tool.take_flute_length(s.frame.mm_per_unit()); }},
    {Word::extension_length, [](States& s) { s.tool.take_stickout(s.frame.mm_per_unit()); }},
    {Word::from, take_from},
    {Word::godlta, take_godlta},
    {Word::gohome, take_gohome},
    {Word::go_to, take_goto},
    {Word::helical, take_helical},
    {Word::index, take_index},
    {Word::indirv, [](States& s) { s.curve.begin_tangent(); }},
    {Word::knot, [](States& s) { s.nurbs.take_knots(); }},
    {Word::load, take_load},
    {Word::loadtl, take_tool_number},
    {Word::mcs, take_mcs},
    {Word::mcsys, take_mcsys},
    {Word::mode, take_mode},
    {Word::movarc, take_arc},
    {Word::movnrb, take_movnrb},
    {Word::msys, take_msys},
    {Word::multax, [](States& s) { s.axes.take_multax(); }},
    {Word::nurbs, [](States& s) { s.nurbs.begin(); }},
    {Word::opskip, take_opskip},
    {Word::ppword, take_ppword},
    {Word::prefun, take_prefun},
    {Word::rapid, take_rapid},
    {Word::retrct, take_retract},
    {Word::clear_plane, take_clear_plane},
    {Word::rotabl, take_rotabl},
    {Word::select, take_select},
    {Word::setup, take_setup},
    {Word::syn, take_syn},
    {Word::tldata, [](States& s) { s.tool.take_tldata(s.frame.mm_per_unit()); }},
    {Word::tlaxis, take_tlaxis},
    {Word::tlon, take_tlon},
    {Word::tool_path, take_tool_path},
    {Word::toolno, take_tool_number},
    {Word::trans, take_trans},
    {Word::trntyp, take_trntyp},
    {Word::turret, [](States& s) { s.uncertainties.set(Uncertainty::turning, s.in.because(Reasons::kTurning)); }},
    {Word::units, take_units},
    {Word::repeat, take_repeat},
    {Word::unread_frame, take_unread_frame},
    {Word::unread_motion, take_unread_motion},
    {Word::unread_tool, take_unread_tool},
});

constexpr std::array<WordHandler, kWords> make_table() {
  std::array<WordHandler, kWords> table{};
  table.fill(take_unknown);
  for (const auto& [word, handler] : kRows) table[static_cast<std::size_t>(word)] = handler;
  return table;
}

constexpr std::array<WordHandler, kWords> kHandlers = make_table();

// Tests that each word except `unknown` has a row. It compares words, because under a sanitizer addresses of functions
// cannot be compared at compile time.
constexpr bool is_complete() {
  for (std::size_t word = 0; word <= static_cast<std::size_t>(Word::unread_tool); ++word) {
    bool has_row = false;
    for (const auto& row : kRows) has_row = has_row || row.first == static_cast<Word>(word);
    if (has_row == (static_cast<Word>(word) == Word::unknown)) return false;
  }
  return true;
}
static_assert(is_complete());

}  // namespace

WordHandler handler_of(Word word) { return kHandlers[static_cast<std::size_t>(word)]; }

}  // namespace gouge
