#include "tests/laws/expander_statements.h"

#include <algorithm>
#include <array>

#include "tests/laws/expander_words.h"

namespace gouge::laws {
bool StatementExpander::numbers(const Arguments& arguments, std::vector<double>& values) {
  if (arguments.empty() || !is_all_numbers(arguments)) {
    uncertainty("an argument that is no number");
    return false;
  }
  for (const LooseArgument& argument : arguments) values.push_back(*argument.number);
  return true;
}

void StatementExpander::step(const LooseStatement& statement) {
  line_ = statement.line;
  if (statement.is_comment) return comment(statement);
  if (statement.word == "PARTNO" && out_.motions.empty()) now_.unknown_word.clear();
  if (statement.is_text) return;
  if (statement.is_cut_off) return uncertainty("the file ends within a statement");
  if (is_meaningful(statement.word) || statement.word.starts_with("TLON,") || statement.word.starts_with("$$->"))
    return word(statement);
  if (is_passive(statement.word)) {
    if (!is_naming(statement.word) && !meaning_within(squeezed(statement.rest)).empty())
      return uncertainty("another statement within one of " + statement.word);
    return word(statement);
  }
  // Without its slash, or with a number glued to it: still that word, where a word is what it begins with.
  const std::string_view prefix = meaning_before_blank(statement.word);
  if (!prefix.empty() && statement.whole.find('/') == std::string::npos) {
    LooseStatement meant = statement;
    meant.word = prefix;
    std::string rest = squeezed(statement.whole) == statement.word ? statement.whole : std::string();
    for (std::size_t i = 0, seen = 0; i < rest.size(); ++i) {
      if (rest[i] != ' ' && rest[i] != '\t' && ++seen == prefix.size()) {
        rest.erase(0, i + 1);
        break;
      }
    }
    rest.erase(0, rest.find_first_not_of(" ,\t"));
    meant.rest = rest;
    meant.arguments = loose_arguments(rest);
    return word(meant);
  }
  if (statement.word.empty() || !((statement.word[0] >= 'A' && statement.word[0] <= 'Z'))) return wordless(statement);
  // Without its slash, a blank behind it ends a word that leaves the cutter where it is.
  const std::string_view whole = statement.whole;
  const std::size_t begin = std::min(whole.find_first_not_of(" \t"), whole.size());
  if (is_passive(whole.substr(begin, whole.find_first_of(" \t,\r\n", begin) - begin))) return;
  // A word that is in no list may mean anything, but for what stands before a program.
  now_.unknown_word = "'" + statement.word + "' is no word that is known";
  if (!out_.motions.empty()) uncertainty(now_.unknown_word);
}

// The lost end of another line, or the rest of a text.
void StatementExpander::wordless(const LooseStatement& statement) {
  const std::string text = squeezed(statement.whole);
  const std::size_t begin = std::min(text.find_first_not_of("/,"), text.size());
  if (text.find_first_of("+-.0123456789", begin) == begin && loose_arguments(text.substr(begin)).front().number)
    return uncertainty("a line without a word: '" + text + "'");
  const Arguments arguments = loose_arguments(text.substr(begin));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    for (const std::string_view modal : {"ON", "OFF", "MM", "INCH", "INCHES", "LEFT", "RIGHT", "FEDTO", "RAPTO",
                                         "RTRCTO", "DEPTH", "CLEAR", "RETURN"}) {
      if (arguments[i].text == modal) now_.lost_word = "a line without a word: '" + text + "'";
    }
    if (arguments[i].text == "TOOL" && i + 1 < arguments.size() && arguments[i + 1].number)
      now_.tool_uncertainty = "a line without a word: '" + text + "'";
  }
}

void StatementExpander::comment(const LooseStatement& statement) {
  const std::string text = squeezed(statement.rest);
  if (text.starts_with("OPERATIONNAME")) contradict_cycle("an operation");
  if (!is("apt-catia")) return;
  const Arguments row = loose_arguments(statement.rest);
  if (row.size() == 4 && is_all_numbers(row)) now_.matrix_uncertainty = "a row of a matrix that does not begin";
}

bool StatementExpander::is_matrix_begun(const LooseStatement& statement) {
  return statement.is_comment && squeezed(statement.rest).starts_with("*CATIA0");
}

