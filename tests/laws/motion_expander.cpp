#include "tests/laws/motion_expander.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "tests/laws/expander_statements.h"
#include "tests/laws/expander_words.h"

namespace gouge::laws {
namespace {

// The unit of the first UNITS of the file, else of its feeds.
double first_unit(const std::vector<LooseStatement>& statements, Expansion& expansion) {
  bool inch = false, mm = false;
  for (const LooseStatement& statement : statements) {
    for (const LooseArgument& argument : statement.arguments) {
      if ((statement.word == "UNITS" || statement.word == "UNIT") && argument.text == "MM") return 1;
      if ((statement.word == "UNITS" || statement.word == "UNIT") && argument.text.starts_with("INCH")) return 25.4;
      if (statement.word != "FEDRAT") continue;
      inch = inch || argument.text == "IPM" || argument.text == "IPR";
      mm = mm || argument.text == "MMPM" || argument.text == "MMPR";
    }
  }
  if (inch && mm) expansion.uncertainties.push_back({1, "feeds in mm and in inches, and no unit"});
  return inch ? 25.4 : 1;
}

// Within a line: what stands before it may be a line of its own.
bool holds_lone_return(std::string_view bytes) {
  bool has_text = false, has_return = false;
  for (const char c : bytes) {
    if (c == '\n')
      has_text = has_return = false;
    else if (c == '\r')
      has_return = has_text;
    else if (c != ' ' && has_return)
      return true;
    else if (c != ' ')
      has_text = true;
  }
  return false;
}

}  // namespace

Expansion expand_motions(std::string_view bytes, std::string_view dialect, const std::set<int>& library_tools) {
  if (dialect == "mastercam-nci") return expand_nci(bytes);
  Expansion expansion;
  const std::vector<LooseStatement> statements = loose_statements(bytes);
  StatementExpander expander(dialect, expansion);
  expander.reading().library_tools = library_tools;
  expander.reading().mm = first_unit(statements, expansion);
  for (const LooseStatement& statement : statements) {
    if (statement.word == "MSYS") expander.reading().has_frames = true;
    if (statement.word != "MCS") continue;
    constexpr std::array<double, 12> kOwn{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    for (std::size_t i = 0; i < statement.arguments.size(); ++i) {
      const double value = statement.arguments[i].number.value_or(-1);
      if (i >= kOwn.size() || std::abs(value - kOwn[i]) > 1e-9) expander.reading().has_frames = true;
    }
  }
  if (holds_lone_return(bytes)) expansion.uncertainties.push_back({1, "a carriage return within a line"});
  for (std::size_t i = 0; i < statements.size() && expansion.uncertainties.empty(); ++i) {
    if (expander.is_matrix_begun(statements[i]))
      i = expander.matrix(statements, i);
    else
      expander.step(statements[i]);
  }
  if (expansion.uncertainties.empty()) expander.end_of_file();
  return expansion;
}

}  // namespace gouge::laws
