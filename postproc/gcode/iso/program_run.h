#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/base/parallel.h"
#include "postproc/gcode/iso/block_runner.h"
#include "postproc/gcode/lexing/block_lexer.h"
#include "postproc/gcode/lexing/variables.h"
#include "postproc/gcode/running/block_structures.h"
#include "postproc/gcode/running/program_text.h"

namespace gouge {

/// The order in which the blocks of a program run: calls, jumps, loops and conditions.
class ProgramRun {
 public:
  /// All must outlive the object. `text`: of the program that is called first.
  ProgramRun(const ControlTable& control, const ProgramSetup& setup, const ProgramText& text, BlockRunner& runner,
             ProgramMotion& motion);

  /// Runs blocks in force at the start; one a line.
  void run_start(std::string_view blocks);
  /// Runs the program to its end, or until nothing after it is known.
  void run(const ProgressCall& progress, const std::string& file);

  /// Returns the line of the block that ends the program; 0: it has none.
  [[nodiscard]] std::size_t end_line() const { return end_line_; }
  /// Returns whether the program begins again at its end.
  [[nodiscard]] bool begins_again() const { return begins_again_; }
  /// Returns whether a condition, a jump or a switch of the control ran, so that other values may run other blocks.
  [[nodiscard]] bool may_jump() const { return may_jump_; }

 private:
  /// Place to which a call returns, and how often it runs again.
  struct Call {
    const ProgramText* text = nullptr;
    std::size_t back = 0, begin = 0;
    int times = 1;
    bool has_locals = false;
    std::string label = {};  ///< of a subprogram of LinuxCNC
  };
  /// A repeat of LinuxCNC that runs.
  struct Loop {
    std::string label;
    const ProgramText* text = nullptr;
    std::size_t begin = 0, end = 0;  ///< lines of repeat and endrepeat
    std::size_t depth = 0;
    long long left = 0;
  };
  /// The first block of a subprogram of LinuxCNC.
  struct Sub {
    const ProgramText* text = nullptr;
    std::size_t begin = 0;
  };

  void run_block();
  [[nodiscard]] bool is_left_out();
  [[nodiscard]] bool names_program(std::string_view line);
  [[nodiscard]] static std::string_view behind_name(std::string_view line);
  void follow(const NextBlock& next);
  void lose_at_system_variable(const std::vector<GcodeAssignment>& assignments);
  void assign(const std::vector<GcodeAssignment>& assignments);
  void call(const NextBlock& next);
  [[nodiscard]] bool may_count_repeats(int program) const;
  void begin_call(const ProgramText& text, std::size_t begin, int times, bool has_locals);
  void end_call();
  const ProgramText* beside(const std::string& name);
  void lose(const std::string& reason);

  // Fanuc's custom macros.
  void run_macro(std::string_view flow);
  /// Returns the block with a number in the program that runs; none, or more than one: nothing.
  [[nodiscard]] std::optional<std::size_t> find_block(int number) const;
  void go_to(int number);
  /// Returns the loops of the program that runs.
  [[nodiscard]] const BlockStructures& loops_of_macro();
  void repeat_loop(int number);
  void end_loop(int number);
  // LinuxCNC's O-words.
  void run_o_word(std::string_view flow);
  [[nodiscard]] bool is_first_block() const;
  /// Returns the subprograms, conditions and loops of the text that runs.
  [[nodiscard]] const BlockStructures& o_word_structures();
  /// Returns whether the switch for block delete leaves the block out.
  [[nodiscard]] bool is_deleted(std::size_t index) const;
  void define_sub(const std::string& label, std::string_view rest);
  [[nodiscard]] std::optional<Sub> find_sub(const std::string& label);
  [[nodiscard]] bool is_in_structure(std::size_t index) const;
  void call_o_word(const std::string& label, std::string_view arguments);
  [[nodiscard]] bool has_open_repeat() const;
  void jump_to(std::size_t index);
  [[nodiscard]] bool may_have_broken();
  void run_o_loop(const std::string& label, const std::string& word, std::string_view rest);
  void run_o_condition(const std::string& label, const std::string& word, std::string_view rest);
  [[nodiscard]] std::optional<std::size_t> find_o_word(const std::string& label, std::string_view words,
                                                       bool is_forward) const;
  [[nodiscard]] std::string o_word_at(std::size_t index, const std::string& label) const;

  [[nodiscard]] double value_of(std::string_view& text);
  [[nodiscard]] std::optional<bool> condition(std::string_view& text);

  const ControlTable& control_;
  const ProgramSetup& setup_;
  BlockRunner& runner_;
  ProgramMotion& motion_;
  GcodeVariables variables_;
  GcodeBlock block_;
  const ProgramText* main_;
  const ProgramText* text_;
  std::size_t at_ = 0, next_ = 0;  // the block that runs, and the next one
  std::size_t main_at_ = 0;        // the block of the file that runs, or calls
  std::vector<Call> calls_;
  std::vector<Loop> loops_;
  std::map<std::string, Sub> subs_;  // defined by what has run, by their labels
  std::size_t searched_texts_ = 0;   // for a break
  bool has_break_ = false;
  std::map<std::string, StoredProgram> besides_;
  /// Structures of the programs that ran, by text and first line.
  std::map<std::pair<const ProgramText*, std::size_t>, BlockStructures> structures_;
  std::size_t end_line_ = 0;
  bool has_ended_ = false, begins_again_ = false, may_jump_ = false;
};

}  // namespace gouge