std::size_t StatementExpander::matrix(const std::vector<LooseStatement>& statements, std::size_t begin) {
  line_ = statements[begin].line;
  interrupt("$$*CATIA0");
  std::vector<double> rows;
  std::size_t last = begin;
  for (std::size_t i = begin + 1; i < statements.size() && rows.size() < 12; ++i) {
    if (!statements[i].is_comment) {
      const std::size_t before = out_.motions.size();
      step(statements[i]);
      if (out_.motions.size() > before) break;
      continue;
    }
    const Arguments row = loose_arguments(statements[i].rest);
    const bool is_row = row.size() == 4 && is_all_numbers(row);
    if (!is_row && last > begin) break;
    last = i;
    if (!is_row) continue;
    for (const LooseArgument& argument : row) rows.push_back(*argument.number);
  }
  const bool goes_on = last + 1 < statements.size() && statements[last + 1].is_comment &&
                       loose_arguments(statements[last + 1].rest).size() == 4 &&
                       is_all_numbers(loose_arguments(statements[last + 1].rest));
  if (rows.size() != 12 || goes_on) {
    uncertainty("a matrix that is not whole");
    return last;
  }
  now_.matrix_uncertainty.clear();
  set_frame(
      {rows[3], rows[7], rows[11], rows[0], rows[4], rows[8], rows[1], rows[5], rows[9], rows[2], rows[6], rows[10]},
      true);
  return last;
}

void StatementExpander::contradict_cycle(std::string_view by) {
  if (now_.cycle && now_.cycle->contradicted.empty()) now_.cycle->contradicted = by;
  if (!now_.cycle) now_.positions_without_cycle = 0;  // nor would it stand in one whose beginning was lost
}

// Statements between the halves of a motion that has two statements.
void StatementExpander::interrupt(std::string_view word) {
  if (now_.arc) uncertainty(std::string(word) + " where the end of an arc must come");
  if (now_.direction) uncertainty(std::string(word) + " where TLON must come");
  end_spline();
}

void StatementExpander::begin_section(std::string_view by, bool is_swept_into) {
  interrupt(by);
  contradict_cycle(by);
  if (!is_swept_into) now_.at.reset();
  now_.positions_without_cutcom = 0;
  now_.has_block_moved = false;
}

void StatementExpander::end_of_file() {
  interrupt("the end of the file");
  // Its end may have been lost behind any of its holes; one hole it must have.
  if (now_.cycle && now_.cycle->holes > 1)
    uncertainty("the cycle of line " + std::to_string(now_.cycle->line) + " never ends");
}

