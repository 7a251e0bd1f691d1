#include "postproc/gcode/iso/other_program.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "lib/base/letters.h"
#include "lib/base/number_text.h"
#include "postproc/gcode/lexing/block_lexer.h"
#include "postproc/gcode/lexing/variables.h"

namespace gouge {
namespace {

using Meaning = GcodeMeaning;

/// Lines from the name of a program, or a percent sign, to the next one.
struct Section {
  std::string name;             ///< "O1000"; empty: none
  std::size_t name_line = 0;    ///< line of the name
  bool is_behind_mark = false;  ///< behind the percent sign that ends the program
  std::size_t last_run = 0;     ///< line of its last block that ran; 0: none
  // Of the blocks behind it:
  std::size_t motion_line = 0;  ///< first block that moves, or calls a program; 0: none
  std::string end;              ///< last code that ends the program, or returns from it; empty: none
  bool is_subprogram = false;   ///< that code is M99

  /// Notes a block that runs. What stands before it is not behind the end.
  void note_run(std::size_t line) {
    last_run = line;
    motion_line = 0;
    end.clear();
    is_subprogram = false;
  }
};

/// Returns the name of a program at the start of a line, "O1000" or ":1000"; empty: there is none.
std::string name_of_program(std::string_view line) {
  if (line.empty() || (capital(line[0]) != 'O' && line[0] != ':')) return {};
  std::size_t end = 1;
  while (end < line.size() && (is_digit(line[end]) || line[end] == ' ')) ++end;
  const std::string_view number = trim_blanks(line.substr(1, end - 1));
  return number.empty() ? std::string() : std::string(1, line[0]) + std::string(number);
}

class OtherPrograms {
 public:
  OtherPrograms(const ProgramText& text, const CodeIndex& index, const std::vector<bool>& has_run, bool may_jump)
      : text_(text), index_(index), has_run_(has_run), may_jump_(may_jump) {}

  std::optional<OtherProgram> find() {
    for (std::size_t i = 0; i < text_.size() && !found_; ++i) take_line(i);
    end_section();
    return found_;
  }

 private:
  void take_line(std::size_t i) {
    const std::string_view line = trim_blanks(text_.line(i));
    if (line.starts_with('%')) return begin_section({}, i);
    if (std::string name = index_.control().syntax.has_o_words ? std::string() : name_of_program(line); !name.empty())
      begin_section(std::move(name), i);
    if (has_run_[i]) return section_.note_run(text_.number(i));
    take_block(line, i);
  }

  void begin_section(std::string name, std::size_t i) {
    end_section();
    section_ = Section{};
    section_.name = std::move(name);
    section_.name_line = text_.number(i);
    section_.is_behind_mark = text_.has_end_mark() && i >= text_.end();
    is_in_sub_ = false;
  }

  void take_block(std::string_view line, std::size_t i) {
    read_gcode_block(line, index_.control().syntax, variables_, block_);
    if (index_.control().syntax.has_o_words && !block_.flow.empty()) return take_o_word();
    if (!block_.error.empty() || is_in_sub_) return;
    const auto is_motion = [&](const GcodeWord& word) {
      return std::string_view("XYZABC").find(word.letter) != std::string_view::npos;
    };
    bool moves = std::ranges::any_of(block_.words, is_motion);
    for (const GcodeWord& word : block_.words) {
      const GcodeRow* const row = word.letter == 'M' ? index_.row(word) : nullptr;
      if (row == nullptr) continue;
      moves = moves || row->meaning == Meaning::call_program || row->meaning == Meaning::call_block;
      const bool is_back = row->meaning == Meaning::return_from_call;
      if (!is_back && row->meaning != Meaning::program_end) continue;
      section_.end = code_text(row->letter, row->number);
      section_.is_subprogram = is_back;
    }
    if (moves && section_.motion_line == 0) section_.motion_line = text_.number(i);
  }

  // The lines of a subprogram of LinuxCNC run by a call alone.
  void take_o_word() {
    const std::string flow = in_small_letters(std::string(block_.flow));
    if (flow.find("endsub") != std::string::npos)
      is_in_sub_ = false;
    else if (flow.find("sub") != std::string::npos)
      is_in_sub_ = true;
  }

  void end_section() {
    const Section& one = section_;
    if (found_ || one.motion_line == 0 || (one.is_subprogram && !one.is_behind_mark)) return;
    const std::string end = one.end.empty() ? "" : ", which ends with " + one.end + ",";
    if (!one.name.empty() && one.last_run == 0)
      found_ = OtherProgram{"program " + one.name + end + " is in the file and does not run", one.name_line};
    else if (one.is_behind_mark)
      found_ =
          OtherProgram{"blocks stand behind the percent sign that ends the program, and do not run", one.motion_line};
    else if (one.last_run > 0 && !may_jump_)
      found_ = OtherProgram{"blocks stand behind the end of the program in line " + std::to_string(one.last_run) +
                                ", and no jump or call leads to them",
                            one.motion_line};
  }

  const ProgramText& text_;
  const CodeIndex& index_;
  const std::vector<bool>& has_run_;
  bool may_jump_;
  const GcodeVariables variables_;
  GcodeBlock block_;
  Section section_;
  bool is_in_sub_ = false;
  std::optional<OtherProgram> found_;
};

}  // namespace

std::optional<OtherProgram> find_other_program(const ProgramText& text, const CodeIndex& index,
                                               const std::vector<bool>& has_run, bool may_jump) {
  return OtherPrograms(text, index, has_run, may_jump).find();
}

}  // namespace gouge
