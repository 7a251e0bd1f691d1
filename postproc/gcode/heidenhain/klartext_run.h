#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/parallel.h"
#include "postproc/gcode/heidenhain/klartext_runner.h"

namespace gouge {

/// The order in which the blocks of a Klartext program run: labels, calls, repeats, jumps, and Q parameters.
class KlartextRun {
 public:
  /// All must outlive the object.
  KlartextRun(const ProgramInput& input, const ProgramText& text, KlartextRunner& runner, QParameters& parameters);

  /// Runs blocks in force at the start; one a line.
  void run_start(std::string_view blocks);
  /// Runs the program to its end, or until nothing after it is known.
  void run();

 private:
  /// A subprogram that runs (its return), or a section that repeats.
  struct Call {
    std::size_t back = 0;
    std::string label;
  };
  struct Repeat {
    std::size_t at = 0, depth = 0;
    int left = 0;
  };

  void find_labels();
  void read_behind_end();
  void run_block(const KlartextBlock& block);
  [[nodiscard]] bool run_flow(std::string_view text);
  void meet_label(std::string_view text);
  void call_label(std::string_view text);
  void lose_open_call();
  void repeat(const std::string& label, int times);
  void assign(std::string_view text);
  void run_function(std::string_view text);
  void jump_if(int number, std::string_view text);
  [[nodiscard]] std::optional<std::size_t> place_of(const std::string& label);
  [[nodiscard]] bool is_corner_next() const;

  const ProgramInput& input_;
  const ProgramText& text_;
  KlartextRunner& runner_;
  ProgramMotion& motion_;
  QParameters& parameters_;
  std::map<std::string, std::vector<std::size_t>> labels_;  // lines of LBL by their names
  std::vector<Call> calls_;
  std::vector<Repeat> repeats_;
  std::size_t at_ = 0, next_ = 0;
};

}  // namespace gouge