void StatementExpander::word(const LooseStatement& s) {
  std::vector<double> v;
  if (s.word == "RAPID") {
    now_.is_rapid = true;
    return contradict_cycle("RAPID");
  }
  if (s.word == "FEDRAT") {
    // Before the first hole some write the feed of the cycle.
    const bool may_have_one = is("apt") || is("apt-nccs") || is("goto-list");
    const bool never_has_one = !may_have_one && !is("apt-camplete") && !is("apt-mori") && !is("apt-autodesk");
    if (never_has_one || (may_have_one && now_.cycle && now_.cycle->last_hole)) contradict_cycle("FEDRAT");
    return;
  }
  if (s.word == "CNTRL" || s.word == "KNOT") {
    if (!now_.is_spline_open) return uncertainty(s.word + " outside a spline");
    if (!numbers(s.arguments, v)) return;
    if (s.word == "KNOT") {
      now_.knots.insert(now_.knots.end(), v.begin(), v.end());
    } else if (v.size() != 3)
      uncertainty("CNTRL without three numbers");
    else
      now_.control.push_back(now_.frame.placed(now_.mm * Vec3(v[0], v[1], v[2])));
    return;
  }
  constexpr std::array<std::string_view, 11> kBetween{"GOTO",   "TLON",  "MULTAX", "TLAXIS", "TRNTYP", "MODE",
                                                      "CUTCOM", "UNITS", "UNIT",   "CUTTER", "TLDATA"};
  const bool is_load = s.word == "LOADTL" || s.word == "LOAD" || s.word == "TOOLNO";
  if (is_meaningful(s.word) && !is_load && std::find(kBetween.begin(), kBetween.end(), s.word) == kBetween.end())
    interrupt(s.word);
  if (s.word == "GOTO") {
    if (now_.direction) return uncertainty("GOTO where TLON must come");
    end_spline();
    if (numbers(s.arguments, v)) positions(v);
  } else if (s.word == "GODLTA") {
    if (numbers(s.arguments, v)) step_by(v);
  } else if (s.word == "FROM" || s.word == "GOHOME") {
    contradict_cycle(s.word);
    if (s.arguments.empty()) {
      if (s.word == "FROM") return uncertainty("FROM without a place");
      now_.at.reset();
    } else if (numbers(s.arguments, v))
      from(v, s.word == "GOHOME");
  } else if (s.word == "CIRCLE" || s.word == "MOVARC") {
    contradict_cycle(s.word);
    arc(s);
  } else if (s.word == "INDIRV") {
    contradict_cycle(s.word);
    if (!numbers(s.arguments, v)) return;
    if (v.size() != 3) return uncertainty("INDIRV without three numbers");
    now_.direction = now_.frame.turned(Vec3(v[0], v[1], v[2]));
  } else if (s.word.starts_with("TLON")) {
    chained_line(s);
  } else if (s.word == "NURBS") {
    contradict_cycle(s.word);
    now_.is_spline_open = true;
  } else if (s.word == "UNITS" || s.word == "UNIT") {
    unit(s.arguments);
  } else if (s.word == "MULTAX") {
    multax(s.arguments);
  } else if (s.word == "CYCLE") {
    cycle(s.arguments);
  } else if (s.word == "CUTCOM") {
    cutcom(s.arguments);
  } else if (s.word == "LOADTL" || s.word == "LOAD" || s.word == "TOOLNO") {
    tool_number(s.word, s.arguments);
  } else if (s.word == "CUTTER" || s.word == "TLDATA") {
    tool_data(s);
  } else if (s.word == "TLAXIS") {
    if (!numbers(s.arguments, v)) return;
    if (v.size() != 3) return uncertainty("TLAXIS without three numbers");
    now_.plain_axis = Vec3(v[0], v[1], v[2]);
    if (is("camworks-clt") && now_.plain_axis != Vec3::UnitZ()) uncertainty("TLAXIS of a turned setup");
  } else if (s.word == "MSYS" || s.word == "MCS") {
    if (is("nx-clsf") && !now_.is_block_open) return uncertainty("MSYS outside a block");
    if (!numbers(s.arguments, v)) return;
    if (v.size() == 9 && s.word == "MSYS")
      set_frame(v, false);
    else if (v.size() == 12 && s.word == "MCS")
      set_frame({v[9], v[10], v[11], v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]}, true);
    else
      uncertainty("a frame without its numbers");
  } else if (s.word == "MCSYS") {
    mori_frame(s.arguments);
  } else if (s.word == "TRANS" || s.word == "ORIGIN" || s.word == "ROTABL") {
    zeros(s.arguments, s.word == "ROTABL" ? 3 : 0);
  } else if (s.word == "TRNTYP") {
    if (s.arguments.empty() || s.arguments.front().text != "WORLD") return uncertainty("TRNTYP other than WORLD");
    zeros(Arguments(s.arguments.begin() + 1, s.arguments.end()), 0);
  } else if (s.word == "MODE") {
    if (is_one_letter_away(squeezed(s.rest), "TURN")) uncertainty("a turning tool");
  } else if (s.word == "TOOLPATH") {
    begin_section("TOOL PATH", false);
    now_.tool_uncertainty.clear();
    now_.is_block_open = true;
    now_.axis = Vec3::UnitZ();
    now_.frame = {};
    now_.is_frame_said = false;
    // The same tool again needs no other TLDATA.
    const std::string tool = s.rest.substr(std::min(s.rest.find(",TOOL,"), s.rest.size()));
    if (tool != now_.tool_name || tool.empty()) {
      now_.tool.reset();
      now_.diameter_mm.reset();
    }
    now_.tool_name = tool;
    now_.is_cutter_new = false;
    now_.known_tools.clear();
  } else if (s.word == "END-OF-PATH") {
    begin_section(s.word, false);
    now_.is_block_open = false;
  } else if (s.word == "CSI_TOOL_PATH") {
    begin_section(s.word, true);
    now_.is_frame_said = false;
  } else if (s.word == "OPNAME" || s.word == "OPFEATSTART" || s.word == "OPFEATEND") {
    begin_section(s.word, true);
  } else if (s.word.starts_with("$$->FEATNO")) {
    begin_section("FEATNO", false);
    now_.is_cutter_centre = false;
  } else if (s.word == "$$->CUTTER") {
    const std::optional<double> stated = s.arguments.empty() ? std::nullopt : s.arguments.front().number;
    if (now_.stated_diameter != stated) now_.at.reset();
    now_.stated_diameter = stated;
  } else if (s.word == "$$->CUTCOM_GEOMETRY_TYPE") {
    now_.is_cutter_centre = squeezed(s.rest) == "OUTPUT_ON_CENTER";
  } else if (s.word.starts_with("$$->") || is_passive(s.word)) {
    return;
  } else {
    uncertainty(s.word + " may move or shift");
  }
}

}  // namespace gouge::laws
