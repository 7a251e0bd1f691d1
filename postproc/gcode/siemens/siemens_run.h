#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/base/parallel.h"
#include "postproc/gcode/running/block_structures.h"
#include "postproc/gcode/running/program_text.h"
#include "postproc/gcode/siemens/siemens_block.h"
#include "postproc/gcode/siemens/siemens_runner.h"
#include "postproc/gcode/siemens/siemens_variables.h"

namespace gouge {

/// The order in which the blocks of a Siemens program run: calls, jumps, loops, repetitions and conditions.
/// Source   Siemens, NC programming, 12/2019, 6FC5398-2EP40-0BA0, 3.1 "Flexible NC programming".
class SiemensRun {
 public:
  /// All must outlive the object. `text`: of the program that is called first.
  SiemensRun(const ProgramInput& input, const ProgramText& text, SiemensRunner& runner);

  /// Runs blocks in force at the start; one a line.
  void run_start(std::string_view blocks);
  /// Runs the program to its end, or until nothing after it is known.
  void run();

  /// Returns the line of the block that ends the program; 0: it has none.
  [[nodiscard]] std::size_t end_line() const { return end_line_; }
  /// Returns whether a jump, a condition or a switch of the control ran, so that other values may run other blocks.
  [[nodiscard]] bool may_jump() const { return may_jump_; }

 private:
  using Labels = std::unordered_map<std::string, std::vector<std::size_t>>;
  struct Text {
    const ProgramText* program = nullptr;
    std::optional<Labels> labels;                    ///< lines by label and by block number; none: not looked for yet
    std::optional<BlockStructures> structures = {};  ///< none: not looked for yet
  };
  struct BesideText {
    explicit BesideText(std::string bytes) : program(std::move(bytes)), text{&program.text(), {}, {}} {}
    StoredProgram program;
    Text text;
  };
  /// A subprogram, or a section that is repeated, and where it returns to.
  struct Call {
    Text* text = nullptr;
    std::size_t back = 0, begin = 0;
    std::size_t end = std::numeric_limits<std::size_t>::max();  ///< of a section: behind its last line
    int times = 1;
    bool is_section = false;
  };

  void run_block();
  [[nodiscard]] bool is_left_out(bool is_skippable, bool is_empty);
  void follow(const SiemensNext& next);
  [[nodiscard]] static bool holds_other_program(std::string_view bytes, const std::string& name);
  [[nodiscard]] bool holds_program(const std::string& name) const;
  void call(const SiemensNext& next);
  void set(const std::string& variable, double value);
  void find_replaced_cycle();
  void begin_call(Text& text, std::size_t begin, std::size_t end, int times, bool is_section);
  void end_call();
  [[nodiscard]] std::vector<std::string> texts_beside(const std::string& name, const std::string& ending) const;
  [[nodiscard]] Text* beside(const std::string& name);
  void lose(const std::string& reason);

  // Statements of program flow.
  void run_flow(const std::string& word, std::string_view rest);
  /// Returns why the conditions and loops of the program that runs are not nested; empty: they are, or none runs here.
  [[nodiscard]] std::string structure_fault();
  [[nodiscard]] const BlockStructures& structures();
  void run_if(std::string_view rest);
  void run_conditional_jumps(bool holds, std::string_view rest);
  void run_loop(const std::string& word, std::string_view rest);
  void run_loop_end(const std::string& word, std::string_view rest);
  void run_for(std::string_view rest, bool is_next);
  void go_to(const std::string& word, std::string_view target);
  void repeat(const std::string& word, std::string_view rest);
  void declare(std::string_view rest);
  void run_proc(std::string_view rest);
  void declare_program(std::string_view rest);
  [[nodiscard]] std::optional<std::size_t> find_pair(std::size_t from, std::string_view opening,
                                                     std::string_view closing, bool is_forward) const;
  [[nodiscard]] std::optional<std::size_t> find_branch() const;
  [[nodiscard]] bool has_mark_at(std::size_t index) const;
  [[nodiscard]] bool is_deleted(std::size_t index) const;
  [[nodiscard]] bool is_open_at(std::size_t index) const;
  [[nodiscard]] std::string flow_at(std::size_t index) const;
  [[nodiscard]] std::string_view flow_rest_at(std::size_t index, std::string_view word) const;
  [[nodiscard]] const Labels& labels();
  [[nodiscard]] static std::string one_spelling(const std::string& label);
  [[nodiscard]] std::optional<std::size_t> only_line_of(const std::string& label);
  void jump(std::size_t index);
  void jump_behind(std::size_t index);
  [[nodiscard]] std::optional<bool> condition(std::string_view& text);
  [[nodiscard]] std::optional<double> value_of(std::string_view& text);

  const ProgramInput& input_;
  SiemensRunner& runner_;
  SiemensVariables variables_;
  SiemensBlock block_;
  const ProgramText* main_;
  Text main_text_;
  Text* text_;
  std::size_t at_ = 0, next_ = 0;  // the block that runs, and the next one
  std::size_t main_at_ = 0;        // the block of the file that runs, or calls
  std::vector<Call> calls_;
  std::map<std::string, BesideText> besides_;
  std::map<std::string, bool> replaced_;                          // by cycle: whether a program of its name is there
  std::map<std::pair<const Text*, std::size_t>, double> limits_;  // of FOR, by its line
  std::size_t end_line_ = 0;
  bool has_ended_ = false, may_jump_ = false;
};

}  // namespace gouge
